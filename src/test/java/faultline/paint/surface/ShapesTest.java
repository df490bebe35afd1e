package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import java.awt.Color;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Shapes, rectangles and styles of lines. */
class ShapesTest {

    /** Returns the segments of a path, such as {@code M 0 0 L 1 0 Z}. */
    private static String segments(Path2D path) {
        List<String> texts = new ArrayList<>();
        double[] c = new double[6];
        for (PathIterator i = path.getPathIterator(null); !i.isDone(); i.next()) {
            int type = i.currentSegment(c);
            texts.add(
                    type == PathIterator.SEG_CLOSE
                            ? "Z"
                            : (type == PathIterator.SEG_MOVETO ? "M " : "L ") + SvgFormat.number(c[0]) + " "
                                    + SvgFormat.number(c[1]));
        }
        return String.join(" ", texts);
    }

    @Test
    void anArrowheadIsAClosedTriangleBehindItsTip() {
        assertEquals("M 10 5 L 6 8 L 6 2 Z", segments(Shapes.arrowhead(new Vector2(10, 5), new Vector2(1, 0), 4, 6)));
    }

    @Test
    void polygonsAreClosedAndLinesAreOpen() {
        List<Vector2> points = List.of(new Vector2(0, 0), new Vector2(2, 0), new Vector2(2, 1));
        assertEquals("M 0 0 L 2 0 L 2 1", segments(Shapes.polyline(points)));
        Path2D two = new Path2D.Double();
        Shapes.appendPolygon(two, points);
        Shapes.appendPolygon(two, points.subList(1, 3));
        assertEquals("M 0 0 L 2 0 L 2 1 Z M 2 0 L 2 1 Z", segments(two));
    }

    @Test
    void anInsetTakesEachMarginFromItsSide() {
        assertEquals(new PixelRectangle(11, 22, 96, 44), new PixelRectangle(10, 20, 100, 50).inset(1, 2, 3, 4));
    }

    @Test
    void aBrokenLineHasItsDashesAtAnyWidth() {
        LineStyle wide = new LineStyle(Color.RED, 1, DashPattern.DASH_DOT).withWidth(3);
        assertArrayEquals(new float[] {8, 3, 1.5f, 3}, wide.stroke().getDashArray());
        assertEquals(3, wide.stroke().getLineWidth());
        assertEquals(Color.RED, wide.colour());
    }
}
