package faultline.gui.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Clearance;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SetupEditorTest {

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.RectangleShape(1, 1), new Pose(4, 2, 0));
    private static final Obstacle POLE = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(2, 3, 0));
    private static final SimulationSetup BASE = SimulationSetup.of(
                    new WorldSpec(6, 4, true, 3, List.of(BOX)), new Pose(1, 1, 0))
            .withController(new ControllerSpec.None())
            .withDuration(60);

    @Test
    void changedObstaclesKeepTheirOrder() {
        Pose there = new Pose(3, 3, 1);
        assertEquals(
                List.of(BOX.withPose(there), POLE),
                after(new Command.PlaceObstacle(POLE), new Command.MoveObstacle("box", there))
                        .world()
                        .obstacles());
        assertEquals(
                List.of(POLE),
                after(new Command.PlaceObstacle(POLE), new Command.RemoveObstacle("box"))
                        .world()
                        .obstacles());
    }

    @Test
    void changesOfThePlatformAndOfSensorSettingsAreKept() {
        SensorSpec left =
                BASE.robot().sensor("left").orElseThrow().withRange(1.5).withCone(0.5);
        SimulationSetup edited = after(new Command.SetPlatform(0.3, 0.25, 0.4), new Command.ConfigureSensor(left));
        assertEquals(BASE.robot().withPlatform(0.3, 0.25, 0.4).withSensor(left), edited.robot());
    }

    /** The sensors have been read at 0 s, so a command at the pause there acts at the first tick. */
    @Test
    void aSwitchBeforeTheFirstTickIsSavedAtTheFirstTickWhichGivesTheSameRun() {
        SimulationSetup room = BASE.withStart(new Pose(1, 3.6, 0)).withController(ControllerSpec.WallFollowing.DEFAULT);
        Command turnOff = new Command.SwitchSensor("left", false);
        SetupEditor editor = new SetupEditor(room);
        long shown;
        try (Simulation simulation = new Simulation(room, ControllerMode.DIRECT)) {
            editor.add(simulation.execute(turnOff));
            shown = hashAfterTicks(simulation);
        }
        assertEquals(
                List.of(new SimulationSetup.TimedCommand(room.dt(), turnOff)),
                editor.setup().timeline());
        assertEquals(shown, hash(editor.setup()));
        SimulationSetup atStart = room.withTimeline(List.of(new SimulationSetup.TimedCommand(0, turnOff)));
        assertNotEquals(shown, hash(atStart), "without the first reading");
    }

    private static long hash(SimulationSetup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            return hashAfterTicks(simulation);
        }
    }

    private static long hashAfterTicks(Simulation simulation) {
        for (int i = 0; i < 300; i++) {
            simulation.tick();
        }
        return simulation.trajectoryHash();
    }

    @Test
    void switchesAndFaultsAreAddedToTheTimelineAtTheirTime() {
        SensorSpec off = BASE.robot().sensor("left").orElseThrow().withOn(false);
        Command turnOff = new Command.SwitchSensor("left", false);
        Command inject = new Command.InjectFault("front", new Fault.Stuck(0.4));
        assertEquals(
                BASE.withTimeline(List.of(
                        new SimulationSetup.TimedCommand(7 * BASE.dt(), turnOff),
                        new SimulationSetup.TimedCommand(7 * BASE.dt(), inject))),
                after(turnOff, new Command.ConfigureSensor(off), inject));
    }

    @Test
    void twoCommandsOfOneTickThatCancelOutAreLeftOut() {
        Fault stuck = new Fault.Stuck(0.4);
        MotorFault dead = new MotorFault.NoDrive();
        assertEquals(
                BASE,
                after(
                        new Command.InjectMotorFault(MotorSide.LEFT, dead),
                        new Command.ClearMotorFault(MotorSide.LEFT, dead),
                        new Command.SwitchSensor("left", false),
                        new Command.InjectFault("front", stuck),
                        new Command.ClearFault("front", stuck),
                        new Command.SwitchSensor("left", true)));
    }

    /** One of two faults is repaired, so the other one is still there. */
    @Test
    void commandsOfOneTickThatLeaveAFaultStay() {
        Fault stuck = new Fault.Stuck(0.4);
        MotorFault weak = new MotorFault.Weak(0.5);
        List<Command> commands = List.of(
                new Command.InjectFault("front", stuck),
                new Command.InjectFault("front", new Fault.Bias(0.02)),
                new Command.ClearFault("front", stuck),
                new Command.InjectMotorFault(MotorSide.LEFT, weak),
                new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.DeadBand(0.5)),
                new Command.ClearMotorFault(MotorSide.LEFT, weak));
        assertEquals(
                commands,
                after(commands.toArray(Command[]::new)).timeline().stream()
                        .map(TimedCommand::command)
                        .toList());
    }

    /** The sensor was switched off before, by the timeline or by another command. */
    @Test
    void aSwitchToThePresentStateIsNotAddedToTheTimeline() {
        SetupEditor editor = new SetupEditor(BASE);
        Command off = new Command.SwitchSensor("left", false);
        editor.add(new CommandResult.Executed(10, off, List.of(off)));
        assertEquals(BASE, editor.setup());
        assertEquals(1, editor.entries().size());
    }

    @Test
    void aRepairAtALaterTimeStaysOnTheTimeline() {
        SetupEditor editor = new SetupEditor(BASE);
        Command inject = new Command.InjectFault("front", new Fault.Dead());
        Command repair = new Command.ClearFaults("front");
        add(editor, 10, inject, repair);
        add(editor, 30, repair, repair, inject);
        assertEquals(
                List.of(10 * BASE.dt(), 30 * BASE.dt()),
                editor.setup().timeline().stream()
                        .map(SimulationSetup.TimedCommand::time)
                        .toList());
    }

    @Test
    void anObstacleMovedOntoTheStartPoseIsMovedBack() {
        SetupEditor editor = new SetupEditor(BASE);
        add(editor, 10, new Command.SetPlatform(0.3, 0.2, 0.3));
        // The robot of the run is elsewhere by now.
        Command back = new Command.MoveObstacle("box", BOX.pose());
        editor.add(new CommandResult.Executed(20, new Command.MoveObstacle("box", new Pose(1.2, 1, 0)), List.of(back)));
        assertEquals(List.of(BOX), editor.setup().world().obstacles());
        assertEquals(0.3, editor.setup().robot().length());
    }

    @Test
    void anObstacleThatTheRobotStoppedAtTheStartPoseIsNotMovedBack() {
        SimulationSetup edited =
                after(new Command.SetPlatform(0.3, 0.2, 0.3), new Command.MoveObstacle("box", new Pose(1.2, 1, 0)));
        // Its front touches the box, and a micrometre remains for the start.
        assertEquals(1.650001, edited.world().obstacles().get(0).pose().x(), 1e-9);
        assertEquals(0.3, edited.robot().length());
    }

    /** Half of the robot is 0.125 m long and 0.1 m wide. The file of a robot that touches something is not valid. */
    @ParameterizedTest
    @CsvSource({
        "1.625, 1, 0, 1.625001, 1",
        "0.375, 1, 0, 0.374999, 1",
        "1.2, 1.6, 0, 1.2, 1.600001",
        "1, 0.4, 180, 1, 0.399999"
    })
    void anObstacleThatStoppedAtTheStartPoseIsNextToIt(double x, double y, double heading, double nextX, double nextY) {
        SimulationSetup edited = after(new Command.MoveObstacle("box", new Pose(x, y, Degrees.toRadians(heading))));
        Vector2 next = edited.world().obstacles().get(0).pose().position();
        assertEquals(0, next.distanceTo(new Vector2(nextX, nextY)), 1e-12);
        assertEquals(Optional.empty(), Clearance.findObstruction(edited.world(), edited.robot(), edited.start()));
    }

    /** A corner of the robot touches a side of the box. */
    @Test
    void anObstacleThatStoppedAtACornerOfTheRobotIsNextToIt() {
        double distance = (0.125 + 0.1) / Math.sqrt(2) + 0.5;
        Vector2 touching = new Vector2(1, 1).plus(Vector2.direction(Math.PI / 4).times(distance));
        SimulationSetup edited =
                after(new Command.MoveObstacle("box", new Pose(touching.x(), touching.y(), Math.PI / 4)));
        assertEquals(1e-6, edited.world().obstacles().get(0).pose().position().distanceTo(touching), 1e-12);
        assertEquals(Optional.empty(), Clearance.findObstruction(edited.world(), edited.robot(), edited.start()));
    }

    @Test
    void anObstacleAddedOnTheStartPoseIsLeftOut() {
        assertEquals(BASE, after(new Command.PlaceObstacle(POLE.withPose(new Pose(1, 1, 0)))));
    }

    @Test
    void aPlatformTooLargeForTheStartPoseChangesOnlyTheSpeed() {
        assertEquals(
                BASE.robot().withPlatform(0.25, 0.20, 0.9),
                after(new Command.SetPlatform(3, 3, 0.9)).robot());
    }

    @Test
    void aRestoredObstacleTakesItsOldPositionInTheOrder() {
        assertEquals(
                List.of(BOX, POLE),
                after(
                                new Command.PlaceObstacle(POLE),
                                new Command.RemoveObstacle("box"),
                                new Command.PlaceObstacle(BOX))
                        .world()
                        .obstacles());
    }

    @Test
    void laterCommandsAreKeptUntilTheMovedRunIsEdited() {
        SetupEditor editor = new SetupEditor(BASE);
        add(editor, 10, new Command.PlaceObstacle(POLE));
        add(editor, 20, new Command.SetPlatform(0.3, 0.25, 0.4));
        add(editor, 30, new Command.RemoveObstacle("box"));
        editor.moveTo(5);
        assertEquals(List.of(POLE), editor.setup().world().obstacles());
        add(editor, 15, new Command.MoveObstacle("box", new Pose(3, 3, 1)));
        assertEquals(
                List.of(BOX.withPose(new Pose(3, 3, 1)), POLE),
                editor.setup().world().obstacles());
        assertEquals(BASE.robot(), editor.setup().robot());
    }

    private static final TimedCommand MOVE_BOX =
            new TimedCommand(10, new Command.MoveObstacle("box", new Pose(5, 3, 0)));
    private static final TimedCommand PUT_POLE = new TimedCommand(20, new Command.PlaceObstacle(POLE));
    private static final TimedCommand MOVE_POLE =
            new TimedCommand(30, new Command.MoveObstacle("pole", new Pose(3, 3, 0)));
    private static final TimedCommand REMOVE_POLE = new TimedCommand(40, new Command.RemoveObstacle("pole"));
    private static final TimedCommand PUT_POLE_AGAIN = new TimedCommand(50, PUT_POLE.command());
    /** The obstacles of this scenario are moved, placed and removed by its timeline. */
    private static final SimulationSetup BUSY =
            BASE.withTimeline(List.of(MOVE_BOX, PUT_POLE, MOVE_POLE, REMOVE_POLE, PUT_POLE_AGAIN));

    @Test
    void theTimelineDoesNotMoveAnObstacleThatHasBeenRemoved() {
        for (long tick : new long[] {500, 1500}) {
            SetupEditor editor = new SetupEditor(BUSY);
            Pose then = tick < 1000 ? BOX.pose() : new Pose(5, 3, 0);
            Command restore = new Command.PlaceObstacle(BOX.withPose(then));
            add(editor, tick, new Command.RemoveObstacle("box"), restore);
            assertEquals(List.of(), editor.setup().world().obstacles());
            assertEquals(
                    List.of(PUT_POLE, MOVE_POLE, REMOVE_POLE, PUT_POLE_AGAIN),
                    editor.setup().timeline());
            add(editor, 1600, restore);
            assertEquals(BUSY, editor.setup());
        }
    }

    @Test
    void aChangeOfAnObstacleThatTheTimelinePlacesHoldsFromThenOn() {
        SetupEditor editor = new SetupEditor(BUSY);
        add(editor, 2500, new Command.MoveObstacle("pole", new Pose(1, 3, 0)));
        TimedCommand changed = new TimedCommand(20, new Command.PlaceObstacle(POLE.withPose(new Pose(1, 3, 0))));
        assertEquals(
                BUSY.withTimeline(List.of(MOVE_BOX, changed, MOVE_POLE, REMOVE_POLE, PUT_POLE_AGAIN)), editor.setup());
        add(editor, 6000, new Command.RemoveObstacle("pole"));
        assertEquals(BUSY.withTimeline(List.of(MOVE_BOX, changed, MOVE_POLE, REMOVE_POLE)), editor.setup());
    }

    @Test
    void ofTwoPlacementsInOneTickAChangeIsOfTheLast() {
        TimedCommand remove = new TimedCommand(20, REMOVE_POLE.command());
        SimulationSetup base = BASE.withTimeline(List.of(PUT_POLE, remove, PUT_POLE));
        Pose there = new Pose(1, 3, 0);
        TimedCommand changed = new TimedCommand(20, new Command.PlaceObstacle(POLE.withPose(there)));
        for (long tick : new long[] {2000, 2500}) {
            SetupEditor editor = new SetupEditor(base);
            add(editor, tick, new Command.MoveObstacle("pole", there));
            assertEquals(List.of(PUT_POLE, remove, changed), editor.setup().timeline(), "tick " + tick);
        }
    }

    @Test
    void anEditedPlacementIsUndoneAlsoAfterAnotherChangeOfTheScenario() {
        SetupEditor editor = new SetupEditor(BUSY);
        Command there = new Command.MoveObstacle("pole", new Pose(1, 3, 0));
        Command back = new Command.MoveObstacle("pole", POLE.pose());
        add(editor, 2500, there, back);
        SetupEditor rebased = editor.rebased(editor.setup().withDuration(90));
        assertEquals(editor.setup().withDuration(90), rebased.setup());
        add(rebased, 2600, back, there);
        assertEquals(BUSY.withDuration(90), rebased.setup());
    }

    @Test
    void theTimelineDoesNotPlaceAnObstacleThatHasBeenRemoved() {
        SetupEditor editor = new SetupEditor(BUSY);
        Command restore = new Command.PlaceObstacle(POLE.withPose(new Pose(3, 3, 0)));
        add(editor, 3500, new Command.RemoveObstacle("pole"), restore);
        assertEquals(BUSY.withTimeline(List.of(MOVE_BOX, PUT_POLE_AGAIN)), editor.setup());
        add(editor, 4500, restore);
        assertEquals(BUSY, editor.setup());
    }

    @Test
    void hiddenCommandsReturnAfterAnotherChangeOfTheTimeline() {
        TimedCommand fault = new TimedCommand(1, new Command.InjectFault("front", new Fault.Dead()));
        SetupEditor editor = new SetupEditor(BUSY);
        Command restoreBox = new Command.PlaceObstacle(BOX.withPose(new Pose(5, 3, 0)));
        add(editor, 1500, new Command.RemoveObstacle("box"), restoreBox);
        add(editor, 2500, new Command.RemoveObstacle("pole"), PUT_POLE.command());
        List<TimedCommand> visible = new ArrayList<>(editor.setup().timeline());
        visible.add(0, fault);
        SetupEditor rebased = editor.rebased(BUSY.withTimeline(visible));
        assertEquals(
                List.of(new Command.RemoveObstacle("box"), new Command.RemoveObstacle("pole")),
                rebased.entries().stream().map(Journal.Entry::command).toList());
        assertEquals(BUSY.withWorld(BUSY.world().withObstacles(List.of())).withTimeline(visible), rebased.setup());
        add(rebased, 2600, PUT_POLE.command());
        add(rebased, 2700, restoreBox);
        List<TimedCommand> all = new ArrayList<>(rebased.setup().timeline());
        assertTrue(all.remove(fault));
        assertEquals(BUSY, rebased.setup().withTimeline(all));
    }

    @Test
    void aRemovedMovingObstacleReturnsToItsFirstPlace() {
        Obstacle mover = POLE.withMotion(new WaypointPath(0.1, true, List.of(new Vector2(4, 3))));
        SimulationSetup base = BASE.withWorld(BASE.world().withObstacles(List.of(mover)));
        SetupEditor editor = new SetupEditor(base);
        Command restore = new Command.PlaceObstacle(mover.withPose(new Pose(2.5, 3, 0)));
        add(editor, 500, new Command.RemoveObstacle("pole"), restore);
        add(editor, 600, restore);
        assertEquals(base, editor.setup());
    }

    @Test
    void anObstacleThatIsMovedBackKeepsItsNewShape() {
        SetupEditor editor = new SetupEditor(BASE);
        Pose there = new Pose(3, 3, 0);
        Command back = new Command.MoveObstacle("box", BOX.pose());
        Obstacle small = new Obstacle("box", new ObstacleShape.RectangleShape(0.5, 0.5), there);
        add(editor, 5, new Command.MoveObstacle("box", there), back);
        add(editor, 6, new Command.PlaceObstacle(small), new Command.PlaceObstacle(BOX.withPose(there)));
        add(editor, 7, back, new Command.MoveObstacle("box", there));
        assertEquals(List.of(small.withPose(BOX.pose())), editor.setup().world().obstacles());
    }

    /** Each of these is changed from outside after the timeline has changed it, and then back. */
    @Test
    void undoRestoresWhatTheSetupHadAlsoIfTheTimelineHasChangedIt() {
        SensorSpec left = BASE.robot().sensor("left").orElseThrow();
        ControllerSpec.WallFollowing near = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.2);
        ControllerSpec.WallFollowing far = near.withDistance(0.5);
        List<Command> timed = List.of(
                MOVE_BOX.command(),
                new Command.ConfigureSensor(left.withRange(0.5)),
                new Command.SetPlatform(0.3, 0.3, 0.1),
                new Command.ConfigureController(near));
        List<Command> edits = List.of(
                new Command.MoveObstacle("box", new Pose(1, 3, 0)),
                new Command.ConfigureSensor(left.withRange(0.7)),
                new Command.SetPlatform(0.2, 0.2, 0.2),
                new Command.ConfigureController(far));
        SimulationSetup base = BASE.withController(ControllerSpec.WallFollowing.DEFAULT)
                .withTimeline(timed.stream()
                        .map(command -> new TimedCommand(10, command))
                        .toList());
        SetupEditor editor = new SetupEditor(base);
        for (int i = 0; i < edits.size(); i++) {
            add(editor, 1200, edits.get(i), timed.get(i));
        }
        SimulationSetup edited = editor.setup();
        assertEquals(far, edited.controller());
        for (int i = 0; i < edits.size(); i++) {
            add(editor, 1300, timed.get(i), edits.get(i));
        }
        assertEquals(base, editor.setup());
        for (int i = 0; i < edits.size(); i++) {
            add(editor, 1400, edits.get(i), timed.get(i));
        }
        assertEquals(edited, editor.setup(), "redone");
    }

    private static SimulationSetup after(Command... commands) {
        SetupEditor editor = new SetupEditor(BASE);
        try (Simulation simulation = new Simulation(BASE, ControllerMode.DIRECT)) {
            for (int i = 0; i < 6; i++) {
                simulation.tick();
            }
            Stream.of(commands).forEach(command -> editor.add(simulation.execute(command)));
        }
        return editor.setup();
    }

    private static void add(SetupEditor editor, long tick, Command command, Command... inverse) {
        editor.add(new CommandResult.Executed(tick, command, List.of(inverse)));
    }
}
