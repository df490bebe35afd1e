package faultline.gui.panel;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.change.TimelineEvents;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.io.DecimalText;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.Component;
import java.awt.GridBagConstraints;
import java.awt.KeyboardFocusManager;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

/**
 * Active faults, oldest first for each sensor or side, each with the time that remains, if the timeline ends the fault,
 * and a button that repairs it.
 */
public final class FaultList extends JPanel {

    private static final GlyphIcon WARNING_ICON = new GlyphIcon(Glyph.WARNING, 16, colours -> colours.warning());
    private static final GlyphIcon REMOVE_ICON = new GlyphIcon(Glyph.REMOVE, 14, colours -> colours.text());

    private final transient CommandSender sender;
    private transient List<ListedFault> shownFaults = List.of();
    private final transient List<RemainingTime> remainingTimes = new ArrayList<>();
    /** The buttons that repair the faults, in their order. */
    private final List<JButton> repairButtons = new ArrayList<>();

    private transient List<TimedCommand> timeline = List.of();
    /** The present time, seconds. */
    private double now;
    /** The first end of a fault, seconds. */
    private double firstEnd = Double.POSITIVE_INFINITY;

    /** An active fault. */
    private sealed interface RepairableFault {

        /** Returns the name of what has the fault. */
        String owner();

        /** Returns the fault in the user's language. */
        String text();

        Command injection();

        Command repair();

        /** Returns what repairs this fault and all others of the same sensor or side. */
        Command repairAll();

        default String description() {
            return owner() + ": " + text();
        }
    }

    /** A fault of a sensor. */
    private record SensorFault(String owner, Fault fault) implements RepairableFault {

        @Override
        public String text() {
            return FaultText.format(fault);
        }

        @Override
        public Command injection() {
            return new Command.InjectFault(owner, fault);
        }

        @Override
        public Command repair() {
            return new Command.ClearFault(owner, fault);
        }

        @Override
        public Command repairAll() {
            return new Command.ClearFaults(owner);
        }
    }

    /** A fault of the motors of a side. */
    private record SideFault(MotorSide side, MotorFault fault) implements RepairableFault {

        @Override
        public String owner() {
            return FaultText.motors(side);
        }

        @Override
        public String text() {
            return FaultText.format(fault);
        }

        @Override
        public Command injection() {
            return new Command.InjectMotorFault(side, fault);
        }

        @Override
        public Command repair() {
            return new Command.ClearMotorFault(side, fault);
        }

        @Override
        public Command repairAll() {
            return new Command.ClearMotorFaults(side);
        }
    }

    /** A fault and its end, seconds, infinite if it has none. */
    private record ListedFault(RepairableFault active, double end) {}

    /** The label of the time that remains until the end of a fault, seconds. */
    private record RemainingTime(ValueLabel label, double end) {}

    /** Creates an empty list; the sender receives repairs. */
    public FaultList(CommandSender sender) {
        super(new WrappingGridLayout());
        this.sender = sender;
        rebuild();
    }

    /** Shows the faults of sensors, given the timeline and the present time, seconds. */
    void setSensors(List<SensorSnapshot> sensors, List<TimedCommand> newTimeline, double newNow) {
        setFaults(
                sensors.stream()
                        .<RepairableFault>flatMap(sensor -> sensor.faults().stream()
                                .map(fault -> new SensorFault(sensor.spec().id(), fault)))
                        .toList(),
                newTimeline,
                newNow);
    }

    /** Shows the faults of motors, given the timeline and the present time, seconds. */
    public void setMotors(MotorFaults faults, List<TimedCommand> newTimeline, double newNow) {
        setFaults(
                Stream.of(MotorSide.values())
                        .<RepairableFault>flatMap(
                                side -> faults.of(side).stream().map(fault -> new SideFault(side, fault)))
                        .toList(),
                newTimeline,
                newNow);
    }

    private void setFaults(List<RepairableFault> active, List<TimedCommand> newTimeline, double newNow) {
        boolean sameFaults =
                active.equals(shownFaults.stream().map(ListedFault::active).toList());
        // While the time passes, the ends stay the same until the first of them.
        boolean sameEnds = sameFaults && newTimeline == timeline && newNow >= now && newNow < firstEnd;
        timeline = newTimeline;
        now = newNow;
        if (!sameEnds) {
            List<ListedFault> listed = listed(active);
            firstEnd = listed.stream().mapToDouble(ListedFault::end).min().orElse(Double.POSITIVE_INFINITY);
            if (!listed.equals(shownFaults)) {
                replaceFaults(listed);
            }
        }
        remainingTimes.forEach(time -> time.label().setValue(remainingText(time.end())));
    }

    /** Returns the faults with their ends. */
    private List<ListedFault> listed(List<RepairableFault> active) {
        Map<Command, List<RepairableFault>> byOwner = new LinkedHashMap<>();
        active.forEach(fault -> byOwner.computeIfAbsent(fault.repairAll(), owner -> new ArrayList<>())
                .add(fault));
        List<ListedFault> listed = new ArrayList<>();
        byOwner.values().forEach(faults -> {
            List<Double> ends = TimelineEvents.ends(
                    faults.stream().map(RepairableFault::injection).toList(), timeline, now);
            for (int i = 0; i < faults.size(); i++) {
                listed.add(new ListedFault(faults.get(i), ends.get(i)));
            }
        });
        return listed;
    }

    /** Shows other faults; a button that has the focus passes it to that of the same fault or of the next one. */
    private void replaceFaults(List<ListedFault> listed) {
        Component focusOwner =
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        boolean focused = focusOwner != null && isAncestorOf(focusOwner);
        int row = repairButtons.indexOf(focusOwner);
        RepairableFault fault = row < 0 ? null : shownFaults.get(row).active();
        shownFaults = listed;
        rebuild();
        if (focused) {
            focus(fault, row);
        }
    }

    /** Gives the focus to the button of a fault that was in a row, or of the one that took its place. */
    private void focus(RepairableFault fault, int row) {
        if (shownFaults.isEmpty()) {
            transferFocusBackward();
        } else if (row < 0) {
            // The button that repairs all faults, or the only one.
            getComponent(getComponentCount() - 1).requestFocusInWindow();
        } else {
            List<RepairableFault> active =
                    shownFaults.stream().map(ListedFault::active).toList();
            int same = row < active.size() && active.get(row).equals(fault) ? row : active.indexOf(fault);
            repairButtons
                    .get(same >= 0 ? same : Math.min(row, active.size() - 1))
                    .requestFocusInWindow();
        }
    }

    private void rebuild() {
        removeAll();
        remainingTimes.clear();
        repairButtons.clear();
        if (shownFaults.isEmpty()) {
            add(MutedLabel.ofKey("faults.none"), FormConstraints.fillCell(0, 0));
        } else {
            for (int row = 0; row < shownFaults.size(); row++) {
                addRow(row, shownFaults.get(row));
            }
            if (shownFaults.size() > 1) {
                addClearAll(shownFaults.size());
            }
        }
        revalidate();
        repaint();
    }

    private void addRow(int row, ListedFault listed) {
        RepairableFault active = listed.active();
        // Two labels, so that a narrow panel can show the fault below its sensor.
        JLabel owner = new JLabel("", WARNING_ICON, JLabel.LEADING);
        add(RefreshSteps.add(owner, self -> self.setText(active.owner() + ":")), FormConstraints.cell(0, row));
        JLabel fault = RefreshSteps.add(new JLabel(), self -> self.setText(active.text()));
        add(fault, FormConstraints.fillCell(1, row));
        if (Double.isFinite(listed.end())) {
            add(remainingTime(listed), FormConstraints.cell(2, row));
        }
        JButton mend = new JButton(REMOVE_ICON);
        mend.setBorder(BorderFactory.createEmptyBorder(3, 5, 3, 5));
        RefreshSteps.add(mend, button -> {
            button.setToolTipText(Messages.get("faults.repair", active.description()));
            button.getAccessibleContext().setAccessibleName(button.getToolTipText());
        });
        mend.addActionListener(event -> sender.send(active.repair()));
        repairButtons.add(mend);
        add(mend, FormConstraints.cell(3, row));
    }

    private ValueLabel remainingTime(ListedFault listed) {
        String end = DecimalText.format(listed.end());
        ValueLabel label = new ValueLabel(
                () -> Messages.get("faults.end", listed.active().description(), end),
                () -> List.of(Messages.get("faults.remaining", NumberText.format("%.1f", listed.end()))));
        label.setHorizontalAlignment(SwingConstants.TRAILING);
        RefreshSteps.add(label, self -> {
            self.setToolTipText(Messages.get("faults.end.tip", end));
            self.setValue(remainingText(listed.end()));
        });
        remainingTimes.add(new RemainingTime(label, listed.end()));
        return label;
    }

    private String remainingText(double end) {
        return Messages.get("faults.remaining", NumberText.format("%.1f", Math.max(0, end - now)));
    }

    private void addClearAll(int row) {
        JButton all = UiText.button("faults.repairAll");
        all.addActionListener(event -> sender.send(shownFaults.stream()
                .map(listed -> listed.active().repairAll())
                .distinct()
                .toList()));
        GridBagConstraints constraints = FormConstraints.fillRow(0, row);
        constraints.fill = GridBagConstraints.NONE;
        constraints.anchor = GridBagConstraints.LINE_END;
        constraints.insets.top += 4;
        add(all, constraints);
    }
}
