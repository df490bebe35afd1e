package faultline.gui.timeline;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.gui.panel.ControllerForm;
import faultline.gui.panel.FaultFields;
import faultline.gui.panel.FormConstraints;
import faultline.gui.panel.FormDialog;
import faultline.gui.panel.NamedChoice;
import faultline.gui.panel.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;

/** Asks for the details of an item: the sensor and the fault, the pose of a move, or the controller, and the times. */
final class ItemDialog {

    private static final double MAX_TIME = 1e6;
    private static final int COLUMNS = 8;
    private static final int FAULT_ROWS = 4;

    private final TimelineItem item;
    private final RobotSpec robot;
    private final double tick;
    private final JPanel form = new JPanel(new GridBagLayout());
    private final JComboBox<Lane> lane = new JComboBox<>();
    private final FaultFields<FaultKind, Fault> fault = FaultFields.forSensors();
    private final FaultFields<MotorFaultKind, MotorFault> motorFault = FaultFields.forMotors();
    private final List<NumberSpinner> pose = new ArrayList<>();
    private final NumberSpinner from = time("timeline.start");
    private final NumberSpinner until = time("timeline.end");
    private final JCheckBox ends = new JCheckBox(Messages.get("timeline.end"));
    private final ControllerForm controllerForm = new ControllerForm(this::setController);
    private ControllerSpec.BuiltIn controller;
    private int row;

    private ItemDialog(List<Lane> lanes, TimelineItem item, RobotSpec robot, double tick) {
        this.item = item;
        this.robot = robot;
        this.tick = tick;
        lanes.stream().filter(other -> item.inLane(other).lane().equals(other)).forEach(lane::addItem);
        addFaultFields();
        addPoseFields();
        addField(FormConstraints.label("timeline.start", from), from, "s");
        from.setLimits(0, MAX_TIME, item.start());
        if (item.isInterval()) {
            addField(ends, until, "s");
            until.setLimits(0, MAX_TIME, item.isOpen() ? item.start() : item.end());
            ends.setSelected(!item.isOpen());
            until.setEnabled(ends.isSelected());
            ends.addActionListener(event -> until.setEnabled(ends.isSelected()));
        }
        addControllerFields();
    }

    /**
     * Shows the dialog and waits for the answer.
     *
     * @param parent the component behind the dialog
     * @param lanes the lanes to choose from
     * @param item the initial values
     * @param robot the robot
     * @param tick the length of a tick, the shortest interval, seconds
     * @return the item with other values, empty if cancelled
     */
    static Optional<TimelineItem> showDialog(
            Component parent, List<Lane> lanes, TimelineItem item, RobotSpec robot, double tick) {
        return new ItemDialog(lanes, item, robot, tick).show(parent);
    }

    private Optional<TimelineItem> show(Component parent) {
        // The start has the focus initially: the kind would take the arrow keys.
        Optional<TimelineItem> result;
        boolean accepted;
        do {
            accepted = FormDialog.showDialog(parent, TimelineText.title(item), form, from.textField());
            result = accepted ? read() : Optional.empty();
            if (accepted && endsBeforeItStarts()) {
                JOptionPane.showMessageDialog(
                        parent, Messages.get("timeline.order"), TimelineText.title(item), JOptionPane.WARNING_MESSAGE);
            }
        } while (accepted && result.isEmpty());
        return result;
    }

    private boolean endsBeforeItStarts() {
        return item.isInterval() && ends.isSelected() && until.doubleValue() <= from.doubleValue();
    }

    private static NumberSpinner time(String key) {
        return new NumberSpinner("0.00##", 0, MAX_TIME, 1, ignored -> {})
                .withName(key)
                .withColumns(COLUMNS)
                .keepInvalidText();
    }

    private void addField(Component label, Component field, String unit) {
        form.add(label, FormConstraints.cell(0, row));
        form.add(field, FormConstraints.cell(1, row));
        form.add(new JLabel(unit), FormConstraints.fillCell(2, row));
        row++;
    }

    private void addFaultFields() {
        if (!item.isInterval()) {
            return;
        }
        String name = item.lane() instanceof Lane.OfSensor ? "faults.sensor" : "timeline.motors";
        lane.setSelectedItem(item.lane());
        lane.getAccessibleContext().setAccessibleName(Messages.get(name));
        lane.setRenderer(NamedChoice.rendererOf(Lane::label));
        form.add(FormConstraints.label(name, lane), FormConstraints.cell(0, row));
        form.add(lane, FormConstraints.fillRow(1, row));
        row++;
        if (item.command() instanceof Command.InjectFault inject) {
            lane.addActionListener(event -> updateRange());
            updateRange();
            fault.setFault(
                    inject.fault().kind(),
                    inject.fault().value(),
                    inject.fault().length());
            fault.addTo(form, row, 0);
        } else if (item.command() instanceof Command.InjectMotorFault inject) {
            motorFault.setFault(inject.fault().kind(), inject.fault().value(), 0);
            motorFault.addTo(form, row, 0);
        }
        row += FAULT_ROWS;
    }

    private void updateRange() {
        if (lane.getSelectedItem() instanceof Lane.OfSensor sensor) {
            robot.sensor(sensor.id()).ifPresent(spec -> fault.setRange(spec.range()));
        }
    }

    private void addPoseFields() {
        if (item.command() instanceof Command.MoveObstacle move) {
            addPoseField("timeline.x", "m", move.pose().x());
            addPoseField("timeline.y", "m", move.pose().y());
            addPoseField("timeline.heading", "°", Math.toDegrees(move.pose().heading()));
        }
    }

    private void addPoseField(String key, String unit, double value) {
        NumberSpinner field = time(key);
        field.setLimits(-MAX_TIME, MAX_TIME, value);
        addField(FormConstraints.label(key, field), field, unit);
        pose.add(field);
    }

    /** Adds the fields of a controller in two columns. */
    private void addControllerFields() {
        if (item.command() instanceof Command.ConfigureController change) {
            List<JComponent> sections = controllerForm.sections();
            JPanel columns = new JPanel(new GridLayout(1, 2));
            columns.add(column(sections.get(0), sections.get(1)));
            columns.add(column(sections.get(2), sections.get(3)));
            form.add(columns, FormConstraints.fillRow(0, row++));
            NumberSpinner.findIn(columns).forEach(NumberSpinner::keepInvalidText);
            setController(change.controller());
        }
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

    /** Returns the item, or nothing if a value is invalid. */
    private Optional<TimelineItem> read() {
        if (!pose.stream().allMatch(NumberSpinner::commitValidEdit)) {
            return Optional.empty();
        }
        if (controller != null && !NumberSpinner.findIn(form).allMatch(NumberSpinner::commitValidEdit)) {
            return Optional.empty();
        }
        if (!from.commitValidEdit() || ends.isSelected() && !until.commitValidEdit() || endsBeforeItStarts()) {
            return Optional.empty();
        }
        double start = from.doubleValue();
        double end = ends.isSelected() ? Math.max(until.doubleValue(), start + tick) : Double.POSITIVE_INFINITY;
        return readCommand()
                .map(command -> new TimelineItem(command, start, start).withTimes(start, end))
                .map(read -> item.isInterval() ? read.inLane((Lane) lane.getSelectedItem()) : read);
    }

    private Optional<? extends Command> readCommand() {
        if (item.command() instanceof Command.InjectFault inject) {
            return fault.commitFault().map(valid -> new Command.InjectFault(inject.sensor(), valid));
        }
        if (item.command() instanceof Command.InjectMotorFault inject) {
            return motorFault.commitFault().map(valid -> new Command.InjectMotorFault(inject.motor(), valid));
        }
        if (item.command() instanceof Command.MoveObstacle move) {
            return Optional.of(new Command.MoveObstacle(
                    move.obstacle(),
                    new Pose(
                            pose.get(0).doubleValue(),
                            pose.get(1).doubleValue(),
                            heading(move.pose().heading()))));
        }
        return Optional.of(controller == null ? item.command() : new Command.ConfigureController(controller));
    }

    /** Returns the heading of the field; the old one, to the bit, if the field has not been changed. */
    private double heading(double before) {
        double degrees = pose.get(2).doubleValue();
        return degrees == Math.toDegrees(before) ? before : Math.toRadians(degrees);
    }
}
