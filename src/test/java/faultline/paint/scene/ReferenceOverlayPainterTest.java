package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SampleFrames;
import faultline.engine.SimulationSetup;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Snapshot;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReferenceOverlayPainterTest {

    private static final int WIDTH = 800;
    private static final int HEIGHT = 500;
    private static final Rectangle PICTURE = new Rectangle(WIDTH, HEIGHT);

    @Test
    void theCaptionLeavesTheScaleBarVisible() {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        DrawContext context = new DrawContext(graphics, new Camera(0, 8, 60, WIDTH, HEIGHT), Palette.LIGHT);
        context.fill(PICTURE, Palette.LIGHT.canvas());
        ScaleBarPainter.paint(context);
        Rectangle bar = ScaleBarPainter.area(context).getBounds();
        int[] before = pixels(image, bar);
        int[] above = pixels(image, aboveOf(bar));
        ReferenceOverlayPainter.paintAnnotations(
                context,
                SampleReferenceOverlays.office(),
                SampleFrames.frameOf(new Pose(1, 6, 0)).snapshot(),
                new CornerChoice(CornerChoice.Corner.LOWER_RIGHT),
                List.of());
        graphics.dispose();
        assertArrayEquals(before, pixels(image, bar));
        assertFalse(Arrays.equals(above, pixels(image, aboveOf(bar))), "the caption is above the bar");
    }

    /** Returns a ghost of the office, whose robot has another length and width in metres. */
    private static ReferenceOverlay ghostOf(double size, long ticks) throws ScenarioException {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        RobotSpec robot = office.robot().withPlatform(size, size, office.robot().speed());
        Journal journal = new Journal(office.withRobot(robot), List.of(), ticks);
        return new ReferenceOverlay(ReferenceRun.replay(journal, tick -> true), List.of("Ghost"), List.of());
    }

    @Test
    void theRobotOfAGhostHasTheSizeThatItHasAtTheTime() throws ScenarioException {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        SimulationSetup shrinking = office.withTimeline(
                List.of(new SimulationSetup.TimedCommand(0.5, new Command.SetPlatform(0.1, 0.08, 0.3))));
        ReferenceRun run = ReferenceRun.replay(new Journal(shrinking, List.of(), 100), tick -> true);
        ReferenceOverlay ghost = new ReferenceOverlay(run, List.of("Ghost"), List.of());
        assertEquals(office.robot(), ghost.robotAt(0.49));
        assertEquals(0.1, ghost.robotAt(0.5).length());
        assertEquals(0.08, ghost.robotAt(30).width());
        Pose pose = run.pose(100);
        Camera camera = new Camera(pose.x(), pose.y(), 300, WIDTH, HEIGHT);
        Snapshot world = officeAt(100);
        Rectangle area = painted(camera, context -> ReferenceOverlayPainter.paintRobot(context, ghost, world));
        double turned = 30 * Math.abs(Math.cos(pose.heading())) + 24 * Math.abs(Math.sin(pose.heading()));
        assertEquals(turned, area.width, 5, "0.1 x 0.08 m at 300 pixels per metre, and the width of the line");
    }

    @Test
    void theFirstCollisionOfAGhostIsMarkedWhereItHappened() throws ScenarioException {
        SimulationSetup office = Scenario.loadShipped("office.xml").setup();
        SimulationSetup straight = office.withController(new ControllerSpec.Drive(6, 6));
        ReferenceRun run = ReferenceRun.replay(new Journal(straight, List.of(), 3000), tick -> true);
        ReferenceOverlay ghost = new ReferenceOverlay(run, List.of("Ghost"), List.of());
        Collision collision = run.collision().orElseThrow();
        Camera camera = new Camera(collision.point().x(), collision.point().y(), 100, WIDTH, HEIGHT);
        Snapshot world = officeAt(0);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        DrawContext context = new DrawContext(graphics, camera, Palette.LIGHT);
        context.fill(PICTURE, Palette.LIGHT.canvas());
        ReferenceOverlayPainter.paintAnnotations(
                context, ghost, world, ReferenceOverlayPainter.createCornerChoice(), List.of());
        graphics.dispose();
        assertEquals(Palette.LIGHT.reference().getRGB(), image.getRGB(WIDTH / 2, HEIGHT / 2));
    }

    private static Snapshot officeAt(long tick) throws ScenarioException {
        Journal journal = new Journal(Scenario.loadShipped("office.xml").setup(), List.of(), tick);
        try (Session session = Session.replay(journal, tick, reached -> true)) {
            return session.frame().snapshot();
        }
    }

    /** Returns the pixels that a painter changes in an empty picture. */
    private static Rectangle painted(Camera camera, Consumer<DrawContext> painter) {
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        DrawContext context = new DrawContext(graphics, camera, Palette.LIGHT);
        context.fill(PICTURE, Palette.LIGHT.canvas());
        painter.accept(context);
        graphics.dispose();
        Rectangle area = new Rectangle(-1, -1);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (image.getRGB(x, y) != Palette.LIGHT.canvas().getRGB()) {
                    area.add(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return area;
    }

    @Test
    void theGhostHasTheSizeOfItsOwnRobot() throws ScenarioException {
        ReferenceOverlay ghost = ghostOf(0.1, 0);
        Snapshot world = officeAt(0);
        Camera camera = new Camera(world.pose().x(), world.pose().y(), 300, WIDTH, HEIGHT);
        Rectangle area = painted(camera, context -> ReferenceOverlayPainter.paintRobot(context, ghost, world));
        double heading = world.pose().heading();
        double turned = 30 * (Math.abs(Math.cos(heading)) + Math.abs(Math.sin(heading)));
        assertEquals(turned, area.width, 5, "0.1 m at 300 pixels per metre, and the width of the line");
    }

    @Test
    void theLabelOfAMarkAtTheEdgeStaysInThePicture() {
        ReferenceOverlay office = SampleReferenceOverlays.office();
        Vector2 place = office.run().pose(1000).position();
        RecordingSurface drawn = new RecordingSurface();
        Camera camera = new Camera(place.x() + (WIDTH / 2.0 - 10) / 60, place.y(), 60, WIDTH, HEIGHT);
        ReferenceOverlayPainter.paintAnnotations(
                new DrawContext(drawn, camera, Palette.LIGHT, DrawContext.DEFAULT_FONT),
                office,
                SampleFrames.frameOf(new Pose(1, 6, 0)).snapshot(),
                ReferenceOverlayPainter.createCornerChoice(),
                List.of());
        String label = drawn.texts().get(0);
        assertTrue(label.startsWith("differs from 10 s"), label);
        double left = Double.parseDouble(label.replaceFirst(".* at ", "").replaceFirst(",.*", ""));
        assertTrue(left >= 0 && left < 10, label);
    }

    @Test
    void aMarkIsOnThePathWithItsLabelAboveAndTheCaptionHasAllItsLines() {
        ReferenceOverlay office = SampleReferenceOverlays.office();
        Vector2 place = office.run().pose(1000).position();
        RecordingSurface drawn = new RecordingSurface();
        Camera camera = new Camera(place.x(), place.y(), 60, WIDTH, HEIGHT);
        DrawContext context = new DrawContext(drawn, camera, Palette.LIGHT, DrawContext.DEFAULT_FONT);
        Snapshot world = SampleFrames.frameOf(new Pose(1, 6, 0)).snapshot();
        ReferenceOverlayPainter.paintAnnotations(
                context, office, world, ReferenceOverlayPainter.createCornerChoice(), List.of());
        List<String> diamond = drawn.shapes(Palette.LIGHT.reference()).stream()
                .map(Object::toString)
                .limit(2)
                .toList();
        assertEquals(
                List.of("392.0,250.0 400.0,242.0 408.0,250.0 400.0,258.0 closed", "396.0,254.0 404.0,246.0"), diamond);
        List<String> texts = drawn.texts();
        assertEquals(
                List.of("differs from 10 s", "Ghost: Office", "Differs from 10 s on"),
                texts.stream().map(text -> text.replaceFirst(" at .*", "")).toList());
        double baseline = Double.parseDouble(texts.get(0).replaceFirst(".*,", ""));
        assertTrue(baseline > 225 && baseline < 242, texts::toString);
    }

    @Test
    void theGhostHasAnArrowAheadOfItsMiddle() throws ScenarioException {
        ReferenceOverlay ghost = ghostOf(0.2, 300);
        Pose pose = ghost.run().pose(300);
        RecordingSurface drawn = new RecordingSurface();
        Camera camera = new Camera(pose.x(), pose.y(), 500, WIDTH, HEIGHT);
        ReferenceOverlayPainter.paintRobot(
                new DrawContext(drawn, camera, Palette.LIGHT, DrawContext.DEFAULT_FONT), ghost, officeAt(300));
        Vector2 tip = camera.toScreen(pose.toParent(new Vector2(0.06, 0)));
        String text = Math.round(tip.x() * 10) / 10.0 + "," + Math.round(tip.y() * 10) / 10.0;
        assertEquals(text, drawn.shapes().get(1).split(" ")[1]);
    }

    /** The quotient of 0.29 s and the tick of 0.01 s is less than 29. */
    @Test
    void theGhostIsWhereItsRobotWasAtTheSameTick() throws ScenarioException {
        ReferenceOverlay ghost = ghostOf(0.2, 300);
        double dt = ghost.run().setup().dt();
        for (int tick = 0; tick <= 300; tick++) {
            assertEquals(ghost.run().pose(tick), ghost.poseAt(tick * dt), "tick " + tick);
        }
    }

    @Test
    void theGhostMovesWithTheTimeOfTheRun() throws ScenarioException {
        ReferenceOverlay ghost = ghostOf(0.2, 300);
        for (long tick : new long[] {0, 300}) {
            Snapshot world = officeAt(tick);
            Vector2 position = ghost.run().pose(tick).position();
            Camera camera = new Camera(position.x(), position.y(), 200, WIDTH, HEIGHT);
            Rectangle area = painted(camera, context -> ReferenceOverlayPainter.paintRobot(context, ghost, world));
            assertEquals(WIDTH / 2.0, area.getCenterX(), 2, "at tick " + tick);
            assertEquals(HEIGHT / 2.0, area.getCenterY(), 2, "at tick " + tick);
        }
        assertTrue(
                ghost.run().pose(300).position().distanceTo(ghost.run().pose(0).position()) > 0.3,
                "the robot has moved");
    }

    /**
     * The ghost stands 300 pixels from the middle of the picture, so only a ghost of more than a metre is in a corner.
     */
    @Test
    void theCaptionLeavesTheWholeGhostVisible() throws ScenarioException {
        Snapshot world = officeAt(0);
        Camera camera = new Camera(world.pose().x() + 1, world.pose().y() + 1.2, 100, WIDTH, HEIGHT);
        Rectangle corner = new Rectangle(0, HEIGHT - 60, 200, 60);
        for (double size : new double[] {0.2, 2}) {
            ReferenceOverlay ghost = ghostOf(size, 0);
            Rectangle caption = painted(
                    camera,
                    context -> ReferenceOverlayPainter.paintAnnotations(
                            context, ghost, world, ReferenceOverlayPainter.createCornerChoice(), List.of()));
            assertEquals(size < 1, caption.intersects(corner), "a ghost of " + size + " m: " + caption);
        }
    }

    /** In the second picture, the name may be as wide as the other line, which is wider than half of the picture. */
    @ParameterizedTest
    @CsvSource({"800, 400", "340, 324", "120, 104"})
    void theCaptionOfALongNameStaysInThePicture(int width, int maxWidth) throws ScenarioException {
        ReferenceRun run = ghostOf(0.2, 0).run();
        ReferenceOverlay ghost = new ReferenceOverlay(
                run, List.of("Ghost: " + "long ".repeat(40), "Differs from this run from 10.00 s on"), List.of());
        Snapshot world = officeAt(0);
        Camera camera = new Camera(world.pose().x() + 20, world.pose().y(), 100, width, HEIGHT);
        Rectangle caption = painted(
                camera,
                context -> ReferenceOverlayPainter.paintAnnotations(
                        context, ghost, world, ReferenceOverlayPainter.createCornerChoice(), List.of()));
        assertTrue(caption.getMaxX() <= width - 4, caption + " is not in the picture");
        assertTrue(caption.width <= maxWidth, caption + " is wide");
        assertTrue(caption.width >= maxWidth * 0.7, caption + " is narrow");
    }

    private static Rectangle aboveOf(Rectangle bar) {
        return new Rectangle(bar.x, bar.y - 20, bar.width, 20);
    }

    private static int[] pixels(BufferedImage image, Rectangle area) {
        return image.getRGB(area.x, area.y, area.width, area.height, null, 0, area.width);
    }
}
