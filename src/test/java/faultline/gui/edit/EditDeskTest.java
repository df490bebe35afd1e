package faultline.gui.edit;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Session.Outcome;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The edit desk before a world that does what it is told at once. */
class EditDeskTest {

    private static final Obstacle DESK = new Obstacle("desk", new ObstacleShape.Rectangle(0.5, 0.5), new Pose(4, 2, 0));
    private static final Obstacle LAMP = new Obstacle("lamp", new ObstacleShape.Circle(0.1), new Pose(5, 3, 0));
    private static final SensorSpec FRONT = RobotSpec.DEFAULT.sensors().get(0);

    private final World world = new World(new WorldSpec(6, 4, true, 1, List.of(DESK)), RobotSpec.DEFAULT, new Pose(2, 2, 0), 0.01, 1);
    private long now;
    private final EditDesk desk = onEdt(() -> new EditDesk(this::carryOut, () -> { }, () -> now));

    private void carryOut(List<Command> commands, Consumer<List<Outcome>> told) {
        told.accept(commands.stream().map(command -> new Outcome(1, command, world.undoing(command), world.apply(command))).toList());
    }

    private static Command moveTo(double x) {
        return new Command.MoveObstacle("desk", new Pose(x, 2, 0));
    }

    private Optional<String> undoName() {
        return onEdt(desk::undoName);
    }

    @Test
    void tenEditsAreTakenBackOneByOneAndDoneAgain() {
        List<Command> edits = List.of(moveTo(4.5), new Command.MoveObstacle("desk", new Pose(4.5, 2, 1)),
                new Command.PutObstacle(LAMP), new Command.PutObstacle(new Obstacle("lamp", new ObstacleShape.Circle(0.3), LAMP.pose())),
                new Command.SwitchSensor("left", false), new Command.TuneSensor(FRONT.withRange(0.4)),
                new Command.TuneSensor(FRONT.withRange(0.4).withCone(0.5)), new Command.InjectFault("front", new Fault.Stuck(0.3)),
                new Command.SetPlatform(0.3, 0.2, 0.3), new Command.RemoveObstacle("desk"));
        List<Snapshot> states = new ArrayList<>(List.of(world.snapshot()));
        List<String> names = new ArrayList<>();
        for (Command edit : edits) {
            now += 5000;
            edt(() -> desk.send(edit));
            states.add(world.snapshot());
            names.add(undoName().orElseThrow());
        }
        assertEquals(List.of("Move desk", "Turn desk", "Add lamp", "Change lamp", "Switch left off", "Range of front", "Cone of front",
                "Fault in front", "Change platform", "Delete desk"), names);
        for (int done = 9; done >= 0; done--) {
            edt(desk::undo);
            assertEquals(withoutOrder(states.get(done)), withoutOrder(world.snapshot()));
        }
        assertEquals(Optional.empty(), undoName());
        for (int done = 1; done <= 10; done++) {
            edt(desk::redo);
            assertEquals(withoutOrder(states.get(done)), withoutOrder(world.snapshot()));
        }
        assertEquals(Optional.empty(), onEdt(desk::redoName));
    }

    /** An obstacle that comes back is drawn last. */
    private static List<Object> withoutOrder(Snapshot world) {
        return List.of(java.util.Set.copyOf(world.obstacles()), world.robot(), world.sensors());
    }

    @Test
    void whatOneHandDoesIsOneEdit() {
        edt(() -> {
            desk.begin();
            desk.send(moveTo(4.2));
            desk.send(moveTo(4.4));
            desk.end();
            desk.send(moveTo(4.6));
            desk.undo();
        });
        assertEquals(4.4, x());
        edt(desk::undo);
        assertEquals(4, x());
        assertEquals(Optional.empty(), undoName());
        edt(desk::redo);
        assertEquals(4.4, x());
    }

    private double x() {
        return world.snapshot().obstacles().get(0).pose().x();
    }

    @Test
    void nudgesInQuickSuccessionAreOneEditAndAPauseEndsIt() {
        edt(() -> desk.send(moveTo(4.1)));
        now += 900;
        edt(() -> desk.send(moveTo(4.2)));
        now += 1100;
        edt(() -> desk.send(moveTo(4.3)));
        edt(desk::undo);
        assertEquals(4.2, x());
        edt(desk::undo);
        assertEquals(4, x());
    }

    @Test
    void savingSealsTheLastEdit() {
        edt(() -> {
            desk.send(moveTo(4.1));
            desk.seal();
            desk.send(moveTo(4.2));
            desk.undo();
        });
        assertEquals(4.1, x());
    }

    @Test
    void switchingThereAndBackIsTwoEdits() {
        edt(() -> desk.send(new Command.SwitchSensor("front", false)));
        edt(() -> desk.send(new Command.SwitchSensor("front", true)));
        edt(desk::undo);
        assertEquals(false, world.robot().sensors().get(0).on());
    }

    @Test
    void aDragThatIsCancelledIsNoEdit() {
        edt(() -> {
            desk.begin();
            desk.send(moveTo(4.2));
            desk.send(moveTo(4));
            desk.end();
        });
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void whatIsRefusedIsNoEditAndWhatChangesNothingNeither() {
        edt(() -> desk.send(new Command.PutObstacle(new Obstacle("lamp", new ObstacleShape.Circle(0.1), new Pose(2, 2, 0)))));
        edt(() -> desk.send(new Command.SwitchSensor("front", true)));
        assertEquals(Optional.empty(), undoName());
    }

    @Test
    void whatTheWorldRefusesToUndoOrToDoAgainStandsWhereItStood() {
        edt(() -> desk.send(new Command.RemoveObstacle("desk")));
        longRobot(true);
        edt(desk::undo);
        assertEquals(List.of(), world.snapshot().obstacles());
        assertEquals(Optional.of("Delete desk"), undoName());
        assertEquals(Optional.empty(), onEdt(desk::redoName));
        longRobot(false);
        edt(desk::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
        Obstacle pole = new Obstacle("pole", new ObstacleShape.Circle(0.1), new Pose(3.5, 2, 0));
        edt(() -> desk.send(new Command.PutObstacle(pole)));
        edt(desk::undo);
        world.apply(new Command.RemoveObstacle("desk"));
        longRobot(true);
        edt(desk::redo);
        assertEquals(Optional.of("Add pole"), onEdt(desk::redoName));
        longRobot(false);
        edt(desk::redo);
        assertEquals(List.of(pole), world.snapshot().obstacles());
    }

    /** A robot so long that it reaches where the obstacles were, or of its usual length. */
    private void longRobot(boolean isLong) {
        assertEquals(Optional.empty(), world.apply(new Command.SetPlatform(isLong ? 3.9 : 0.25, 0.2, 0.3)));
    }

    @Test
    void severalCommandsSentTogetherAreOneEdit() {
        edt(() -> desk.send(List.of(new Command.PutObstacle(LAMP), new Command.RemoveObstacle("desk"))));
        assertEquals(Optional.of("2 changes"), undoName());
        edt(desk::undo);
        assertEquals(List.of(DESK), world.snapshot().obstacles());
    }

    @Test
    void mendingSeveralSensorsIsOneEditThatBreaksThemAgainWhenItIsUndone() {
        edt(() -> desk.send(List.of(new Command.InjectFault("left", new Fault.Dead()), new Command.InjectFault("front", new Fault.Dead()))));
        edt(() -> desk.send(List.of(new Command.ClearFaults("left"), new Command.ClearFaults("front"))));
        assertEquals(Optional.of("Mend 2 sensors"), undoName());
        edt(desk::undo);
        assertEquals(List.of("front", "left"), world.snapshot().sensors().stream().filter(sensor -> !sensor.faults().isEmpty())
                .map(sensor -> sensor.spec().id()).sorted().toList());
    }

    @Test
    void anotherScenarioBeginsWithoutEdits() {
        edt(() -> desk.send(moveTo(4.1)));
        edt(desk::forget);
        assertEquals(Optional.empty(), undoName());
    }
}
