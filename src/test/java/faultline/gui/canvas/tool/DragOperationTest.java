package faultline.gui.canvas.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.EditLimits;
import faultline.gui.edit.SnapSettings;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import faultline.world.WaypointPath;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

class DragOperationTest {

    private static final Obstacle BOX =
            new Obstacle("box", new ObstacleShape.RectangleShape(1, 1), new Pose(2, 1, Degrees.toRadians(170)));

    private static Obstacle only(DragPreview preview) {
        assertEquals(1, preview.obstacles().size());
        return preview.obstacles().get(0);
    }

    @Test
    void aMoveKeepsTheGripUnderTheMouseAndTheHeading() {
        DragPreview preview = new DragOperation.Move(BOX, List.of(BOX), new Vector2(2.25, 1.25))
                .preview(new Vector2(3.25, 0.75), SnapSettings.NONE);
        Pose wanted = new Pose(3, 0.5, BOX.pose().heading());
        assertEquals(wanted, only(preview).pose());
        assertEquals(List.of(new Command.MoveObstacle("box", wanted)), preview.commands());
        assertEquals("x 3.000 m   y 0.500 m", preview.valueText());
    }

    @Test
    void whatIsSelectedMovesTogetherAndOnlyTheGrabbedObstacleSnaps() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1.03, 1, 0));
        DragPreview preview = new DragOperation.Move(BOX, List.of(pole, BOX), new Vector2(2, 1))
                .preview(new Vector2(2.11, 1.02), new SnapSettings(0.1, 0));
        assertEquals(0, preview.obstacles().get(0).pose().position().distanceTo(new Vector2(1.13, 1)), 1e-12);
        assertEquals(new Vector2(2.1, 1), preview.obstacles().get(1).pose().position());
    }

    @Test
    void aTurnFollowsTheMouseRoundTheMiddleAndIsNamedWithinHalfATurn() {
        DragPreview preview =
                new DragOperation.Rotate(List.of(BOX), new Vector2(3, 1)).preview(new Vector2(2, 4), SnapSettings.NONE);
        assertEquals(Degrees.toRadians(260), only(preview).pose().heading(), 1e-12);
        assertEquals("heading -100.0\u00b0", preview.valueText());
    }

    @Test
    void whatADragMovesHasFewDecimalsAndTheRestKeepsItsBits() {
        Obstacle odd = BOX.withPose(new Pose(2.123456789, 1.987654321, 0.3));
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(1.03, 1.23456789, 0));
        Vector2 grab = new Vector2(2, 1);
        List<Obstacle> moved = new DragOperation.Move(odd, List.of(odd, pole), grab)
                .preview(new Vector2(2 + 1.0 / 3, 1), SnapSettings.NONE)
                .obstacles();
        assertEquals(new Pose(2.4568, 1.987654321, 0.3), moved.get(0).pose());
        assertEquals(new Pose(1.36334, 1.23456789, 0), moved.get(1).pose());
    }

    @Test
    void headingsAreRoundedInDegrees() {
        Pose before = new Pose(2.123456789, 1.987654321, Degrees.toRadians(30));
        Obstacle odd = BOX.withPose(before);
        DragOperation turn = new DragOperation.Rotate(List.of(odd), new Vector2(3, 2));
        Pose free = only(turn.preview(new Vector2(2.5, 2.7), SnapSettings.NONE)).pose();
        assertEquals(before.position(), free.position(), "it turns about its own middle");
        assertTrue(Degrees.toText(free.heading()).matches("\\d+(\\.\\d)?"), Degrees.toText(free.heading()));
        SnapSettings steps = new SnapSettings(0, Degrees.toRadians(15));
        Pose snapped = only(turn.preview(new Vector2(2.5, 2.7), steps)).pose();
        assertEquals(0, Integer.parseInt(Degrees.toText(snapped.heading())) % 15);
    }

    @Test
    void aTurnSnapsToWholeSteps() {
        DragPreview preview = new DragOperation.Rotate(List.of(BOX), new Vector2(3, 1))
                .preview(new Vector2(2, 4), new SnapSettings(0, Degrees.toRadians(45)));
        assertEquals(Degrees.toRadians(270), only(preview).pose().heading(), 1e-8);
    }

    @Test
    void severalTurnAboutTheirCommonMiddle() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(4, 1, 0));
        DragOperation turn = new DragOperation.Rotate(List.of(BOX, pole), new Vector2(4, 1));
        DragPreview preview = turn.preview(new Vector2(3.05, 2), new SnapSettings(0, Degrees.toRadians(15)));
        assertEquals(0, preview.obstacles().get(0).pose().position().distanceTo(new Vector2(3, 0)), 1e-8);
        assertEquals(0, preview.obstacles().get(1).pose().position().distanceTo(new Vector2(3, 2)), 1e-8);
        assertEquals(Degrees.toRadians(260), preview.obstacles().get(0).pose().heading(), 1e-8);
        assertEquals("rotated by 90.0\u00b0", preview.valueText());
        assertEquals(
                List.of(new Command.MoveObstacle("box", BOX.pose()), new Command.MoveObstacle("pole", pole.pose())),
                turn.restoreCommands());
    }

    @Test
    void aSideOfARectangleIsDraggedWhileTheOppositeOneStays() {
        Obstacle box = BOX.withPose(new Pose(2, 1, 0));
        // Handle 7 is the midpoint of the right side.
        DragPreview preview = new DragOperation.Resize(box, 7).preview(new Vector2(3.5, 9), SnapSettings.NONE);
        assertEquals(new ObstacleShape.RectangleShape(2, 1), only(preview).shape());
        assertEquals(new Pose(2.5, 1, 0), only(preview).pose());
        assertEquals("width 2.000 m   height 1.000 m", preview.valueText());
        assertEquals(List.of(new Command.PlaceObstacle(box)), new DragOperation.Resize(box, 7).restoreCommands());
    }

    @Test
    void theArcOfAConeSetsItsRangeAndAnEdgeItsAngle() {
        SensorSpec spec = RobotSpec.DEFAULT.sensors().get(0);
        SensorSnapshot sensor = SampleFrames.sensor(spec, new Pose(1, 1, 0), SampleFrames.NOTHING);
        Vector2 apex = sensor.sector().apex();
        DragPreview rim = new DragOperation.ChangeRange(spec, () -> spec, () -> sensor)
                .preview(apex.plus(new Vector2(0.6, 0)), SnapSettings.NONE);
        assertEquals(List.of(new Command.ConfigureSensor(spec.withRange(0.6))), rim.commands());
        DragPreview edge = new DragOperation.ChangeCone(spec, () -> spec, () -> sensor)
                .preview(apex.plus(new Vector2(0.5, 0.5)), SnapSettings.NONE);
        assertEquals(List.of(new Command.ConfigureSensor(spec.withCone(Degrees.toRadians(90)))), edge.commands());
        assertEquals("cone 90.0\u00b0", edge.valueText());
    }

    @Test
    void dragsOfAConeKeepWhatElseChangesMeanwhile() {
        SensorSpec start = RobotSpec.DEFAULT.sensors().get(0);
        SensorSnapshot sensor = SampleFrames.sensor(start, new Pose(1, 1, 0), SampleFrames.NOTHING);
        Vector2 apex = sensor.sector().apex();
        AtomicReference<SensorSpec> expected = new AtomicReference<>(start);
        List<DragOperation> drags = List.of(
                new DragOperation.ChangeRange(start, expected::get, () -> sensor),
                new DragOperation.ChangeCone(start, expected::get, () -> sensor),
                DragOperation.TurnSensor.at(apex.plus(new Vector2(0.5, 0)), expected::get, () -> sensor));
        SensorSpec noisy = start.withNoise(0.1);
        for (int i = 0; i < drags.size(); i++) {
            expected.set(noisy);
            Command command = drags.get(i)
                    .preview(apex.plus(new Vector2(0, 0.5)), SnapSettings.NONE)
                    .commands()
                    .get(0);
            SensorSpec sent = ((Command.ConfigureSensor) command).sensor();
            assertEquals(0.1, sent.noise());
            expected.set(sent);
            assertEquals(
                    List.of(new Command.ConfigureSensor(noisy)), drags.get(i).restoreCommands());
        }
    }

    @Test
    void aDragOfAWaypointKeepsWhatElseChangesMeanwhile() {
        WaypointPath path = new WaypointPath(0.2, true, List.of(new Vector2(2, 3), new Vector2(5, 3)));
        AtomicReference<Obstacle> expected = new AtomicReference<>(BOX.withMotion(path));
        DragOperation drag = new DragOperation.MoveWaypoint(expected.get(), 1, start -> expected.get());
        WaypointPath faster = new WaypointPath(0.4, true, List.of(new Vector2(2, 4), new Vector2(5, 3)));
        Obstacle changed = BOX.withPose(new Pose(3, 1, 0)).withMotion(faster);
        expected.set(changed);
        assertEquals(
                List.of(new Command.PlaceObstacle(
                        changed.withMotion(faster.withWaypoints(List.of(new Vector2(2, 4), new Vector2(6, 3)))))),
                drag.preview(new Vector2(6, 3), SnapSettings.NONE).commands());
        assertEquals(List.of(new Command.PlaceObstacle(changed)), drag.restoreCommands());
        Obstacle shorter = changed.withMotion(faster.withWaypoints(List.of(new Vector2(1, 1))));
        expected.set(shorter);
        assertEquals(
                List.of(new Command.PlaceObstacle(changed.withMotion(faster.withWaypoints(path.waypoints())))),
                drag.restoreCommands());
    }

    @Test
    void aConeTurnsWithTheMouseAboutTheMountingPointWhileTheRobotTurnsToo() {
        SensorSpec spec = RobotSpec.DEFAULT.sensor("rear").orElseThrow();
        SensorSnapshot start = SampleFrames.sensor(spec, new Pose(1, 1, 3), SampleFrames.NOTHING);
        Vector2 apex = start.sector().apex();
        Vector2 axis = start.sector().axis();
        AtomicReference<SensorSnapshot> now = new AtomicReference<>(start);
        DragOperation turn = DragOperation.TurnSensor.at(apex.plus(axis.times(0.5)), () -> spec, now::get);
        assertEquals(
                -150,
                bearing(
                        turn,
                        apex.plus(Vector2.direction(axis.angle() + Degrees.toRadians(30))
                                .times(0.2))),
                1e-9);
        // The robot has turned by 60 degrees and the sensor has been turned by 30; the mouse stays.
        SensorSpec turned = spec.withBearing(Degrees.toRadians(-150));
        now.set(SampleFrames.sensor(turned, new Pose(1, 1, 3 + Math.PI / 3), SampleFrames.NOTHING));
        Vector2 mouse = now.get().sector().apex().plus(Vector2.direction(axis.angle() + Degrees.toRadians(30)));
        assertEquals(150, bearing(turn, mouse), 1e-9);
        assertEquals(
                "bearing 150.0\u00b0", turn.preview(mouse, SnapSettings.NONE).valueText());
        assertEquals(List.of(new Command.ConfigureSensor(spec)), turn.restoreCommands());
    }

    @Test
    void aConeThatIsHeldBesideItsAxisDoesNotJumpAndSnapsToAngles() {
        SensorSpec spec = RobotSpec.DEFAULT.sensor("front").orElseThrow();
        SensorSnapshot sensor = SampleFrames.sensor(spec, new Pose(1, 1, 0), SampleFrames.NOTHING);
        Vector2 apex = sensor.sector().apex();
        Vector2 grip = apex.plus(Vector2.direction(0.1));
        DragOperation turn = DragOperation.TurnSensor.at(grip, () -> spec, () -> sensor);
        assertEquals(0, bearing(turn, grip), 1e-9);
        SnapSettings snap = new SnapSettings(0, Degrees.toRadians(15));
        Command command = turn.preview(apex.plus(Vector2.direction(0.1 + Degrees.toRadians(40))), snap)
                .commands()
                .get(0);
        assertEquals(new Command.ConfigureSensor(spec.withBearing(Degrees.toRadians(45))), command);
    }

    private static double bearing(DragOperation turn, Vector2 mouse) {
        Command command = turn.preview(mouse, SnapSettings.NONE).commands().get(0);
        return Math.toDegrees(((Command.ConfigureSensor) command).sensor().bearing());
    }

    @Test
    void aDraggedArcStaysWithinTheLimitsOfTheFieldForTheRange() {
        SensorSpec spec = RobotSpec.DEFAULT.sensors().get(0);
        SensorSnapshot sensor = SampleFrames.sensor(spec, new Pose(1, 1, 0), SampleFrames.NOTHING);
        Vector2 apex = sensor.sector().apex();
        DragOperation arc = new DragOperation.ChangeRange(spec, () -> spec, () -> sensor);
        assertEquals(
                List.of(new Command.ConfigureSensor(spec.withRange(EditLimits.MIN_SENSOR_RANGE))),
                arc.preview(apex.plus(new Vector2(0.001, 0)), SnapSettings.NONE).commands());
        assertEquals(
                List.of(new Command.ConfigureSensor(spec.withRange(EditLimits.MAX_SENSOR_RANGE))),
                arc.preview(apex.plus(new Vector2(0, 500)), SnapSettings.NONE).commands());
    }
}
