package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The inside of solid shapes against {@link java.awt.geom}, and the circles about them. */
class ShapeInteriorTest {

    private static final int POINTS = 2000;

    private final SplittableRandom random = new SplittableRandom(77);

    private List<Vector2> vertices(int number) {
        List<Vector2> vertices = new ArrayList<>();
        for (int i = 0; i < number; i++) {
            vertices.add(new Vector2(random.nextDouble(-1, 1), random.nextDouble(-1, 1)));
        }
        return vertices;
    }

    private static Shape path(List<Vector2> vertices) {
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        path.moveTo(vertices.get(0).x(), vertices.get(0).y());
        vertices.subList(1, vertices.size()).forEach(vertex -> path.lineTo(vertex.x(), vertex.y()));
        path.closePath();
        return path;
    }

    @Test
    void aPointIsInsideIfJavaSaysSo() {
        for (int i = 0; i < 20; i++) {
            List<Vector2> vertices = vertices(3 + i % 5);
            Map<ObstacleShape, Shape> shapes = Map.of(
                    new ObstacleShape.PolygonShape(vertices), path(vertices),
                    new ObstacleShape.RectangleShape(1.4, 0.6), new Rectangle2D.Double(-0.7, -0.3, 1.4, 0.6),
                    new ObstacleShape.CircleShape(0.8), new Ellipse2D.Double(-0.8, -0.8, 1.6, 1.6),
                    new ObstacleShape.EllipseShape(0.9, 0.4), new Ellipse2D.Double(-0.9, -0.4, 1.8, 0.8));
            for (int n = 0; n < POINTS; n++) {
                Vector2 point = new Vector2(random.nextDouble(-1.2, 1.2), random.nextDouble(-1.2, 1.2));
                shapes.forEach((shape, expected) -> assertEquals(
                        expected.contains(point.x(), point.y()), shape.contains(point), () -> shape + " " + point));
            }
        }
    }

    @Test
    void theCircleAboutAShapeGoesThroughItsFarthestPoint() {
        assertEquals(2.5, new ObstacleShape.RectangleShape(3, 4).boundingRadius(), 1e-15);
        assertEquals(0.9, new ObstacleShape.EllipseShape(0.4, 0.9).boundingRadius());
        assertEquals(0.3, new ObstacleShape.CircleShape(0.3).boundingRadius());
        List<Vector2> triangle = List.of(new Vector2(0, 0), new Vector2(3, 4), new Vector2(-1, 2));
        assertEquals(5, new ObstacleShape.PolygonShape(triangle).boundingRadius());
    }
}
