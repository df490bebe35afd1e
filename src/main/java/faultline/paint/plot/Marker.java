package faultline.paint.plot;

import faultline.geometry.Vec;
import java.util.List;

/** The shapes of single points, told apart without colour. */
final class Marker {

    private static final double R = 3;

    private Marker() {
    }

    static void paint(Drawing drawing, Vec at, int style, Theme theme) {
        Pen pen = Pen.solid(theme.series(style), 1.3);
        switch (style % 4) {
            case 0 -> drawing.disc(at, R - 0.3, theme.series(style));
            case 1 -> drawing.stroke(List.of(at(at, -R, -R), at(at, R, -R), at(at, R, R), at(at, -R, R)), true, pen);
            case 2 -> drawing.stroke(List.of(at(at, 0, -R - 1), at(at, R + 0.6, R), at(at, -R - 0.6, R)), true, pen);
            default -> {
                drawing.stroke(List.of(at(at, -R, -R), at(at, R, R)), false, pen);
                drawing.stroke(List.of(at(at, -R, R), at(at, R, -R)), false, pen);
            }
        }
    }

    private static Vec at(Vec centre, double x, double y) {
        return new Vec(centre.x() + x, centre.y() + y);
    }
}
