package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.sensor.Fault;
import faultline.world.Collision;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CollisionPainterTest {

    private static final int WIDTH = 800;
    private static final Vector2 POINT = new Vector2(3.1416, 1.8714);

    @Test
    void theBadgeNamesPositionTimeAndObstacleOfTheFirstCollision() {
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", Map.of(), List.of());
        assertEquals(
                List.of("First collision   x 3.142 m   y 1.871 m   t 12.480 s   desk"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH));
    }

    @Test
    void theBadgeIsBelowTheBanner() {
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", Map.of(), List.of());
        Rectangle2D banner = new Rectangle2D.Double(0, 0, WIDTH, 54);
        assertEquals(54 + 4, topOfBadge(collision, List.of(banner)));
        assertEquals(4, topOfBadge(collision, List.of(new Rectangle2D.Double(WIDTH - 200, 0, 200, 54))));
        assertEquals(4, topOfBadge(collision, List.of()));
    }

    /** Returns the first row of pixels that the badge changes. */
    private static int topOfBadge(Collision collision, List<Rectangle2D> covered) {
        BufferedImage image = new BufferedImage(WIDTH, 200, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        Camera camera = new Camera(0, 0, 100, WIDTH, 200);
        CollisionPainter.paintBadge(
                new DrawContext(graphics, camera, Palette.LIGHT), collision, SceneLabels.ENGLISH, covered);
        graphics.dispose();
        return IntStream.range(0, image.getHeight())
                .filter(y -> IntStream.range(0, WIDTH).anyMatch(x -> image.getRGB(x, y) != 0))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void theBadgeUsesTheGivenTexts() {
        SceneLabels words = new SceneLabels(
                "Zderzenie",
                "Uszkodzone",
                "Wy\u0142\u0105czone",
                "wy\u0142.",
                kind -> "zepsuty",
                DrawContext.DEFAULT_FONT);
        Collision collision =
                new Collision(POINT, 12.48, 1248, "desk", Map.of("left", List.of(new Fault.Dead())), List.of("rear"));
        assertEquals(
                List.of(
                        "Zderzenie   x 3.142 m   y 1.871 m   t 12.480 s   desk",
                        "Uszkodzone: left zepsuty",
                        "Wy\u0142\u0105czone: rear"),
                CollisionPainter.badgeLines(collision, words));
    }

    @Test
    void theBadgeNamesTheFaultsAndTheSensorsOffAtThatTime() {
        Map<String, List<Fault>> faults =
                Map.of("left", List.of(new Fault.Stuck(0.4), new Fault.Bias(0.1)), "front", List.of(new Fault.Dead()));
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", faults, List.of("rear", "right"));
        assertEquals(
                List.of("Active faults: front off, left stuck, left bias", "Switched off: rear, right"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH).subList(1, 3));
    }
}
