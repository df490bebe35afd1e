package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.sensor.Fault;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class CollisionPainterTest {

    private static final int WIDTH = 800;
    private static final int HEIGHT = 400;
    private static final Camera CAMERA = new Camera(4, 2, 100, WIDTH, HEIGHT);
    private static final Vector2 POINT = new Vector2(3.1416, 1.8714);
    private static final MotorFaults WEAK_LEFT =
            new MotorFaults(List.of(new MotorFault.Weak(0.7), new MotorFault.DeadBand(1)), List.of());

    private final RecordingSurface drawn = new RecordingSurface();
    private final DrawContext context = new DrawContext(drawn, CAMERA, Palette.LIGHT, DrawContext.DEFAULT_FONT);

    @Test
    void theBadgeNamesPositionTimeAndObstacleOfTheFirstCollision() {
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", Map.of(), List.of(), MotorFaults.NONE);
        assertEquals(
                List.of("First collision   x 3.142 m   y 1.871 m   t 12.480 s   desk"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH));
    }

    @Test
    void zeroHasNoSignInTheBadgeWhateverTheObstacleIsCalled() {
        Vector2 point = new Vector2(-0.0004, 1.871);
        Collision collision = new Collision(point, 12.48, 1248, "desk -0.0", Map.of(), List.of(), MotorFaults.NONE);
        assertEquals(
                List.of("First collision   x 0.000 m   y 1.871 m   t 12.480 s   desk -0.0"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH));
    }

    @Test
    void aContactHasASmallRingAndTheCollisionALargeOneWithACross() {
        CollisionPainter.paint(context, collided("desk", new Pose(4, 1, 0), new Vector2(5, 2)));
        List<Rectangle2D> marks = drawn.shapes(Palette.LIGHT.collision()).stream()
                .map(mark -> mark.shape().getBounds2D())
                .toList();
        assertEquals(
                List.of(14L, 20L, 8L, 8L),
                marks.stream().map(mark -> Math.round(mark.getWidth())).toList());
        assertEquals(500, marks.get(0).getCenterX(), 1e-9);
        marks.subList(1, 4).forEach(mark -> assertEquals(100 * POINT.x(), mark.getCenterX(), 1e-9));
    }

    @Test
    void theBadgeBeginsWithADotLeftOfItsText() {
        CollisionPainter.paintBadge(context, collided("desk", new Pose(4, 1, 0)), SceneLabels.ENGLISH, List.of());
        List<RecordingSurface.DrawnShape> red = drawn.shapes(Palette.LIGHT.collision());
        Rectangle2D frame = red.get(0).shape().getBounds2D();
        Rectangle2D dot = red.get(1).shape().getBounds2D();
        assertTrue(red.get(1).filled());
        assertEquals(9, dot.getWidth(), 1e-9);
        assertEquals(frame.getCenterY(), dot.getCenterY(), 1e-9);
        String text = drawn.texts().get(0);
        double textX = Double.parseDouble(text.replaceFirst(".* at ([\\d.]+),.*", "$1"));
        assertTrue(frame.getMinX() < dot.getMinX() && dot.getMaxX() < textX, text);
    }

    @Test
    void theBadgeIsBelowTheBanner() {
        Rectangle2D banner = new Rectangle2D.Double(0, 0, WIDTH, 54);
        Pose below = new Pose(4, 1, 0);
        assertEquals(new Point(4, 54 + 4), cornerOfBadge(below, List.of(banner)));
        Rectangle2D card = new Rectangle2D.Double(WIDTH - 200, 0, 200, 54);
        assertEquals(new Point(4, 4), cornerOfBadge(below, List.of(card)));
        assertEquals(new Point(4, 4), cornerOfBadge(below, List.of()));
    }

    /** The second area begins below the first one, where the badge would be moved. */
    @Test
    void theBadgeMovesBelowAllCoveredAreas() {
        List<Rectangle2D> covered =
                List.of(new Rectangle2D.Double(0, 60, 500, 40), new Rectangle2D.Double(0, 0, 500, 50));
        Point corner = cornerOfBadge(new Pose(7, 3.6, 0), covered);
        assertTrue(corner.y > 100, corner.toString());
    }

    @Test
    void theBadgeDoesNotHideTheRobot() {
        assertEquals(new Point(4, 4), cornerOfBadge(new Pose(7, 3.6, 0), List.of()));
        Point right = cornerOfBadge(new Pose(1, 3.6, 0), List.of());
        assertEquals(4, right.y);
        assertTrue(right.x > WIDTH / 2 - 100, right.toString());
    }

    @Test
    void theBadgeStaysInThePictureWhateverTheObstacleIsCalled() {
        BufferedImage image = paintBadge("desk-".repeat(20), new Pose(4, 1, 0), List.of());
        int right = firstWhere(WIDTH, x -> isPainted(image, WIDTH - 1 - x));
        assertTrue(right >= 3 && right < 20, "the distance from the right edge of the picture is " + right);
    }

    private static boolean isPainted(BufferedImage image, int column) {
        return IntStream.range(0, HEIGHT).anyMatch(y -> image.getRGB(column, y) != 0);
    }

    /** Returns the upper left corner of the pixels that the badge changes. */
    private static Point cornerOfBadge(Pose robot, List<Rectangle2D> covered) {
        BufferedImage image = paintBadge("desk", robot, covered);
        return new Point(firstWhere(WIDTH, x -> isPainted(image, x)), firstWhere(HEIGHT, y -> IntStream.range(0, WIDTH)
                .anyMatch(x -> image.getRGB(x, y) != 0)));
    }

    /** Returns a picture of 8 m by 4 m with only the badge. */
    private static BufferedImage paintBadge(String obstacle, Pose robot, List<Rectangle2D> covered) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        CollisionPainter.paintBadge(
                new DrawContext(graphics, CAMERA, Palette.LIGHT),
                collided(obstacle, robot),
                SceneLabels.ENGLISH,
                covered);
        graphics.dispose();
        return image;
    }

    /** Returns a world in which the robot has collided, and has contacts. */
    private static Snapshot collided(String obstacle, Pose robot, Vector2... contacts) {
        Collision collision = new Collision(POINT, 12.48, 1248, obstacle, Map.of(), List.of(), MotorFaults.NONE);
        return SampleFrames.frame(
                        robot,
                        SampleFrames.pathThrough(robot.position()),
                        List.of(),
                        List.of(),
                        List.of(contacts),
                        Optional.of(collision))
                .snapshot();
    }

    private static int firstWhere(int end, IntPredicate condition) {
        return IntStream.range(0, end).filter(condition).findFirst().orElseThrow();
    }

    @Test
    void theBadgeUsesTheGivenTexts() {
        SceneLabels words = new SceneLabels(
                "Zderzenie",
                "Uszkodzone",
                "Wy\u0142\u0105czone",
                "wy\u0142.",
                side -> "silniki",
                kind -> "zepsuty",
                DrawContext.DEFAULT_FONT);
        Collision collision = new Collision(
                POINT,
                12.48,
                1248,
                "desk",
                Map.of("left", List.of(new Fault.Dead())),
                List.of("rear"),
                MotorFaults.NONE);
        assertEquals(
                List.of(
                        "Zderzenie   x 3.142 m   y 1.871 m   t 12.480 s   desk",
                        "Uszkodzone: left zepsuty",
                        "Wy\u0142\u0105czone: rear"),
                CollisionPainter.badgeLines(collision, words));
    }

    @Test
    void faultsOfMotorsAloneAreNamedToo() {
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", Map.of(), List.of(), WEAK_LEFT);
        assertEquals(
                List.of("Active faults: left motors weak, left motors dead-band"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH).subList(1, 2));
    }

    @Test
    void theBadgeNamesTheFaultsAndTheSensorsOffAtThatTime() {
        Map<String, List<Fault>> faults =
                Map.of("left", List.of(new Fault.Stuck(0.4), new Fault.Bias(0.1)), "front", List.of(new Fault.Dead()));
        Collision collision = new Collision(POINT, 12.48, 1248, "desk", faults, List.of("rear", "right"), WEAK_LEFT);
        assertEquals(
                List.of(
                        "Active faults: front off, left stuck, left bias, left motors weak, left motors dead-band",
                        "Switched off: rear, right"),
                CollisionPainter.badgeLines(collision, SceneLabels.ENGLISH).subList(1, 3));
    }
}
