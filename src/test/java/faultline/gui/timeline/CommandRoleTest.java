package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.EdtChecker;
import faultline.gui.form.NumberSpinner;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.GridBagLayout;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** The lane, the interval, the label and the dialog of every kind of command. */
@ExtendWith(EdtChecker.class)
class CommandRoleTest {

    private static final Fault STUCK = new Fault.Stuck(0.3);
    private static final MotorFault NO_DRIVE = new MotorFault.NoDrive();
    private static final Obstacle DESK = new Obstacle("desk", new ObstacleShape.CircleShape(0.5), Pose.ORIGIN);

    /**
     * A command and what it is on the time line.
     *
     * @param command the command
     * @param lane the label of its lane
     * @param effect what it changes
     * @param endings the commands that end it
     * @param label its label
     * @param details whether the dialog has fields for its details
     */
    private record Row(
            Command command,
            String lane,
            CommandRole.ChangedProperty effect,
            List<Command> endings,
            String label,
            boolean details) {}

    private static final List<Row> ROWS = List.of(
            row(
                    new Command.InjectFault("left", STUCK),
                    "left",
                    CommandRole.ChangedProperty.FAULT,
                    List.of(new Command.ClearFault("left", STUCK), new Command.ClearFaults("left")),
                    "stuck 0.30 m",
                    true),
            row(
                    new Command.InjectMotorFault(MotorSide.LEFT, NO_DRIVE),
                    "left motors",
                    CommandRole.ChangedProperty.FAULT,
                    List.of(
                            new Command.ClearMotorFault(MotorSide.LEFT, NO_DRIVE),
                            new Command.ClearMotorFaults(MotorSide.LEFT)),
                    "dead",
                    true),
            row(
                    new Command.SwitchSensor("left", false),
                    "left",
                    CommandRole.ChangedProperty.SWITCH,
                    List.of(new Command.SwitchSensor("left", true)),
                    "switched off",
                    false),
            moment(new Command.SwitchSensor("left", true), "left", CommandRole.ChangedProperty.SWITCH, false),
            moment(new Command.ClearFault("left", STUCK), "left", CommandRole.ChangedProperty.FAULT, false),
            moment(new Command.ClearFaults("left"), "left", CommandRole.ChangedProperty.FAULT, false),
            moment(
                    new Command.ClearMotorFault(MotorSide.LEFT, NO_DRIVE),
                    "left motors",
                    CommandRole.ChangedProperty.FAULT,
                    false),
            moment(
                    new Command.ClearMotorFaults(MotorSide.LEFT),
                    "left motors",
                    CommandRole.ChangedProperty.FAULT,
                    false),
            moment(
                    new Command.ConfigureSensor(RobotSpec.DEFAULT.sensors().get(0)),
                    "front",
                    CommandRole.ChangedProperty.SETTING,
                    false),
            moment(new Command.SetPlatform(1, 1, 1), "other", CommandRole.ChangedProperty.SETTING, false),
            moment(
                    new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT),
                    "other",
                    CommandRole.ChangedProperty.SETTING,
                    true),
            moment(
                    new Command.MoveObstacle("desk", new Pose(1.000001, 2, 0.1)),
                    "other",
                    CommandRole.ChangedProperty.OBSTACLE,
                    true),
            moment(new Command.PlaceObstacle(DESK), "other", CommandRole.ChangedProperty.OBSTACLE, false),
            moment(new Command.RemoveObstacle("desk"), "other", CommandRole.ChangedProperty.OBSTACLE, false));

    private static Row row(
            Command command,
            String lane,
            CommandRole.ChangedProperty effect,
            List<Command> endings,
            String label,
            boolean details) {
        return new Row(command, lane, effect, endings, label, details);
    }

    /** A command that is over at once has the label of the event log. */
    private static Row moment(Command command, String lane, CommandRole.ChangedProperty effect, boolean details) {
        return new Row(command, lane, effect, List.of(), CommandText.format(command), details);
    }

    @Test
    void everyKindOfCommandIsExpectedHere() {
        Set<Class<?>> kinds = Stream.of(Command.class, Command.SensorCommand.class)
                .flatMap(type -> Stream.of(type.getPermittedSubclasses()))
                .filter(Class::isRecord)
                .collect(Collectors.toCollection(HashSet::new));
        assertTrue(kinds.size() > 1);
        ROWS.forEach(row -> kinds.remove(row.command().getClass()));
        assertEquals(Set.of(), kinds);
    }

    @Test
    void theLabelOfSettingsOfASensorHasAllThatCanBeChanged() {
        SensorSpec front = RobotSpec.DEFAULT.sensor("front").orElseThrow();
        SensorSpec changed = front.withRange(0.625)
                .withCone(Degrees.toRadians(12.5))
                .withBearing(Degrees.toRadians(-4))
                .withMountPosition(new Vector2(0.1, -0.025))
                .withNoise(0.0025);
        assertEquals(
                "front: range 0.625 m, cone 12.5°, bearing -4.0°, at 0.10, -0.025 m, noise 0.0025 m",
                CommandText.format(new Command.ConfigureSensor(changed)));
    }

    @Test
    void everyKindHasItsLaneItsEndsAndItsLabel() {
        for (Row row : ROWS) {
            CommandRole role = CommandRole.of(row.command());
            assertEquals(row.lane(), role.lane().label(), row.toString());
            assertEquals(row.effect(), role.effect(), row.toString());
            assertEquals(row.endings(), role.endings(), row.toString());
            assertEquals(row.label(), TimelineText.label(TimelineItem.from(row.command(), 0)), row.toString());
            assertFalse(row.label().isBlank(), row.toString());
        }
    }

    @Test
    void aCommandStaysWhatItIsInItsLaneAndInOneWhereItCannotBe() {
        for (Row row : ROWS) {
            CommandRole role = CommandRole.of(row.command());
            assertEquals(row.command(), role.inLane().apply(role.lane()));
            assertEquals(row.command(), role.inLane().apply(Lane.OTHER));
        }
        Lane rear = new Lane.SensorLane("rear");
        Lane right = new Lane.MotorLane(MotorSide.RIGHT);
        assertEquals(
                List.of(
                        new Command.InjectFault("rear", STUCK),
                        new Command.InjectMotorFault(MotorSide.LEFT, NO_DRIVE),
                        new Command.SwitchSensor("rear", false)),
                ROWS.stream().limit(3).map(row -> inLane(row, rear)).toList());
        assertEquals(
                List.of(
                        new Command.InjectFault("left", STUCK),
                        new Command.InjectMotorFault(MotorSide.RIGHT, NO_DRIVE),
                        new Command.SwitchSensor("left", false)),
                ROWS.stream().limit(3).map(row -> inLane(row, right)).toList());
    }

    private static Command inLane(Row row, Lane lane) {
        return CommandRole.of(row.command()).inLane().apply(lane);
    }

    @Test
    void theDialogHasFieldsForTheDetailsThatItCanChangeAndReturnsUnchangedOnesToTheBit() {
        for (Row row : ROWS) {
            JPanel form = callOnEdt(() -> new JPanel(new GridBagLayout()));
            Optional<Command> read = callOnEdt(() -> new DetailFields(form, new JComboBox<>(), RobotSpec.DEFAULT, 0.01)
                    .add(row.command())
                    .get());
            assertEquals(row.details(), NumberSpinner.findIn(form).findAny().isPresent(), row.toString());
            assertEquals(Optional.of(row.command()), read);
        }
    }

    /** Returns the move of a dialog after a text was typed into one of the fields of x, y and heading. */
    private static Optional<Command> typedMove(int field, String text) {
        Command move = new Command.MoveObstacle("desk", new Pose(1, 2, 0));
        return callOnEdt(() -> {
            JPanel form = new JPanel(new GridBagLayout());
            Supplier<Optional<Command>> details =
                    new DetailFields(form, new JComboBox<>(), RobotSpec.DEFAULT, 0.01).add(move);
            NumberSpinner.findIn(form).toList().get(field).textField().setText(text);
            return details.get();
        });
    }

    @Test
    void aHeadingIsTypedInDegreesAsInAFile() {
        assertEquals(
                Optional.of(new Command.MoveObstacle("desk", new Pose(1, 2, Degrees.toRadians(0.03)))),
                typedMove(2, "0.03"));
    }

    @Test
    void aPlaceBeyondThoseOfAFileIsRefused() {
        assertEquals(Optional.of(new Command.MoveObstacle("desk", new Pose(-100_000, 2, 0))), typedMove(0, "-100000"));
        assertEquals(Optional.empty(), typedMove(1, "100001"));
    }
}
