package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.RobotPath;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.RecordingSurface;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.Collision;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.WaypointPath;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pixels of frames painted without a display. The world is 6 m x 4 m at about 142 pixels per metre. */
class ScenePainterTest {

    private static final Pose AT_2_1 = new Pose(2, 1, 0);
    private static final Palette LIGHT = Palette.LIGHT;
    /** Looks along the x axis from (2, 1), 0.8 m far. */
    private static final SensorSpec FRONT = new SensorSpec("front", Vector2.ZERO, 0, 0.8, 0.5, true, 0);

    @Test
    void theRobotIsPaintedAtItsPositionAndYPointsUp() {
        Pixels pixels = Pixels.render(SampleFrames.frameOf(AT_2_1), LIGHT);
        pixels.assertColour(LIGHT.robot(), new Vector2(2, 1));
        assertFalse(pixels.hasNear(LIGHT.robot(), new Vector2(2, 3), 10), "nothing at the mirrored position");
    }

    @Test
    void theRobotsFrontTurnsWithItsHeading() {
        Pixels ahead = Pixels.render(SampleFrames.frameOf(AT_2_1), LIGHT);
        Pixels up = Pixels.render(SampleFrames.frameOf(new Pose(2, 1, Math.PI / 2)), LIGHT);
        assertTrue(ahead.hasNear(LIGHT.robotOutline(), new Vector2(2.112, 1), 0));
        assertTrue(up.hasNear(LIGHT.robotOutline(), new Vector2(2, 1.112), 0));
        assertFalse(up.hasNear(LIGHT.robotOutline(), new Vector2(2, 0.9), 0), "the rear has no bar");
    }

    @ParameterizedTest
    @ValueSource(ints = {100, 900})
    void aRingSurroundsTheRobotHoweverSmallItIs(int width) {
        Frame frame = SampleFrames.frameOf(AT_2_1);
        int height = FrameRenderer.heightFor(frame, width);
        Camera camera = FrameRenderer.fitCamera(frame.snapshot(), width, height);
        BufferedImage image = FrameRenderer.render(frame, LIGHT, width, height);
        int y = (int) camera.toScreen(AT_2_1.position()).y();
        int platform = (int) camera.toScreen(new Vector2(1.8, 1)).x();
        long behind = IntStream.range(platform - 25, platform)
                .filter(x -> Pixels.isSimilar(LIGHT.robot(), new Color(image.getRGB(x, y))))
                .count();
        assertTrue(behind >= 1 && behind <= 4, behind + " pixels of the ring");
    }

    @ParameterizedTest
    @CsvSource({"200, 0, true", "200, 90, true", "200, -90, true", "900, 0, false"})
    void anArrowheadOnTheRingShowsWhereASmallRobotIsHeading(int width, double heading, boolean small) {
        Pose pose = new Pose(2, 1, Math.toRadians(heading));
        Frame frame = SampleFrames.frameOf(pose);
        int height = FrameRenderer.heightFor(frame, width);
        Camera camera = FrameRenderer.fitCamera(frame.snapshot(), width, height);
        BufferedImage image = FrameRenderer.render(frame, LIGHT, width, height);
        Vector2 centre = camera.toScreen(pose.position());
        double ring = camera.scale() * Math.hypot(0.25, 0.2) / 2 + 11;
        Vector2 ahead = new Vector2(Math.cos(pose.heading()), -Math.sin(pose.heading()));
        assertEquals(small, isOutline(image, centre.plus(ahead.times(ring))));
        assertFalse(isOutline(image, centre.minus(ahead.times(ring))));
    }

    private static boolean isOutline(BufferedImage image, Vector2 at) {
        return Pixels.isSimilar(
                LIGHT.robotOutline(), new Color(image.getRGB((int) Math.round(at.x()), (int) Math.round(at.y()))));
    }

    @ParameterizedTest
    @ValueSource(ints = {480, 1200})
    void theScaleBarOverlapsNothing(int width) {
        Frame frame = SampleFrames.frameOf(AT_2_1);
        int height = FrameRenderer.heightFor(frame, width);
        Camera camera = FrameRenderer.fitCamera(frame.snapshot(), width, height);
        Set<Layer> others = EnumSet.complementOf(EnumSet.of(Layer.SCALE_BAR));
        BufferedImage with = new RenderRequest(frame, camera, LIGHT, EnumSet.allOf(Layer.class)).toImage(1);
        BufferedImage without = new RenderRequest(frame, camera, LIGHT, others).toImage(1);
        int bottomOfBand = (int) Math.ceil(camera.toScreen(Vector2.ZERO).y() + BoundsPainter.BAND_WIDTH);
        int bar = height - bottomOfBand;
        assertEquals(
                0,
                Pixels.countVisiblyDifferent(
                        with.getSubimage(0, 0, width, bottomOfBand), without.getSubimage(0, 0, width, bottomOfBand)));
        assertTrue(Pixels.countVisiblyDifferent(
                        with.getSubimage(0, bottomOfBand, width, bar), without.getSubimage(0, bottomOfBand, width, bar))
                > 60);
    }

    static Frame withMotorFaults(Pose pose, MotorFaults faults) {
        Frame frame = SampleFrames.frameOf(pose);
        Snapshot world = frame.snapshot();
        return new Frame(
                new Snapshot(
                        world.tick(),
                        world.time(),
                        world.width(),
                        world.height(),
                        world.enclosed(),
                        world.robot(),
                        world.pose(),
                        world.wheelSpeeds(),
                        faults,
                        world.sensors(),
                        world.obstacles(),
                        world.contacts(),
                        world.collisions()),
                frame.telemetry(),
                frame.leftVolts(),
                frame.rightVolts(),
                frame.path(),
                frame.trajectoryHash());
    }

    /** The contact colour marks a faulty wheel, at the left when the robot looks along the x axis above. */
    @ParameterizedTest
    @EnumSource(MotorFaultKind.class)
    void theWheelsOfTheFaultySideAreMarked(MotorFaultKind kind) {
        MotorFaults left = new MotorFaults(List.of(kind.createFault(kind.defaultValue())), List.of());
        Pixels pixels = Pixels.render(withMotorFaults(AT_2_1, left), LIGHT);
        for (double ahead : new double[] {-0.0675, 0.0675}) {
            assertTrue(pixels.hasNear(LIGHT.contact(), new Vector2(2 + ahead, 1.084), 3), "left, " + ahead);
            assertFalse(pixels.hasNear(LIGHT.contact(), new Vector2(2 + ahead, 0.916), 3), "right, " + ahead);
            assertTrue(pixels.hasNear(LIGHT.robotOutline(), new Vector2(2 + ahead, 0.916), 1), "right, " + ahead);
        }
    }

    @Test
    void everyKindOfMotorFaultHasAnotherHatchingAndItsNameBesideTheRobot() {
        Set<Integer> pictures = new HashSet<>();
        for (MotorFaultKind kind : MotorFaultKind.values()) {
            MotorFaults right = new MotorFaults(List.of(), List.of(kind.createFault(kind.defaultValue())));
            BufferedImage image = FrameRenderer.render(withMotorFaults(AT_2_1, right), LIGHT, 900, 600);
            Camera camera = FrameRenderer.fitCamera(SampleFrames.frameOf(AT_2_1).snapshot(), 900, 600);
            Vector2 centre = camera.toScreen(AT_2_1.position());
            int half = (int) (0.125 * camera.scale());
            int[] robot = image.getRGB(
                    (int) centre.x() - half, (int) centre.y() - half, 2 * half, 2 * half, null, 0, 2 * half);
            pictures.add(Arrays.hashCode(robot));
            DrawContext context = new DrawContext(image.createGraphics(), camera, LIGHT);
            assertEquals(
                    List.of("right motors: " + kind.fileName()),
                    MotorFaultPainter.labels(
                                    context, withMotorFaults(AT_2_1, right).snapshot(), SceneLabels.ENGLISH, List.of())
                            .stream()
                            .map(MotorFaultPainter.SideLabel::text)
                            .toList());
        }
        assertEquals(MotorFaultKind.values().length, pictures.size());
    }

    /** A side that drives less and starts late still drives. */
    @Test
    void severalFaultsOfASideDoNotLookLikeADeadOne() {
        MotorFault weak = MotorFaultKind.WEAK.createFault(0.7);
        MotorFault late = MotorFaultKind.DEAD_BAND.createFault(0.5);
        MotorFault dead = new MotorFault.NoDrive();
        BufferedImage both = FrameRenderer.render(
                withMotorFaults(AT_2_1, new MotorFaults(List.of(weak, late), List.of())), LIGHT, 900, 600);
        BufferedImage none = FrameRenderer.render(
                withMotorFaults(AT_2_1, new MotorFaults(List.of(dead), List.of())), LIGHT, 900, 600);
        Camera camera = FrameRenderer.fitCamera(SampleFrames.frameOf(AT_2_1).snapshot(), 900, 600);
        Vector2 wheel = camera.toScreen(new Vector2(2.0675, 1.084));
        int differing = 0;
        for (int x = -5; x <= 5; x++) {
            for (int y = -4; y <= 4; y++) {
                int column = (int) wheel.x() + x;
                int row = (int) wheel.y() + y;
                differing += both.getRGB(column, row) == none.getRGB(column, row) ? 0 : 1;
            }
        }
        assertTrue(differing > 10, differing + " pixels differ");
    }

    @Test
    void theLabelsOfMotorsCoverNoOtherLabels() {
        MotorFaults faults = new MotorFaults(
                List.of(MotorFaultKind.WEAK.createFault(0.7)), List.of(MotorFaultKind.WEAK.createFault(0.7)));
        Snapshot world = withMotorFaults(AT_2_1, faults).snapshot();
        Camera camera = FrameRenderer.fitCamera(world, 900, 600);
        BufferedImage image = new BufferedImage(900, 600, BufferedImage.TYPE_INT_RGB);
        DrawContext context = new DrawContext(image.createGraphics(), camera, LIGHT);
        List<Rectangle2D> beside = boxes(context, world, List.of());
        Vector2 robot = camera.toScreen(AT_2_1.position());
        assertTrue(beside.get(0).getMaxY() < robot.y() && beside.get(1).getMinY() > robot.y());
        List<Rectangle2D> others = List.of(
                beside.get(0), new Rectangle2D.Double(robot.x(), beside.get(1).getMinY(), 5, 30));
        List<Rectangle2D> moved = boxes(context, world, others);
        assertTrue(moved.stream().noneMatch(box -> others.stream().anyMatch(box::intersects)), moved.toString());
        assertFalse(moved.get(0).intersects(moved.get(1)));
        assertTrue(moved.get(0).getMaxY() <= beside.get(0).getMinY());
    }

    @Test
    void theMotorsOfARobotOutsideThePictureHaveNoLabel() {
        MotorFaults faults = new MotorFaults(List.of(new MotorFault.NoDrive()), List.of());
        Snapshot world = withMotorFaults(AT_2_1, faults).snapshot();
        Camera camera = FrameRenderer.fitCamera(world, 900, 600);
        BufferedImage image = new BufferedImage(900, 600, BufferedImage.TYPE_INT_RGB);
        double halo = RobotPainter.haloRadius(new DrawContext(image.createGraphics(), camera, LIGHT), world.robot());
        double left = camera.toScreen(AT_2_1.position()).x();
        for (double inside : new double[] {2, -2}) {
            Camera panned = camera.panned(inside - halo - left, 0);
            DrawContext context = new DrawContext(image.createGraphics(), panned, LIGHT);
            assertEquals(inside > 0 ? 1 : 0, boxes(context, world, List.of()).size());
        }
    }

    private static List<Rectangle2D> boxes(DrawContext context, Snapshot world, List<Rectangle2D> others) {
        return MotorFaultPainter.labels(context, world, SceneLabels.ENGLISH, others).stream()
                .map(MotorFaultPainter.SideLabel::box)
                .toList();
    }

    @Test
    void aDarkPictureHasDifferentColours() {
        Pixels dark = Pixels.render(SampleFrames.frameOf(AT_2_1), Palette.DARK);
        dark.assertColour(Palette.DARK.robot(), new Vector2(2, 1));
        assertEquals(Palette.DARK.canvas(), dark.colourAt(new Vector2(3, 2), 3, 3));
        assertEquals(
                LIGHT.canvas(),
                Pixels.render(SampleFrames.frameOf(AT_2_1), LIGHT).colourAt(new Vector2(3, 2), 3, 3));
    }

    @Test
    void thePathIsVisibleAndEndsAtTheRobot() {
        RobotPath path = SampleFrames.pathThrough(new Vector2(1, 3), new Vector2(1, 2), new Vector2(4, 2));
        Pixels pixels = Pixels.render(SampleFrames.frameOf(new Pose(5, 2, 0), path, List.of()), LIGHT);
        for (Vector2 point : List.of(new Vector2(1, 2.5), new Vector2(2.5, 2), new Vector2(4.5, 2))) {
            assertTrue(pixels.hasNear(LIGHT.path(), point, 1), "at " + point);
        }
    }

    @Test
    void aRingOfTheSensorsColourSurroundsAnIntersectionAndLeavesItsCentreFree() {
        Vector2 hit = new Vector2(4, 3);
        Frame frame = SampleFrames.frameOf(
                AT_2_1,
                SampleFrames.pathThrough(AT_2_1.position()),
                List.of(SampleFrames.sensor(FRONT, AT_2_1, SampleFrames.NOTHING, hit)));
        Pixels pixels = Pixels.render(frame, LIGHT);
        int radius = (int) IntersectionPainter.RING_RADIUS;
        assertTrue(pixels.hasNear(LIGHT.sensorColours(0).outline(), hit, radius));
        assertFalse(pixels.hasNear(LIGHT.sensorColours(0).outline(), hit, radius - 3));
    }

    @Test
    void everyShapeIsFilledOnlyInside() {
        Pixels pixels = Pixels.render(
                SampleFrames.frameOf(
                        AT_2_1,
                        new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.2), new Pose(4, 3, Math.PI / 2)),
                        new Obstacle("disc", new ObstacleShape.CircleShape(0.3), new Pose(1, 3, 0)),
                        new Obstacle(
                                "wedge",
                                new ObstacleShape.PolygonShape(
                                        List.of(new Vector2(0, 0), new Vector2(1, 0), new Vector2(0, 1))),
                                new Pose(4.5, 0.5, 0))),
                LIGHT);
        for (Vector2 inside : List.of(new Vector2(4, 3.4), new Vector2(1.2, 3), new Vector2(4.7, 0.7))) {
            pixels.assertColour(LIGHT.obstacle(), inside);
        }
        for (Vector2 beside : List.of(new Vector2(4.4, 3), new Vector2(1.27, 3.27), new Vector2(5.2, 1.2))) {
            assertNotEquals(LIGHT.obstacle(), pixels.colourAt(beside, 0, 0), "at " + beside);
        }
    }

    @Test
    void aWallIsVisibleAlthoughItHasNoThickness() {
        Obstacle wall = new Obstacle(
                "wall", new ObstacleShape.WallShape(List.of(new Vector2(0, 0), new Vector2(2, 0))), new Pose(3, 3, 0));
        Pixels.render(SampleFrames.frameOf(AT_2_1, wall), LIGHT)
                .assertColour(LIGHT.obstacleOutline(), new Vector2(4, 3));
    }

    @Test
    void aGlossyWallIsABrightLineBetweenTwoDarkOnes() {
        ObstacleShape wall = new ObstacleShape.WallShape(List.of(new Vector2(0, -1), new Vector2(0, 1)));
        Obstacle mirror = new Obstacle("mirror", wall, new Pose(4, 2, 0), WaypointPath.NONE, 0.2);
        Pixels pixels = Pixels.render(SampleFrames.frameOf(AT_2_1, mirror), LIGHT);
        Vector2 place = new Vector2(4, 2.6);
        assertTrue(pixels.hasNear(LIGHT.obstacleOutline(), place, 3), "its edge");
        assertTrue(pixels.hasNear(LIGHT.canvas(), place, 1), "its gloss");
    }

    @Test
    void aMovingObstacleHasItsOwnOutlineAndShowsItsRoute() {
        WaypointPath motion = new WaypointPath(0.2, false, List.of(new Vector2(3, 3), new Vector2(5, 3)));
        Pixels pixels = Pixels.render(
                SampleFrames.frameOf(
                        AT_2_1, new Obstacle("visitor", new ObstacleShape.CircleShape(0.3), new Pose(4, 2, 0), motion)),
                LIGHT);
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vector2(4.3, 2), 2));
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vector2(3, 3), 1), "a waypoint");
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vector2(4.2, 3), 10), "the arrow");
    }

    /** The leg is ahead of the robot, where the sensor looks; its speed would be at the end of the cone. */
    @ParameterizedTest
    @ValueSource(doubles = {1.4, 1.5, 1.6, 1.7, 1.8, 1.9})
    void theSpeedOfARouteAndTheLabelOfASensorAreBeside(double y) {
        Pose robot = new Pose(2, y, 0);
        WaypointPath motion = new WaypointPath(0.2, false, List.of(new Vector2(2.8, 2.5), new Vector2(2.8, 0.7)));
        Obstacle visitor = new Obstacle("visitor", new ObstacleShape.CircleShape(0.1), new Pose(5, 3, 0), motion);
        SensorSnapshot off = SampleFrames.faultySensor(
                FRONT, robot, new Reading(0.5), new Reading(Reading.OFF), FaultKind.OFF.createFault(0));
        Frame frame = SampleFrames.frameOf(robot, SampleFrames.pathThrough(robot.position()), List.of(off), visitor);
        RecordingSurface drawn = new RecordingSurface();
        DrawContext context = new DrawContext(
                drawn, FrameRenderer.fitCamera(frame.snapshot(), 900, 600), LIGHT, DrawContext.DEFAULT_FONT);
        new ScenePainter(EnumSet.allOf(Layer.class), SceneLabels.ENGLISH).paint(context, frame, List.of());
        Rectangle2D speed = box(context, drawn, "0.20 m/s");
        Rectangle2D sensor = box(context, drawn, "1 off");
        assertFalse(speed.intersects(sensor), speed + " covers " + sensor);
    }

    /** Returns the box of a text that was drawn. */
    private static Rectangle2D box(DrawContext context, RecordingSurface drawn, String text) {
        String[] place = drawn.texts().stream()
                .filter(one -> one.startsWith(text + " at "))
                .findFirst()
                .orElseThrow()
                .substring(text.length() + 4)
                .split(",");
        Rectangle2D size = context.measureText(text);
        return new Rectangle2D.Double(
                Double.parseDouble(place[0]) + size.getX(),
                Double.parseDouble(place[1]) + size.getY(),
                size.getWidth(),
                size.getHeight());
    }

    @Test
    void theFirstCollisionIsMarkedAndDescribedInABadge() {
        Vector2 point = new Vector2(4, 3);
        Collision collision = new Collision(point, 1.5, 150, "box", Map.of(), List.of(), MotorFaults.NONE);
        RobotPath path = SampleFrames.pathThrough(AT_2_1.position());
        Frame frame = SampleFrames.frame(AT_2_1, path, List.of(), List.of(), List.of(point), Optional.of(collision));
        Pixels.render(frame, LIGHT).assertColour(LIGHT.collision(), point);
        BufferedImage plain = FrameRenderer.render(SampleFrames.frameOf(AT_2_1), LIGHT, 900, 640)
                .getSubimage(0, 0, 200, 30);
        BufferedImage badged = FrameRenderer.render(frame, LIGHT, 900, 640).getSubimage(0, 0, 200, 30);
        assertTrue(Pixels.countDifferent(plain, badged) > 200, "no badge in the corner");
    }

    @Test
    void theReportedDistanceIsAnArcAcrossTheCone() {
        Pixels pixels = Pixels.render(withSensor(SampleFrames.sensor(FRONT, AT_2_1, new Reading(0.5))), LIGHT);
        pixels.assertColour(LIGHT.sensorColours(0).outline(), new Vector2(2.5, 1));
        assertNotEquals(LIGHT.sensorColours(0).outline(), pixels.colourAt(new Vector2(2.4, 1), 0, 0));
    }

    @Test
    void aFaultySensorShowsTheTrueDistanceToo() {
        SensorSnapshot stuck = SampleFrames.faultySensor(
                FRONT, AT_2_1, new Reading(0.6), new Reading(0.3), FaultKind.STUCK.createFault(0.3));
        Pixels pixels = Pixels.render(withSensor(stuck), LIGHT);
        assertTrue(pixels.hasNear(LIGHT.sensorColours(0).outline(), new Vector2(2.3, 1), 1));
        assertTrue(pixels.hasNear(LIGHT.text(), new Vector2(2.6, 1), 5));
    }

    @Test
    void theFirstOfSeveralFaultsOfASensorIsNamed() {
        Frame frame = withSensor(SampleFrames.faultySensor(
                FRONT,
                AT_2_1,
                new Reading(0.6),
                new Reading(0.5),
                FaultKind.STUCK.createFault(0.3),
                FaultKind.BIAS.createFault(0.1),
                FaultKind.BIAS.createFault(0.1)));
        assertTrue(conesOf(frame).contains(">1 stuck +1<"), "each kind once");
    }

    private static String conesOf(Frame frame) {
        return new RenderRequest(
                        frame, FrameRenderer.fitCamera(frame.snapshot(), 900, 640), LIGHT, EnumSet.of(Layer.CONES))
                .toSvg();
    }

    /** On a circle of 125 pixels, the numbers of 8 sensors are 96 pixels apart, and those of 64 only 12. */
    @ParameterizedTest
    @CsvSource({"8, 8, 8", "64, 21, 43"})
    void aNumberThatWouldOverlapAnotherIsOmitted(int sensors, int fewest, int most) {
        List<SensorSnapshot> around = IntStream.range(0, sensors)
                .mapToObj(i -> new SensorSpec("s" + i, Vector2.ZERO, 2 * Math.PI * i / sensors, 0.8, 0.05, true, 0))
                .map(spec -> SampleFrames.sensor(spec, AT_2_1, SampleFrames.NOTHING))
                .toList();
        String svg = conesOf(SampleFrames.frameOf(AT_2_1, SampleFrames.pathThrough(AT_2_1.position()), around));
        long shown = IntStream.rangeClosed(1, sensors)
                .filter(number -> svg.contains(">" + number + "<"))
                .count();
        assertTrue(shown >= fewest && shown <= most, shown + " numbers");
    }

    @Test
    void aNumberIsShownBesideTheNameOfAFaultThatItWouldOverlap() {
        SensorSnapshot plain = SampleFrames.sensor(FRONT, AT_2_1, SampleFrames.NOTHING);
        SensorSnapshot stuck = SampleFrames.faultySensor(
                new SensorSpec("second", Vector2.ZERO, 0, 0.8, 0.5, true, 0),
                AT_2_1,
                SampleFrames.NOTHING,
                new Reading(0.3),
                FaultKind.STUCK.createFault(0.3));
        String svg = conesOf(
                SampleFrames.frameOf(AT_2_1, SampleFrames.pathThrough(AT_2_1.position()), List.of(plain, stuck)));
        assertTrue(svg.contains(">2 stuck<"));
        assertTrue(svg.contains(">1<"));
    }

    @Test
    void aSensorThatIsOffHasADashedGreyOutlineWithoutFill() {
        Pixels pixels = Pixels.render(
                withSensor(SampleFrames.sensor(FRONT.withOn(false), AT_2_1, new Reading(Reading.OFF))), LIGHT);
        assertTrue(pixels.hasNear(LIGHT.muted(), new Vector2(2.8, 1), 6));
        assertEquals(LIGHT.canvas(), pixels.colourAt(new Vector2(2.5, 1), 4, 4));
    }

    @ParameterizedTest
    @EnumSource(FaultKind.class)
    void eachFamilyOfFaultsIsHatchedInItsOwnWay(FaultKind kind) {
        BufferedImage image = cone(kind);
        for (FaultKind other : FaultKind.values()) {
            int differing = Pixels.countDifferent(image, cone(other));
            assertTrue(
                    kind.family() == other.family() ? differing == 0 : differing > 300,
                    kind + " and " + other + " differ in " + differing + " pixels");
        }
    }

    /** The middle of a faulty cone: no label, no reading. */
    private static BufferedImage cone(FaultKind kind) {
        Reading reported = new Reading(kind == FaultKind.OFF ? Reading.OFF : Reading.NOTHING);
        Frame frame = withSensor(SampleFrames.faultySensor(
                FRONT, AT_2_1, SampleFrames.NOTHING, reported, kind.createFault(kind.defaultValue())));
        Vector2 start = FrameRenderer.fitCamera(frame.snapshot(), 900, 640).toScreen(new Vector2(2.2, 1.2));
        return FrameRenderer.render(frame, LIGHT, 900, 640).getSubimage((int) start.x(), (int) start.y(), 80, 54);
    }

    @Test
    void theEightConesOfTheDefaultRobotAreVisible() {
        List<SensorSnapshot> sensors = RobotSpec.DEFAULT.sensors().stream()
                .map(spec -> SampleFrames.sensor(spec, AT_2_1, SampleFrames.NOTHING))
                .toList();
        Pixels pixels = Pixels.render(
                SampleFrames.frameOf(AT_2_1, SampleFrames.pathThrough(AT_2_1.position()), sensors), LIGHT);
        for (int i = 0; i < sensors.size(); i++) {
            Vector2 apex = sensors.get(i).sector().apex();
            Vector2 rim = apex.plus(sensors.get(i).sector().axis().times(0.8));
            assertTrue(
                    pixels.hasNear(LIGHT.sensorColours(i).outline(), rim, 2),
                    sensors.get(i).spec().id());
        }
    }

    private static Frame withSensor(SensorSnapshot sensor) {
        return SampleFrames.frameOf(AT_2_1, SampleFrames.pathThrough(AT_2_1.position()), List.of(sensor));
    }
}
