package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import java.util.List;

/** Paints the markers of single points. Their shapes differ, so that they can be distinguished without colour. */
final class MarkerPainter {

    private static final double RADIUS = 3;

    private MarkerPainter() {}

    static void paint(Surface surface, Vector2 at, int index, ChartStyle style) {
        LineStyle line = LineStyle.solid(style.series(index), 1.3);
        switch (index % 4) {
            case 0 -> surface.fill(Shapes.circle(at, RADIUS - 0.3), style.series(index));
            case 1 ->
                surface.draw(
                        Shapes.polygon(List.of(
                                offset(at, -RADIUS, -RADIUS),
                                offset(at, RADIUS, -RADIUS),
                                offset(at, RADIUS, RADIUS),
                                offset(at, -RADIUS, RADIUS))),
                        line);
            case 2 ->
                surface.draw(
                        Shapes.polygon(List.of(
                                offset(at, 0, -RADIUS - 1),
                                offset(at, RADIUS + 0.6, RADIUS),
                                offset(at, -RADIUS - 0.6, RADIUS))),
                        line);
            default -> {
                surface.draw(Shapes.polyline(List.of(offset(at, -RADIUS, -RADIUS), offset(at, RADIUS, RADIUS))), line);
                surface.draw(Shapes.polyline(List.of(offset(at, -RADIUS, RADIUS), offset(at, RADIUS, -RADIUS))), line);
            }
        }
    }

    private static Vector2 offset(Vector2 centre, double x, double y) {
        return new Vector2(centre.x() + x, centre.y() + y);
    }
}
