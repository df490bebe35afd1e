package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Drawing;
import faultline.paint.surface.LineStyle;
import java.util.List;

/** The shapes of single points, told apart without colour. */
final class MarkerPainter {

    private static final double RADIUS = 3;

    private MarkerPainter() {}

    static void paint(Drawing drawing, Vector2 at, int style, ChartStyle theme) {
        LineStyle pen = LineStyle.solid(theme.series(style), 1.3);
        switch (style % 4) {
            case 0 -> drawing.fillCircle(at, RADIUS - 0.3, theme.series(style));
            case 1 ->
                drawing.drawPolyline(
                        List.of(
                                offset(at, -RADIUS, -RADIUS),
                                offset(at, RADIUS, -RADIUS),
                                offset(at, RADIUS, RADIUS),
                                offset(at, -RADIUS, RADIUS)),
                        true,
                        pen);
            case 2 ->
                drawing.drawPolyline(
                        List.of(
                                offset(at, 0, -RADIUS - 1),
                                offset(at, RADIUS + 0.6, RADIUS),
                                offset(at, -RADIUS - 0.6, RADIUS)),
                        true,
                        pen);
            default -> {
                drawing.drawPolyline(List.of(offset(at, -RADIUS, -RADIUS), offset(at, RADIUS, RADIUS)), false, pen);
                drawing.drawPolyline(List.of(offset(at, -RADIUS, RADIUS), offset(at, RADIUS, -RADIUS)), false, pen);
            }
        }
    }

    private static Vector2 offset(Vector2 centre, double x, double y) {
        return new Vector2(centre.x() + x, centre.y() + y);
    }
}
