package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Threshold;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import faultline.world.WaypointPath;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** Tests the undo controller with a world that executes commands immediately. */
class UndoControllerTest {

    private static final Obstacle DESK =
            new Obstacle("desk", new ObstacleShape.RectangleShape(0.5, 0.5), new Pose(4, 2, 0));
    private static final Obstacle LAMP = new Obstacle("lamp", new ObstacleShape.CircleShape(0.1), new Pose(5, 3, 0));
    private static final SensorSpec FRONT = RobotSpec.DEFAULT.sensors().get(0);

    private final World world =
            new World(new WorldSpec(6, 4, true, 1, List.of(DESK)), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
    private long now;
    private final CommandSender sender = callOnEdt(() -> new CommandSender(this::execute, () -> now));
    private final UndoController controller = callOnEdt(() -> new UndoController(sender, () -> {}));

    private boolean dead;

    private void execute(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        onExecuted.accept(
                dead ? List.of() : commands.stream().map(world::execute).toList());
    }

    private static Command moveTo(double x) {
        return new Command.MoveObstacle("desk", new Pose(x, 2, 0));
    }

    private Optional<String> undoName() {
        return callOnEdt(controller::undoName);
    }

    /** The run has ended by an error, such as a lack of memory. */
    @Test
    void anEditThatADeadRunDoesNotUndoStaysDone() {
        runOnEdt(() -> sender.send(moveTo(3)));
        dead = true;
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Move desk"), undoName());
        assertEquals(Optional.empty(), callOnEdt(controller::redoName));
    }

    @Test
    void tenEditsAreUndoneAndRedoneOneByOne() {
        List<Snapshot> states = new ArrayList<>(List.of(world.snapshot()));
        List<String> names = new ArrayList<>();
        for (Command edit : tenEdits()) {
            now += 5000;
            runOnEdt(() -> sender.send(edit));
            states.add(world.snapshot());
            names.add(undoName().orElseThrow());
        }
        assertEquals(
                List.of(
                        "Move desk",
                        "Rotate desk",
                        "Add lamp",
                        "Change lamp",
                        "Switch left off",
                        "Range of front",
                        "Cone of front",
                        "Fault in front",
                        "Change platform",
                        "Delete desk"),
                names);
        for (int done = 9; done >= 0; done--) {
            runOnEdt(controller::undo);
            assertEquals(withoutOrder(states.get(done)), withoutOrder(world.snapshot()));
        }
        assertEquals(Optional.empty(), undoName());
        for (int done = 1; done <= 10; done++) {
            runOnEdt(controller::redo);
            assertEquals(withoutOrder(states.get(done)), withoutOrder(world.snapshot()));
        }
        assertEquals(Optional.empty(), callOnEdt(controller::redoName));
    }

    private List<Command> tenEdits() {
        return List.of(
                moveTo(4.5),
                new Command.MoveObstacle("desk", new Pose(4.5, 2, 1)),
                new Command.PlaceObstacle(LAMP),
                new Command.PlaceObstacle(new Obstacle("lamp", new ObstacleShape.CircleShape(0.3), LAMP.pose())),
                new Command.SwitchSensor("left", false),
                new Command.ConfigureSensor(FRONT.withRange(0.4)),
                new Command.ConfigureSensor(FRONT.withRange(0.4).withCone(0.5)),
                new Command.InjectFault("front", new Fault.Stuck(0.3)),
                new Command.SetPlatform(0.3, 0.2, 0.3),
                new Command.RemoveObstacle("desk"));
    }

    /** Returns the world without its drawing order: a restored obstacle is drawn last. */
    private static List<Object> withoutOrder(Snapshot world) {
        return List.of(Set.copyOf(world.obstacles()), world.robot(), world.sensors());
    }

    @Test
    void anEditAfterAnotherWasRedoneIsNotPartOfIt() {
        runOnEdt(() -> {
            sender.send(moveTo(4.2));
            controller.undo();
            controller.redo();
            sender.send(moveTo(4.4));
            controller.undo();
        });
        assertEquals(4.2, x());
    }

    @Test
    void aGestureIsNotPartOfTheEditBefore() {
        runOnEdt(() -> {
            sender.send(moveTo(4.2));
            sender.beginGesture();
            sender.send(moveTo(4.4));
            sender.endGesture();
            controller.undo();
        });
        assertEquals(4.2, x());
    }

    /** Returns a sender whose commands are executed when their entry in a list is run. */
    private CommandSender lateSender(List<Runnable> answers) {
        return callOnEdt(() -> new CommandSender(
                (commands, onExecuted) -> answers.add(() -> execute(commands, onExecuted)), () -> now));
    }

    @Test
    void undoAndRedoWaitForTheEditsBeforeThem() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        runOnEdt(() -> {
            lateSender.send(moveTo(4.2));
            answers.remove(0).run();
            now += 5000;
            lateSender.send(moveTo(4.4));
            late.undo();
            late.undo();
            late.redo();
        });
        assertEquals(List.of(4.4, 4.2, 4.0, 4.2), places(answers), "the second edit is undone before the first");
        assertEquals(Optional.of("Move desk"), callOnEdt(late::undoName));
        assertEquals(Optional.of("Move desk"), callOnEdt(late::redoName));
    }

    /** Returns where the desk is after each of the waiting commands and those that follow. */
    private List<Double> places(List<Runnable> answers) {
        List<Double> places = new ArrayList<>();
        while (!answers.isEmpty()) {
            runOnEdt(() -> answers.remove(0).run());
            places.add(x());
        }
        return places;
    }

    /** A key stroke that comes before the answer is not lost. */
    @Test
    void anEditCanBeUndoneBeforeItIsAnswered() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        assertFalse(callOnEdt(late::canUndo));
        runOnEdt(() -> lateSender.send(moveTo(4.2)));
        assertTrue(callOnEdt(late::canUndo));
        assertEquals(Optional.empty(), callOnEdt(late::undoName), "it may be refused");
        assertFalse(callOnEdt(late::canRedo));
        runOnEdt(late::undo);
        assertTrue(callOnEdt(late::canRedo));
        assertEquals(List.of(4.2, 4.0), places(answers));
        assertFalse(callOnEdt(late::canUndo));
        assertTrue(callOnEdt(late::canRedo));
    }

    @Test
    void aChangeIsReportedBeforeAnEditIsSentAndAfterItIsRecorded() {
        List<String> events = new ArrayList<>();
        List<Runnable> answers = new ArrayList<>();
        runOnEdt(() -> {
            CommandSender reported = new CommandSender((commands, onExecuted) -> {
                events.add("sent");
                answers.add(() -> execute(commands, onExecuted));
            });
            AtomicReference<UndoController> undo = new AtomicReference<>();
            undo.set(new UndoController(
                    reported,
                    () -> events.add(
                            undo.get().canUndo() + " " + undo.get().undoName().orElse("unknown"))));
            reported.send(moveTo(4.2));
            answers.remove(0).run();
        });
        assertEquals(List.of("true unknown", "sent", "true Move desk"), events);
    }

    @Test
    void anEditThatIsRefusedIsNotUndone() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        runOnEdt(() -> {
            lateSender.send(moveTo(4.2));
            answers.remove(0).run();
            lateSender.send(new Command.RemoveObstacle("none"));
            late.undo();
        });
        assertEquals(List.of(4.2, 4.0), places(answers));
    }

    /** The new edit may depend on what would have been undone: settings are sent as a whole. */
    @Test
    void aNewEditCancelsAnUndoThatWaits() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        SensorSpec range = FRONT.withRange(0.5);
        runOnEdt(() -> {
            lateSender.pendingEdits().setRobot(RobotSpec.DEFAULT);
            lateSender.send(new Command.ConfigureSensor(range));
            late.undo();
            SensorSpec expected = lateSender.pendingEdits().robot().sensors().get(0);
            lateSender.send(new Command.ConfigureSensor(expected.withNoise(0.01)));
        });
        assertEquals(2, places(answers).size());
        assertEquals(range.withNoise(0.01), world.snapshot().robot().sensors().get(0));
        runOnEdt(() -> {
            late.undo();
            late.addSetupEdit(() -> "Setup", "setup", SetupChange.of(() -> {}, () -> {}));
        });
        assertEquals(1, answers.size(), "all edits have been answered, so the undo did not wait");
    }

    @Test
    void anUndoThatWaitsIsForgottenWithItsScenario() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        runOnEdt(() -> {
            lateSender.send(moveTo(4.2));
            late.undo();
            late.clear();
            lateSender.send(moveTo(4.4));
            answers.remove(1).run();
            answers.remove(0).run();
        });
        assertEquals(List.of(), answers);
        assertEquals(Optional.of("Move desk"), callOnEdt(late::undoName));
    }

    @Test
    void nothingOfAnotherScenarioIsUndoneOrStillExpected() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        runOnEdt(() -> {
            lateSender.send(moveTo(4.2));
            answers.remove(0).run();
            lateSender.send(new Command.SetPlatform(0.3, 0.2, 0.3));
            late.clear();
        });
        assertEquals(Optional.empty(), callOnEdt(late::undoName));
        assertEquals(
                RobotSpec.DEFAULT, callOnEdt(() -> lateSender.pendingEdits().robot()));
        runOnEdt(() -> answers.get(0).run());
        assertEquals(Optional.empty(), callOnEdt(late::undoName), "the answer to a command to the run before");
    }

    @Test
    void oneGestureIsOneEdit() {
        runOnEdt(() -> {
            sender.beginGesture();
            sender.send(moveTo(4.2));
            sender.send(moveTo(4.4));
            sender.endGesture();
            sender.send(moveTo(4.6));
            controller.undo();
        });
        assertEquals(4.4, x());
        runOnEdt(controller::undo);
        assertEquals(4, x());
        assertEquals(Optional.empty(), undoName());
        runOnEdt(controller::redo);
        assertEquals(4.4, x());
    }

    private double x() {
        return world.snapshot().obstacles().get(0).pose().x();
    }

    @Test
    void nudgesInQuickSuccessionAreOneEditAndAPauseEndsIt() {
        runOnEdt(() -> sender.send(moveTo(4.1)));
        now += 900;
        runOnEdt(() -> sender.send(moveTo(4.15)));
        now += 900;
        runOnEdt(() -> sender.send(moveTo(4.2)));
        now += 1100;
        runOnEdt(() -> sender.send(moveTo(4.3)));
        runOnEdt(controller::undo);
        assertEquals(4.2, x());
        runOnEdt(controller::undo);
        assertEquals(4, x());
    }

    private void assertEditCount(int count, Command... commands) {
        runOnEdt(() -> List.of(commands).forEach(sender::send));
        for (int i = 0; i < count; i++) {
            assertTrue(undoName().isPresent(), "edit " + i);
            runOnEdt(controller::undo);
        }
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void stepsOfASpinnerAreOneEdit() {
        assertEditCount(1, new Command.SetPlatform(0.3, 0.2, 0.3), new Command.SetPlatform(0.31, 0.2, 0.3));
        assertEditCount(
                1,
                new Command.ConfigureSensor(FRONT.withRange(0.4)),
                new Command.ConfigureSensor(FRONT.withRange(0.5)));
        assertEditCount(2, new Command.SetPlatform(0.3, 0.2, 0.3), new Command.ConfigureSensor(FRONT.withRange(0.4)));
    }

    @Test
    void obstaclesThatArePlacedInQuickSuccessionAreSeveralEdits() {
        assertEditCount(
                2,
                new Command.PlaceObstacle(LAMP),
                new Command.PlaceObstacle(LAMP.withShape(new ObstacleShape.CircleShape(0.2))));
    }

    @Test
    void changesOfOneSettingOfTheControllerAreOneEdit() {
        WallFollowing spec = WallFollowing.DEFAULT;
        EditTarget distance = target(spec.withDistance(0.3), spec);
        assertTrue(distance.repeatable());
        assertEquals(distance, target(spec.withDistance(0.4), spec.withDistance(0.3)));
        assertNotEquals(distance, target(spec.withPeriod(0.1), spec));
        EditTarget margin = target(spec.withThresholds(spec.thresholds().with(Threshold.AHEAD_MARGIN, 0.1)), spec);
        assertNotEquals(distance, margin);
        assertNotEquals(
                margin, target(spec.withThresholds(spec.thresholds().with(Threshold.TURN_CLEARANCE, 0.2)), spec));
    }

    private static EditTarget target(WallFollowing after, WallFollowing before) {
        return EditTarget.ofGesture(new Command.ConfigureController(after), before);
    }

    @Test
    void savingEndsTheLastEdit() {
        runOnEdt(() -> {
            sender.send(moveTo(4.1));
            controller.endEdit();
            sender.send(moveTo(4.2));
            controller.undo();
        });
        assertEquals(4.1, x());
    }

    @Test
    void switchingASensorOffAndOnIsTwoEdits() {
        runOnEdt(() -> sender.send(new Command.SwitchSensor("front", false)));
        runOnEdt(() -> sender.send(new Command.SwitchSensor("front", true)));
        runOnEdt(controller::undo);
        assertEquals(false, world.robot().sensors().get(0).on());
    }

    @Test
    void aDragThatIsCancelledIsNoEdit() {
        runOnEdt(() -> {
            sender.beginGesture();
            sender.send(moveTo(4.2));
            sender.send(moveTo(4));
            sender.endGesture();
        });
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void aRefusedCommandAndOneThatChangesNothingAreNoEdits() {
        runOnEdt(() -> sender.send(new Command.PlaceObstacle(
                new Obstacle("lamp", new ObstacleShape.CircleShape(0.1), new Pose(2, 2, 0)))));
        runOnEdt(() -> sender.send(new Command.SwitchSensor("front", true)));
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void anUndoOrRedoThatTheWorldRefusesLeavesTheHistoryUnchanged() {
        runOnEdt(() -> sender.send(new Command.RemoveObstacle("desk")));
        longRobot(true);
        runOnEdt(controller::undo);
        assertEquals(List.of(), world.snapshot().obstacles());
        assertEquals(Optional.of("Delete desk"), undoName());
        assertEquals(Optional.empty(), callOnEdt(controller::redoName));
        longRobot(false);
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(3.5, 2, 0));
        runOnEdt(() -> sender.send(new Command.PlaceObstacle(pole)));
        runOnEdt(controller::undo);
        world.execute(new Command.RemoveObstacle("desk"));
        longRobot(true);
        runOnEdt(controller::redo);
        assertEquals(Optional.of("Add pole"), callOnEdt(controller::redoName));
        longRobot(false);
        runOnEdt(controller::redo);
        assertEquals(List.of(pole), world.snapshot().obstacles());
    }

    private static Command addLamp() {
        return new Command.PlaceObstacle(LAMP);
    }

    @Test
    void anEditBeforeOneWhoseUndoIsRefusedCanBeUndone() {
        runOnEdt(() -> {
            sender.send(addLamp());
            sender.send(new Command.RemoveObstacle("desk"));
        });
        longRobot(true);
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Add lamp"), undoName());
        runOnEdt(controller::undo);
        assertEquals(List.of(), world.snapshot().obstacles());
        assertEquals(Optional.of("Delete desk"), undoName(), "it is tried again");
        assertEquals(Optional.of("Add lamp"), callOnEdt(controller::redoName));
        longRobot(false);
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
        assertEquals(Optional.empty(), undoName());
        runOnEdt(controller::redo);
        runOnEdt(controller::redo);
        assertEquals(List.of(LAMP), world.snapshot().obstacles());
    }

    @Test
    void editsWhoseUndoIsRefusedAreTriedInTurn() {
        runOnEdt(() -> {
            sender.send(new Command.PlaceObstacle(
                    new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(3.5, 2, 0))));
            sender.send(new Command.RemoveObstacle("desk"));
            sender.send(new Command.RemoveObstacle("pole"));
        });
        longRobot(true);
        List<Optional<String>> names = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            names.add(undoName());
            runOnEdt(controller::undo);
        }
        Optional<String> pole = Optional.of("Delete pole");
        Optional<String> desk = Optional.of("Delete desk");
        assertEquals(List.of(pole, desk, pole, desk), names);
        longRobot(false);
        runOnEdt(controller::undo);
        runOnEdt(controller::undo);
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void anEditOfTheSameObstacleWaitsForTheOneWhoseUndoIsRefused() {
        runOnEdt(() -> {
            sender.send(addLamp());
            sender.send(moveTo(3.9));
            sender.send(new Command.RemoveObstacle("desk"));
        });
        longRobot(true);
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Add lamp"), undoName());
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Delete desk"), undoName());
        longRobot(false);
        runOnEdt(controller::undo);
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
    }

    /** The second undo was about the desk, which did not exist. */
    @Test
    void anUndoWaitsForTheAnswerToTheOneBefore() {
        List<Runnable> answers = new ArrayList<>();
        CommandSender lateSender = lateSender(answers);
        UndoController late = callOnEdt(() -> new UndoController(lateSender, () -> {}));
        runOnEdt(() -> {
            lateSender.send(moveTo(3.9));
            lateSender.send(new Command.RemoveObstacle("desk"));
            answers.remove(0).run();
            answers.remove(0).run();
        });
        longRobot(true);
        runOnEdt(() -> {
            late.undo();
            late.undo();
        });
        while (!answers.isEmpty()) {
            runOnEdt(() -> answers.remove(0).run());
        }
        assertEquals(Optional.of("Delete desk"), callOnEdt(late::undoName));
        longRobot(false);
        runOnEdt(() -> {
            late.undo();
            late.undo();
        });
        assertEquals(List.of(3.9, 4.0), places(answers));
    }

    @Test
    void aListenerThatFailsBlocksNoLaterUndo() {
        runOnEdt(() -> {
            sender.send(moveTo(3.9));
            sender.send(addLamp());
            controller.setUndoListener(tick -> {
                throw new IllegalStateException("this listener fails");
            });
        });
        assertThrows(AssertionError.class, () -> runOnEdt(controller::undo));
        runOnEdt(() -> {
            controller.setUndoListener(tick -> {});
            controller.undo();
        });
        assertEquals(List.of(DESK), world.snapshot().obstacles());
    }

    @Test
    void aChangeOfTheSetupWaitsForTheEditWhoseUndoIsRefused() {
        runOnEdt(() -> {
            sender.send(addLamp());
            controller.addSetupEdit(() -> "Name", "name", SetupChange.of(() -> {}, () -> {}));
            sender.send(new Command.RemoveObstacle("desk"));
        });
        longRobot(true);
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Delete desk"), undoName());
    }

    @Test
    void aRefusedUndoIsTriedAgainAfterANewEdit() {
        runOnEdt(() -> {
            sender.send(addLamp());
            sender.send(new Command.RemoveObstacle("desk"));
        });
        longRobot(true);
        runOnEdt(controller::undo);
        runOnEdt(() -> sender.send(new Command.SwitchSensor("front", false)));
        runOnEdt(controller::undo);
        assertEquals(Optional.of("Delete desk"), undoName());
    }

    /** Makes the robot so long that it reaches the places of the obstacles, or of its default length. */
    private void longRobot(boolean isLong) {
        assertEquals(
                Optional.empty(),
                world.execute(new Command.SetPlatform(isLong ? 3.9 : 0.25, 0.2, 0.3))
                        .refusal());
    }

    @Test
    void severalCommandsSentTogetherAreOneEdit() {
        runOnEdt(() -> sender.send(List.of(new Command.PlaceObstacle(LAMP), new Command.RemoveObstacle("desk"))));
        assertEquals(Optional.of("2 changes"), undoName());
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
    }

    @Test
    void obstaclesThatWereDeletedTogetherComeBackInTheirOrder() {
        runOnEdt(() -> sender.send(List.of(new Command.PlaceObstacle(LAMP))));
        runOnEdt(() -> sender.send(List.of(
                new Command.RemoveObstacle("desk"),
                new Command.RemoveObstacle("lamp"),
                new Command.SwitchSensor("left", false))));
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK, LAMP), world.snapshot().obstacles());
        runOnEdt(controller::redo);
        runOnEdt(controller::undo);
        assertEquals(List.of(DESK, LAMP), world.snapshot().obstacles());
    }

    @Test
    void repairingTheMotorsOfBothSidesIsOneEditThatUndoRestores() {
        Command left = new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.NoDrive());
        Command right = new Command.InjectMotorFault(MotorSide.RIGHT, new MotorFault.Weak(0.5));
        runOnEdt(() -> sender.send(List.of(left, right)));
        runOnEdt(() -> sender.send(
                List.of(new Command.ClearMotorFaults(MotorSide.LEFT), new Command.ClearMotorFaults(MotorSide.RIGHT))));
        assertEquals(Optional.of("Repair all motors"), undoName());
        runOnEdt(controller::undo);
        assertEquals(
                new MotorFaults(List.of(new MotorFault.NoDrive()), List.of(new MotorFault.Weak(0.5))),
                world.snapshot().motorFaults());
    }

    @Test
    void clearingTheFaultsOfSeveralSensorsIsOneEditThatUndoRestores() {
        runOnEdt(() -> sender.send(List.of(
                new Command.InjectFault("left", new Fault.Dead()),
                new Command.InjectFault("front", new Fault.Dead()))));
        runOnEdt(() -> sender.send(List.of(new Command.ClearFaults("left"), new Command.ClearFaults("front"))));
        assertEquals(Optional.of("Repair 2 sensors"), undoName());
        runOnEdt(controller::undo);
        assertEquals(
                List.of("front", "left"),
                world.snapshot().sensors().stream()
                        .filter(sensor -> !sensor.faults().isEmpty())
                        .map(sensor -> sensor.spec().id())
                        .sorted()
                        .toList());
    }

    /** Returns the name of the edit that commands make. */
    private String nameOfEdit(Command... commands) {
        now += 5000;
        runOnEdt(() -> sender.send(List.of(commands)));
        return undoName().orElseThrow();
    }

    @Test
    void anEditOfASensorOrMotorIsNamedByWhatItChanges() {
        SensorSpec turned = FRONT.withBearing(0.1);
        SensorSpec moved = turned.withMountPosition(new Vector2(0.1, 0.02));
        SensorSpec noisy = moved.withNoise(0.01);
        MotorFault.Weak weak = new MotorFault.Weak(0.5);
        assertEquals("Bearing of front", nameOfEdit(new Command.ConfigureSensor(turned)));
        assertEquals("Position of front", nameOfEdit(new Command.ConfigureSensor(moved)));
        assertEquals("Noise of front", nameOfEdit(new Command.ConfigureSensor(noisy)));
        assertEquals("Settings of front", nameOfEdit(new Command.ConfigureSensor(FRONT.withRange(0.5))));
        assertEquals("Switch left off", nameOfEdit(new Command.SwitchSensor("left", false)));
        assertEquals("Switch left on", nameOfEdit(new Command.SwitchSensor("left", true)));
        assertEquals("Fault in left", nameOfEdit(new Command.InjectFault("left", new Fault.Dead())));
        assertEquals("Repair left", nameOfEdit(new Command.ClearFault("left", new Fault.Dead())));
        assertEquals("Fault in right motors", nameOfEdit(new Command.InjectMotorFault(MotorSide.RIGHT, weak)));
        assertEquals("Repair right motors", nameOfEdit(new Command.ClearMotorFault(MotorSide.RIGHT, weak)));
        assertEquals("Fault in left motors", nameOfEdit(new Command.InjectMotorFault(MotorSide.LEFT, weak)));
        assertEquals("Repair left motors", nameOfEdit(new Command.ClearMotorFaults(MotorSide.LEFT)));
        assertEquals("Change linear velocity", nameOfEdit(new Command.SetPlatform(0.25, 0.2, 0.2)));
        assertEquals("Change platform", nameOfEdit(new Command.SetPlatform(0.3, 0.2, 0.2)));
    }

    @Test
    void anEditOfObstaclesIsNamedByWhatItChanges() {
        Obstacle slow = LAMP.withMotion(new WaypointPath(0.1, true, List.of(new Vector2(5, 1), new Vector2(5, 3))));
        Obstacle fast = slow.withMotion(slow.motion().withSpeed(0.2));
        Obstacle elsewhere = slow.withMotion(new WaypointPath(0.1, true, List.of(new Vector2(5, 2))));
        Obstacle wide = new Obstacle("desk", new ObstacleShape.RectangleShape(0.6, 0.5), DESK.pose());
        Pose rotated = new Pose(5, 3, 1);
        assertEquals("Add lamp", nameOfEdit(new Command.PlaceObstacle(LAMP)));
        assertEquals("Change lamp", nameOfEdit(new Command.PlaceObstacle(slow)));
        assertEquals("Speed of lamp", nameOfEdit(new Command.PlaceObstacle(fast)));
        assertEquals("Change lamp", nameOfEdit(new Command.PlaceObstacle(elsewhere)));
        assertEquals(
                "Change lamp",
                nameOfEdit(new Command.PlaceObstacle(elsewhere.withShape(new ObstacleShape.CircleShape(0.2)))));
        assertEquals(
                "Change 2 obstacles", nameOfEdit(new Command.PlaceObstacle(LAMP), new Command.PlaceObstacle(wide)));
        assertEquals(
                "Move 2 obstacles", nameOfEdit(moveTo(4.1), new Command.MoveObstacle("lamp", new Pose(5, 3.2, 0))));
        assertEquals(
                "Rotate 2 obstacles",
                nameOfEdit(
                        new Command.MoveObstacle("lamp", rotated),
                        new Command.MoveObstacle("desk", new Pose(4.1, 2, 1))));
        assertEquals(
                "Delete 2 obstacles",
                nameOfEdit(new Command.RemoveObstacle("lamp"), new Command.RemoveObstacle("desk")));
        assertEquals("Add 2 obstacles", nameOfEdit(new Command.PlaceObstacle(LAMP), new Command.PlaceObstacle(DESK)));
        assertEquals(
                "2 changes", nameOfEdit(new Command.RemoveObstacle("desk"), new Command.SwitchSensor("left", false)));
    }

    @Test
    void anotherScenarioBeginsWithoutEdits() {
        runOnEdt(() -> sender.send(moveTo(4.1)));
        runOnEdt(controller::clear);
        assertEquals(Optional.empty(), undoName());
    }
}
