package faultline.paint.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SensorLabelTest {

    private static final Rectangle2D PICTURE = new Rectangle2D.Double(0, 0, 900, 600);
    private static final double CORNER = 0.2;
    private static final Fault CROSS_TALK = FaultKind.CROSS_TALK.createFault(0.9);
    private static final Fault STUCK = new Fault.Stuck(0.4);

    private final BufferedImage picture = new BufferedImage(900, 600, BufferedImage.TYPE_INT_RGB);

    private static SensorSnapshot sensor(int index, Pose robot, Fault... faults) {
        SensorSpec spec = RobotSpec.DEFAULT.sensors().get(index);
        return faults.length == 0
                ? SampleFrames.sensor(spec, robot, new Reading(0.5))
                : SampleFrames.faultySensor(spec, robot, new Reading(0.5), new Reading(0.4), faults);
    }

    private static Snapshot world(Pose robot, SensorSnapshot... sensors) {
        return SampleFrames.frameOf(robot, SampleFrames.pathThrough(robot.position()), List.of(sensors))
                .snapshot();
    }

    private DrawContext context(Camera camera) {
        return new DrawContext(picture.createGraphics(), camera, Palette.LIGHT);
    }

    private List<SensorLabel> labels(Snapshot world) {
        return SensorLabel.of(context(FrameRenderer.fitCamera(world, 900, 600)), world, SceneLabels.ENGLISH);
    }

    private static List<String> texts(List<SensorLabel> labels) {
        return labels.stream().map(SensorLabel::text).toList();
    }

    @Test
    void aSensorWithSeveralFaultsHasTheNameOfTheFirstAndTheNumberOfTheOthers() {
        Pose robot = new Pose(3, 2, 0);
        assertEquals(
                List.of("1 cross-talk +1", "2 stuck", "3 stuck", "4"),
                texts(labels(world(
                        robot,
                        sensor(0, robot, CROSS_TALK, STUCK),
                        sensor(1, robot, STUCK),
                        sensor(2, robot, STUCK, new Fault.Stuck(0.3)),
                        sensor(3, robot)))));
        Fault[] all = Stream.of(FaultKind.values())
                .map(kind -> kind.createFault(kind.defaultValue()))
                .toArray(Fault[]::new);
        assertEquals(List.of("1 off +16"), texts(labels(world(robot, sensor(0, robot, all)))));
    }

    /** In the corner, near it and in the middle of the world. In the corner, there is no room for all of them. */
    @ParameterizedTest
    @ValueSource(doubles = {CORNER, 0.5, 3})
    void labelsCoverNeitherTheRobotNorOtherLabelsAndNoNumberIsOmitted(double x) {
        for (int degrees = 0; degrees < 360; degrees += 15) {
            Pose robot = new Pose(x, Math.min(x, 2), Math.toRadians(degrees));
            int last = RobotSpec.DEFAULT.sensors().size() - 1;
            Snapshot world = world(
                    robot,
                    IntStream.rangeClosed(0, last)
                            .mapToObj(i -> i % 2 == 0
                                    ? sensor(i, robot, CROSS_TALK, STUCK)
                                    : i == last ? sensor(i, robot) : sensor(i, robot, STUCK))
                            .toArray(SensorSnapshot[]::new));
            List<SensorLabel> labels = labels(world);
            assertTrue(x == CORNER || labels.size() == last + 1, () -> robot + " " + texts(labels));
            Rectangle2D body =
                    RobotPainter.bounds(context(FrameRenderer.fitCamera(world, 900, 600)), world.robot(), world.pose());
            for (SensorLabel label : labels) {
                assertFalse(label.box().intersects(body), () -> label + " covers the robot at " + robot);
                assertTrue(PICTURE.contains(label.box()), label::text);
                assertTrue(
                        x == CORNER
                                || labels.stream()
                                        .noneMatch(other ->
                                                other != label && other.box().intersects(label.box())),
                        () -> label + " covers another label at " + robot);
            }
        }
    }

    /** In a view of another part of the world, they would be at its edge. */
    @Test
    void theLabelsOfARobotOutsideOfThePictureStayThere() {
        Pose robot = new Pose(1, 1, 0);
        Snapshot world = world(robot, sensor(0, robot, STUCK), sensor(1, robot));
        assertTrue(SensorLabel.of(context(new Camera(50, 50, 200, 900, 600)), world, SceneLabels.ENGLISH).stream()
                .noneMatch(label -> label.box().intersects(PICTURE)));
    }
}
