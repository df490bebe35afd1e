package faultline.gui.timeline;

import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.gui.theme.UiText;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioLimits;
import faultline.world.Command;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridBagLayout;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JPanel;

/** Asks for the lane, the details and the times of an item. */
final class ItemDialog {

    private final TimelineItem item;
    private final double tick;
    /** The length that an item without an end gets with its end, seconds. */
    private final double newLength;

    private final JPanel form = new JPanel(new GridBagLayout());
    private final JComboBox<Lane> lane = new JComboBox<>();
    private final NumberSpinner from = DetailFields.number("timeline.start");
    private final NumberSpinner until = DetailFields.number("timeline.end");
    private final JCheckBox ends = new JCheckBox(Messages.get("timeline.end"));
    /** Reads the command from the details. */
    private final Supplier<Optional<Command>> details;
    /** The field that has the focus initially: the kind of a fault, which comes first, or else the start. */
    private final Component first;
    /** The time that has been changed last, which is probably the wrong one if the end is before the start. */
    private NumberSpinner changedLast = from;

    private ItemDialog(List<Lane> lanes, TimelineItem item, RobotSpec robot, double tick, double newLength) {
        this.item = item;
        this.tick = tick;
        this.newLength = newLength;
        lanes.stream().filter(other -> item.inLane(other).lane().equals(other)).forEach(lane::addItem);
        lane.setSelectedItem(item.lane());
        if (item.isInterval()) {
            addLaneField();
        }
        DetailFields fields = new DetailFields(form, lane, robot, tick);
        details = fields.add(item.command());
        first = fields.kindOr(from.textField());
        addTimeFields();
    }

    private void addLaneField() {
        String name = item.lane() instanceof Lane.SensorLane ? "faults.sensor" : "timeline.motors";
        lane.getAccessibleContext().setAccessibleName(Messages.get(name));
        lane.setRenderer(NamedChoice.rendererOf(other -> UiText.shortName(other.label()), Lane::label));
        form.add(FormConstraints.label(name, lane), FormConstraints.cell(0, 0));
        form.add(lane, FormConstraints.fillRow(1, 0));
    }

    private void addTimeFields() {
        DetailFields.setTime(from, item.start());
        DetailFields.addRow(form, DetailFields.TIMES_ROW, FormConstraints.label("timeline.start", from), from, "s");
        if (item.isInterval()) {
            DetailFields.setTime(until, item.isOpen() ? firstEnd() : item.end());
            DetailFields.addRow(form, DetailFields.TIMES_ROW + 1, ends, until, "s");
            ends.setSelected(!item.isOpen());
            until.setEnabled(ends.isSelected());
            ends.addActionListener(event -> updateEnd());
            from.addChangeListener(event -> changedLast = from);
            until.addChangeListener(event -> changedLast = until);
        }
    }

    /** Returns an end after the start that is shown, seconds. */
    private double firstEnd() {
        return Math.min(from.doubleValue() + newLength, ScenarioLimits.MAX_DURATION);
    }

    private void updateEnd() {
        until.setEnabled(ends.isSelected());
        if (ends.isSelected() && item.isOpen() && until.doubleValue() <= from.doubleValue()) {
            DetailFields.setTime(until, firstEnd());
        }
    }

    /**
     * Shows the dialog for an item in one of some lanes, waits for the answer, and returns the item with other values;
     * empty if cancelled. The length of a tick, seconds, is the shortest interval; an item without an end is offered
     * the new length, seconds.
     */
    static Optional<TimelineItem> showDialog(
            Component parent, List<Lane> lanes, TimelineItem item, RobotSpec robot, double tick, double newLength) {
        return new ItemDialog(lanes, item, robot, tick, newLength).show(parent);
    }

    private Optional<TimelineItem> show(Component parent) {
        // Fields stay where they are when the dialog is higher than they need.
        JPanel content = new JPanel(new BorderLayout());
        content.add(form, BorderLayout.NORTH);
        boolean accepted =
                FormDialog.showDialog(parent, TimelineText.dialogTitle(item), content, first, this::findProblem);
        return accepted ? read() : Optional.empty();
    }

    /** Commits what is being typed, and returns what is wrong; empty if nothing is. */
    private Optional<FormDialog.FormProblem> findProblem() {
        Optional<FormDialog.FormProblem> refused = FormDialog.findRefusedNumber(form);
        if (refused.isPresent()) {
            return refused;
        }
        return endsBeforeItStarts()
                ? Optional.of(new FormDialog.FormProblem(Messages.get("timeline.order"), changedLast.textField()))
                : Optional.empty();
    }

    private boolean endsBeforeItStarts() {
        return item.isInterval() && ends.isSelected() && until.doubleValue() <= from.doubleValue();
    }

    /** Returns the item, or nothing if a value is invalid. */
    private Optional<TimelineItem> read() {
        if (!from.commitValidEdit() || ends.isSelected() && !until.commitValidEdit() || endsBeforeItStarts()) {
            return Optional.empty();
        }
        double start = DetailFields.valueOf(from, item.start());
        double end = ends.isSelected()
                ? Math.max(DetailFields.valueOf(until, item.end()), start + tick)
                : Double.POSITIVE_INFINITY;
        return details.get()
                .map(command -> new TimelineItem(command, start, start).withTimes(start, end))
                .map(read -> item.isInterval() ? read.inLane((Lane) lane.getSelectedItem()) : read);
    }
}
