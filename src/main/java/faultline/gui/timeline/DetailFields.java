package faultline.gui.timeline;

import faultline.control.ControllerSpec;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.panel.ControllerForm;
import faultline.gui.panel.FaultFields;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioLimits;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** Adds the fields for the details of a command to a form: a fault, the pose of a move, or the controller. */
final class DetailFields {

    /** The row of the start, between the details and the fields of a controller; the end is in the next one. */
    static final int TIMES_ROW = 6;

    private static final int FIRST_ROW = 1;
    private static final int CONTROLLER_ROW = TIMES_ROW + 2;
    /** The greatest angle of a file, in either direction. */
    private static final double MAX_DEGREES = 1e6;

    private static final double HALF_DECIMAL = 0.5e-4;
    private static final int COLUMNS = 8;

    private final JPanel form;
    private final JComboBox<Lane> lane;
    private final RobotSpec robot;
    private final double tick;
    private final ControllerForm controllerForm = new ControllerForm(this::setController);
    private ControllerSpec.BuiltIn controller;
    /** The choice of the kind of a fault; null if the command is no fault. */
    private JComponent kind;

    DetailFields(JPanel form, JComboBox<Lane> lane, RobotSpec robot, double tick) {
        this.form = form;
        this.lane = lane;
        this.robot = robot;
        this.tick = tick;
    }

    /** Adds the fields of a command, and returns what reads it from them; it returns nothing if a value is invalid. */
    Supplier<Optional<Command>> add(Command command) {
        if (command instanceof Command.InjectFault injected) {
            return addFault(injected);
        }
        if (command instanceof Command.InjectMotorFault injected) {
            return addMotorFault(injected);
        }
        if (command instanceof Command.MoveObstacle moved) {
            return addPose(moved);
        }
        return command instanceof Command.ConfigureController configured
                ? addController(configured)
                : () -> Optional.of(command);
    }

    /** Returns the choice of the kind of the fault, or another field if the command is no fault. */
    Component kindOr(Component other) {
        return kind == null ? other : kind;
    }

    /** Returns a field for a number, initially a time in seconds. */
    static NumberSpinner number(String key) {
        return new NumberSpinner("0.00##", 0, ScenarioLimits.MAX_DURATION, 1, ignored -> {})
                .withName(key)
                .withColumns(COLUMNS)
                .keepInvalidText();
    }

    /** Shows a time, seconds. */
    static void setTime(NumberSpinner field, double value) {
        field.setLimits(0, ScenarioLimits.MAX_DURATION, value);
    }

    /** Returns the number of a field; the old one, to the bit, if the field still shows it in its four decimals. */
    static double valueOf(NumberSpinner field, double old) {
        return Math.abs(field.doubleValue() - old) <= HALF_DECIMAL ? old : field.doubleValue();
    }

    static void addRow(JPanel form, int row, Component label, Component field, String unit) {
        form.add(label, FormConstraints.cell(0, row));
        form.add(field, FormConstraints.cell(1, row));
        form.add(new JLabel(unit), FormConstraints.fillCell(2, row));
    }

    private Supplier<Optional<Command>> addFault(Command.InjectFault command) {
        FaultFields<FaultKind, Fault> fault = FaultFields.forSensors();
        lane.addActionListener(event -> updateRange(fault));
        updateRange(fault);
        Fault old = command.fault();
        fault.setFault(old.kind(), old.value(), old.length());
        kind = fault.kindField();
        fault.addWithDescription(form, FIRST_ROW);
        return () -> fault.commitFault().map(valid -> new Command.InjectFault(command.sensor(), valid));
    }

    private void updateRange(FaultFields<FaultKind, Fault> fault) {
        if (lane.getSelectedItem() instanceof Lane.SensorLane sensor) {
            robot.sensor(sensor.id()).ifPresent(spec -> fault.setRange(spec.range()));
        }
    }

    private Supplier<Optional<Command>> addMotorFault(Command.InjectMotorFault command) {
        FaultFields<MotorFaultKind, MotorFault> fault = FaultFields.forMotors();
        fault.setFault(command.fault().kind(), command.fault().value(), 0);
        kind = fault.kindField();
        fault.addWithDescription(form, FIRST_ROW);
        return () -> fault.commitFault().map(valid -> new Command.InjectMotorFault(command.motor(), valid));
    }

    private Supplier<Optional<Command>> addPose(Command.MoveObstacle command) {
        Pose old = command.pose();
        double oldDegrees = Math.toDegrees(old.heading());
        NumberSpinner x = addPoseField(FIRST_ROW, "timeline.x", "m", ScenarioLimits.MAX_COORDINATE, old.x());
        NumberSpinner y = addPoseField(FIRST_ROW + 1, "timeline.y", "m", ScenarioLimits.MAX_COORDINATE, old.y());
        NumberSpinner heading = addPoseField(FIRST_ROW + 2, "timeline.heading", "°", MAX_DEGREES, oldDegrees);
        return () -> {
            if (!x.commitValidEdit() || !y.commitValidEdit() || !heading.commitValidEdit()) {
                return Optional.empty();
            }
            double degrees = valueOf(heading, oldDegrees);
            double radians = degrees == oldDegrees ? old.heading() : Degrees.toRadians(degrees);
            Pose pose = new Pose(valueOf(x, old.x()), valueOf(y, old.y()), radians);
            return Optional.of(new Command.MoveObstacle(command.obstacle(), pose));
        };
    }

    private NumberSpinner addPoseField(int row, String key, String unit, double max, double value) {
        NumberSpinner field = number(key);
        field.setLimits(-max, max, value);
        addRow(form, row, FormConstraints.label(key, field), field, unit);
        return field;
    }

    /** Adds the fields of a controller in two columns. */
    private Supplier<Optional<Command>> addController(Command.ConfigureController command) {
        List<JComponent> sections = controllerForm.sections();
        JPanel columns = new JPanel(new GridLayout(1, 2));
        columns.add(column(sections.get(0), sections.get(1)));
        columns.add(column(sections.get(2), sections.get(3)));
        form.add(columns, FormConstraints.fillRow(0, CONTROLLER_ROW));
        NumberSpinner.findIn(columns).forEach(NumberSpinner::keepInvalidText);
        setController(command.controller());
        return () -> NumberSpinner.findIn(columns).allMatch(NumberSpinner::commitValidEdit)
                ? Optional.of(new Command.ConfigureController(controller))
                : Optional.empty();
    }

    private static JPanel column(JComponent upper, JComponent lower) {
        JPanel sections = new JPanel(new BorderLayout());
        sections.add(upper, BorderLayout.NORTH);
        sections.add(lower, BorderLayout.CENTER);
        JPanel column = new JPanel(new BorderLayout());
        column.add(sections, BorderLayout.NORTH);
        return column;
    }

    private void setController(ControllerSpec.BuiltIn changed) {
        controller = changed;
        controllerForm.setController(changed, robot, tick);
    }
}
