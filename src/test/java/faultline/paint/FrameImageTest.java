package faultline.paint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.Collision;
import faultline.world.Motion;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Pixels of frames painted without a display. The world is 6 m x 4 m and some 137 pixels to the metre. */
class FrameImageTest {

    private static final Pose AT_2_1 = new Pose(2, 1, 0);
    private static final Palette LIGHT = Palette.LIGHT;
    /** Looks along the x axis from (2, 1), 0.8 m far. */
    private static final SensorSpec FRONT = new SensorSpec("front", Vec.ZERO, 0, 0.8, 0.5, true, 0);

    @Test
    void theRobotIsWhereItIsAndYGoesUp() {
        Pixels pixels = Pixels.of(SampleFrames.of(AT_2_1), LIGHT);
        pixels.assertColour(LIGHT.robot(), new Vec(2, 1));
        assertFalse(pixels.hasNear(LIGHT.robot(), new Vec(2, 3), 10), "nothing at the mirrored place");
    }

    @Test
    void theRobotsFrontTurnsWithItsHeading() {
        Pixels ahead = Pixels.of(SampleFrames.of(AT_2_1), LIGHT);
        Pixels up = Pixels.of(SampleFrames.of(new Pose(2, 1, Math.PI / 2)), LIGHT);
        assertTrue(ahead.hasNear(LIGHT.robotOutline(), new Vec(2.112, 1), 0));
        assertTrue(up.hasNear(LIGHT.robotOutline(), new Vec(2, 1.112), 0));
        assertFalse(up.hasNear(LIGHT.robotOutline(), new Vec(2, 0.9), 0), "the rear has no bar");
    }

    @Test
    void aDarkPictureHasOtherColours() {
        Pixels dark = Pixels.of(SampleFrames.of(AT_2_1), Palette.DARK);
        dark.assertColour(Palette.DARK.robot(), new Vec(2, 1));
        assertEquals(Palette.DARK.canvas(), dark.at(new Vec(3, 2), 3, 3));
        assertEquals(LIGHT.canvas(), Pixels.of(SampleFrames.of(AT_2_1), LIGHT).at(new Vec(3, 2), 3, 3));
    }

    @Test
    void thePathIsSeenAndEndsAtTheRobot() {
        faultline.engine.Path path = SampleFrames.path(new Vec(1, 3), new Vec(1, 2), new Vec(4, 2));
        Pixels pixels = Pixels.of(SampleFrames.of(new Pose(5, 2, 0), path, List.of()), LIGHT);
        for (Vec point : List.of(new Vec(1, 2.5), new Vec(2.5, 2), new Vec(4.5, 2))) {
            assertTrue(pixels.hasNear(LIGHT.path(), point, 1), "at " + point);
        }
    }

    @Test
    void aRingGoesRoundAHitAndLeavesItsMiddleFree() {
        Vec hit = new Vec(4, 3);
        Frame frame = SampleFrames.of(AT_2_1, SampleFrames.path(AT_2_1.position()),
                List.of(SampleFrames.sensor(FRONT, AT_2_1, SampleFrames.NOTHING, hit)));
        Pixels pixels = Pixels.of(frame, LIGHT);
        int radius = (int) HitPainter.RADIUS;
        assertTrue(pixels.hasNear(LIGHT.hit(), hit, radius));
        assertFalse(pixels.hasNear(LIGHT.hit(), hit, radius - 3));
    }

    @Test
    void eachShapeIsFilledInsideAndNotBesideIt() {
        Pixels pixels = Pixels.of(SampleFrames.of(AT_2_1,
                new Obstacle("box", new ObstacleShape.Rectangle(1, 0.2), new Pose(4, 3, Math.PI / 2)),
                new Obstacle("disc", new ObstacleShape.Circle(0.3), new Pose(1, 3, 0)),
                new Obstacle("wedge", new ObstacleShape.Polygon(List.of(new Vec(0, 0), new Vec(1, 0), new Vec(0, 1))),
                        new Pose(4.5, 0.5, 0))), LIGHT);
        for (Vec inside : List.of(new Vec(4, 3.4), new Vec(1.2, 3), new Vec(4.7, 0.7))) {
            pixels.assertColour(LIGHT.obstacle(), inside);
        }
        for (Vec beside : List.of(new Vec(4.4, 3), new Vec(1.27, 3.27), new Vec(5.2, 1.2))) {
            assertNotEquals(LIGHT.obstacle(), pixels.at(beside, 0, 0), "at " + beside);
        }
    }

    @Test
    void aWallIsSeenThoughItHasNoThickness() {
        Obstacle wall = new Obstacle("wall", new ObstacleShape.Wall(List.of(new Vec(0, 0), new Vec(2, 0))), new Pose(3, 3, 0));
        Pixels.of(SampleFrames.of(AT_2_1, wall), LIGHT).assertColour(LIGHT.obstacleOutline(), new Vec(4, 3));
    }

    @Test
    void aGlossyWallIsABrightLineBetweenTwoDarkOnes() {
        ObstacleShape wall = new ObstacleShape.Wall(List.of(new Vec(0, -1), new Vec(0, 1)));
        Obstacle mirror = new Obstacle("mirror", wall, new Pose(4, 2, 0), Optional.empty(), 0.2);
        Pixels pixels = Pixels.of(SampleFrames.of(AT_2_1, mirror), LIGHT);
        Vec place = new Vec(4, 2.6);
        assertTrue(pixels.hasNear(LIGHT.obstacleOutline(), place, 3), "its edge");
        assertTrue(pixels.hasNear(LIGHT.canvas(), place, 1), "its gloss");
    }

    @Test
    void aMovingObstacleHasItsOwnOutlineAndShowsItsWay() {
        Motion motion = new Motion(0.2, false, List.of(new Vec(3, 3), new Vec(5, 3)));
        Pixels pixels = Pixels.of(SampleFrames.of(AT_2_1,
                new Obstacle("visitor", new ObstacleShape.Circle(0.3), new Pose(4, 2, 0), Optional.of(motion))), LIGHT);
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vec(4.3, 2), 2));
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vec(3, 3), 1), "a way-point");
        assertTrue(pixels.hasNear(LIGHT.movingOutline(), new Vec(4.2, 3), 10), "the arrow");
    }

    @Test
    void theFirstCollisionIsMarkedAndSaidInABadge() {
        Vec point = new Vec(4, 3);
        Collision collision = new Collision(point, 1.5, 150, "box", Map.of(), List.of());
        faultline.engine.Path path = SampleFrames.path(AT_2_1.position());
        Frame frame = SampleFrames.frame(AT_2_1, path, List.of(), List.of(), List.of(point), Optional.of(collision));
        Pixels.of(frame, LIGHT).assertColour(LIGHT.hit(), point);
        BufferedImage plain = FrameImage.render(SampleFrames.of(AT_2_1), LIGHT, 900, 640).getSubimage(0, 0, 200, 30);
        BufferedImage badged = FrameImage.render(frame, LIGHT, 900, 640).getSubimage(0, 0, 200, 30);
        assertTrue(Pixels.differing(plain, badged) > 200, "no badge in the corner");
    }

    @Test
    void theReportedDistanceIsAnArcAcrossTheCone() {
        Pixels pixels = Pixels.of(withSensor(SampleFrames.sensor(FRONT, AT_2_1, new Reading(0.5))), LIGHT);
        pixels.assertColour(LIGHT.sensor(0).outline(), new Vec(2.5, 1));
        assertNotEquals(LIGHT.sensor(0).outline(), pixels.at(new Vec(2.4, 1), 0, 0));
    }

    @Test
    void aFaultySensorShowsTheTrueDistanceToo() {
        SensorSnapshot stuck = SampleFrames.faulty(FRONT, AT_2_1, new Reading(0.6), new Reading(0.3), FaultKind.STUCK.fault(0.3));
        Pixels pixels = Pixels.of(withSensor(stuck), LIGHT);
        assertTrue(pixels.hasNear(LIGHT.sensor(0).outline(), new Vec(2.3, 1), 1));
        assertTrue(pixels.hasNear(LIGHT.text(), new Vec(2.6, 1), 5));
    }

    @Test
    void aSensorThatIsOffIsABrokenGreyOutlineWithoutFill() {
        Pixels pixels = Pixels.of(withSensor(SampleFrames.sensor(FRONT.withOn(false), AT_2_1, new Reading(Reading.OFF))), LIGHT);
        assertTrue(pixels.hasNear(LIGHT.muted(), new Vec(2.8, 1), 6));
        assertEquals(LIGHT.canvas(), pixels.at(new Vec(2.5, 1), 4, 4));
    }

    @ParameterizedTest
    @EnumSource(FaultKind.class)
    void eachKindOfFaultIsHatchedInItsOwnWay(FaultKind kind) {
        BufferedImage image = cone(kind);
        for (FaultKind other : FaultKind.values()) {
            int differing = Pixels.differing(image, cone(other));
            assertTrue(kind == other ? differing == 0 : differing > 300, kind + " and " + other + " differ in " + differing + " pixels");
        }
    }

    /** The middle of a faulty cone: no label, no reading. */
    private static BufferedImage cone(FaultKind kind) {
        Reading reported = new Reading(kind == FaultKind.OFF ? Reading.OFF : Reading.NOTHING);
        Frame frame = withSensor(SampleFrames.faulty(FRONT, AT_2_1, SampleFrames.NOTHING, reported, kind.fault(kind.usual())));
        Vec start = FrameImage.camera(frame.world(), 900, 640).toScreen(new Vec(2.2, 1.2));
        return FrameImage.render(frame, LIGHT, 900, 640).getSubimage((int) start.x(), (int) start.y(), 80, 54);
    }

    @Test
    void theStandardRobotsEightConesAreAllSeen() {
        List<SensorSnapshot> sensors = RobotSpec.DEFAULT.sensors().stream()
                .map(spec -> SampleFrames.sensor(spec, AT_2_1, SampleFrames.NOTHING)).toList();
        Pixels pixels = Pixels.of(SampleFrames.of(AT_2_1, SampleFrames.path(AT_2_1.position()), sensors), LIGHT);
        for (int i = 0; i < sensors.size(); i++) {
            Vec apex = sensors.get(i).sector().apex();
            Vec rim = apex.plus(sensors.get(i).sector().axis().times(0.8));
            assertTrue(pixels.hasNear(LIGHT.sensor(i).outline(), rim, 2), sensors.get(i).spec().id());
        }
    }

    private static Frame withSensor(SensorSnapshot sensor) {
        return SampleFrames.of(AT_2_1, SampleFrames.path(AT_2_1.position()), List.of(sensor));
    }
}
