package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Threshold;
import faultline.control.Thresholds;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.TitledSection;
import faultline.gui.form.ValueLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.Messages;
import faultline.gui.theme.UiText;
import faultline.robot.RobotSpec;
import java.awt.Component;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The fields of a controller's kind and settings, in sections. Settings that do not apply are hidden. */
public final class ControllerForm {

    /** The kinds of controllers. */
    private enum ControllerKind {
        FOLLOWER,
        DRIVE,
        NONE,
        FOREIGN;

        static ControllerKind of(ControllerSpec spec) {
            return spec instanceof ControllerSpec.BuiltIn builtIn
                    ? builtIn.matchBuiltIn(
                            new ControllerSpec.BuiltInCases<>(none -> NONE, drive -> DRIVE, follower -> FOLLOWER))
                    : FOREIGN;
        }
    }

    private static final double MIN_DISTANCE = 0.05;
    private static final double MAX_DISTANCE = 10;
    private static final double MAX_PERIOD = 10;
    private static final double MAX_VOLTS = 100;

    private final Consumer<ControllerSpec.BuiltIn> onChange;
    private final NamedChoice<ControllerKind> kind = new NamedChoice<>(
            ControllerKind.values(), value -> Messages.get("controller.kind." + value.name()), this::selectKind);
    private final ValueLabel name =
            new ValueLabel(() -> Messages.get("controller.name"), () -> List.of("a longer name"));
    private final JLabel nameLabel = FormConstraints.label("controller.name", name);
    private final NumberSpinner distance = new NumberSpinner(
            "0.00##", MIN_DISTANCE, MAX_DISTANCE, 0.01, value -> change(old -> old.withDistance(value)));
    private final NamedChoice<WallSide> side = new NamedChoice<>(
            WallSide.values(),
            value -> Messages.get("controller.wallSide." + value.fileName()),
            value -> change(old -> old.withSide(value)));
    private final NamedChoice<TimingRule> timing = new NamedChoice<>(
            TimingRule.values(),
            value -> Messages.get("spin.rule." + value.fileName()),
            value -> change(old -> old.withTimingRule(value)));
    private final NumberSpinner period =
            new NumberSpinner("0.00###", 0, MAX_PERIOD, 0.01, value -> change(old -> old.withPeriod(value)));
    private final JCheckBox diagnosis = UiText.text(new JCheckBox(), "controller.diagnosis");
    private final GainFields gains = new GainFields(rule -> change(old -> old.withGainRule(rule)));
    private final Map<Threshold, NumberSpinner> thresholds = new EnumMap<>(Threshold.class);
    private final JButton defaultThresholds = UiText.button("controller.thresholds.defaults");
    private final NumberSpinner left =
            new NumberSpinner("0.0##", -MAX_VOLTS, MAX_VOLTS, 0.1, value -> drive(value, drive().rightVolts()));
    private final NumberSpinner right =
            new NumberSpinner("0.0##", -MAX_VOLTS, MAX_VOLTS, 0.1, value -> drive(drive().leftVolts(), value));
    private final List<JComponent> sections;
    /** The fields of a follower in the first section, with their labels. */
    private List<Component> followerParts = List.of();

    private ControllerSpec shown = WallFollowing.DEFAULT;

    /** Creates the fields; the listener receives the controller with every change that the user makes. */
    public ControllerForm(Consumer<ControllerSpec.BuiltIn> onChange) {
        this.onChange = onChange;
        UiText.tip(diagnosis, "controller.diagnosis.tip");
        UiText.tip(nameLabel, "controller.name.tip");
        setName("");
        diagnosis.addActionListener(event -> change(old -> old.withDiagnosis(diagnosis.isSelected())));
        sections = List.of(
                new TitledSection(createFollowerForm()),
                new TitledSection("controller.gains", gains),
                new TitledSection("controller.thresholds", createThresholdForm()),
                new TitledSection("controller.voltages", createVoltageForm()));
    }

    private JPanel createFollowerForm() {
        JPanel form = new JPanel(new WrappingGridLayout());
        addRow(form, 0, "controller.kind", kind);
        form.add(nameLabel, FormConstraints.cell(0, 1));
        form.add(name, FormConstraints.fillRow(1, 1));
        int before = form.getComponentCount();
        addRow(form, 2, "controller.distance", distance.withColumns(6));
        addRow(form, 3, "controller.wallSide", side);
        addRow(form, 4, "controller.timing", timing);
        addRow(form, 5, "controller.period", period.withColumns(6));
        form.add(diagnosis, FormConstraints.fillRow(1, 6));
        followerParts = Stream.of(form.getComponents()).skip(before).toList();
        return form;
    }

    private JPanel createThresholdForm() {
        JPanel form = new JPanel(new WrappingGridLayout());
        for (Threshold threshold : Threshold.values()) {
            NumberSpinner field =
                    spinner(threshold.quantity(), value -> change(old -> old.withThreshold(threshold, value)));
            addRow(form, thresholds.size(), "controller." + threshold.fileName(), field.withColumns(6));
            thresholds.put(threshold, field);
        }
        UiText.tip(defaultThresholds, "controller.thresholds.defaults.tip");
        defaultThresholds.addActionListener(event -> {
            // The button is disabled then, and the next field that would get the focus scrolls the panel.
            thresholds.get(Threshold.STEER_THROUGH).textField().requestFocusInWindow();
            change(old -> old.withThresholds(Thresholds.DEFAULT));
        });
        form.add(defaultThresholds, FormConstraints.cell(1, thresholds.size()));
        return form;
    }

    private static NumberSpinner spinner(Threshold.Quantity quantity, DoubleConsumer onChange) {
        return switch (quantity) {
            case MARGIN, SIGNED_MARGIN, SHARE ->
                new NumberSpinner("0.00##", quantity.min(), quantity.max(), 0.01, onChange);
            case TURN_RATE -> new NumberSpinner("0.0##", quantity.min(), quantity.max(), 0.5, onChange);
            case ANGLE -> new NumberSpinner("0.##", quantity.min(), quantity.max(), 5, onChange);
        };
    }

    private JPanel createVoltageForm() {
        JPanel form = new JPanel(new WrappingGridLayout());
        addRow(form, 0, "controller.left", left.withColumns(6));
        addRow(form, 1, "controller.right", right.withColumns(6));
        return form;
    }

    /** Adds a row with a label, a field and a tooltip for both; that of a number states its limits. */
    static void addRow(JPanel form, int row, String key, JComponent field) {
        JLabel label = FormConstraints.addRow(form, row, key, field);
        UiText.tip(label, key + ".tip");
        if (field instanceof NumberSpinner number) {
            number.setTip(key + ".tip");
        } else {
            UiText.tip(field, key + ".tip");
        }
    }

    /** Returns the sections: the controller, its gains, its thresholds and its voltages. */
    public List<JComponent> sections() {
        return sections;
    }

    private ControllerSpec.Drive drive() {
        return shown instanceof ControllerSpec.Drive drive ? drive : new ControllerSpec.Drive(1, 1);
    }

    private void selectKind(ControllerKind selected) {
        if (selected != ControllerKind.of(shown)) {
            send(
                    switch (selected) {
                        case FOLLOWER -> WallFollowing.DEFAULT;
                        case DRIVE -> drive();
                        case NONE, FOREIGN -> new ControllerSpec.None();
                    });
        }
    }

    private void change(UnaryOperator<WallFollowing> change) {
        if (shown instanceof WallFollowing follower) {
            send(change.apply(follower));
        }
    }

    private void drive(double leftVolts, double rightVolts) {
        if (shown instanceof ControllerSpec.Drive) {
            send(new ControllerSpec.Drive(leftVolts, rightVolts));
        }
    }

    private void send(ControllerSpec.BuiltIn changed) {
        if (!changed.equals(shown)) {
            shown = changed;
            onChange.accept(changed);
        }
    }

    /** Shows the name that a controller gives itself; empty for one that gives none. */
    void setName(String given) {
        name.setValue(given);
        name.setVisible(!given.isEmpty());
        nameLabel.setVisible(!given.isEmpty());
        name.setToolTipText(given.isEmpty() ? null : Messages.get("controller.name.full", given));
    }

    /**
     * Shows the controller of a robot, whose speed and motors determine automatic gains; {@code dt} is the length of a
     * tick, seconds.
     */
    public void setController(ControllerSpec controller, RobotSpec robot, double dt) {
        shown = controller;
        boolean follows = shown instanceof WallFollowing;
        showKind(ControllerKind.of(shown));
        for (JComponent field : new JComponent[] {distance, side, timing, period, diagnosis}) {
            field.setEnabled(follows);
        }
        thresholds.values().forEach(field -> field.setEnabled(follows));
        gains.setApplicable(follows);
        followerParts.forEach(part -> part.setVisible(follows));
        sections.get(1).setVisible(follows);
        sections.get(2).setVisible(follows);
        showFollower(robot, dt);
        defaultThresholds.setEnabled(shown instanceof WallFollowing follower
                && !follower.thresholds().equals(Thresholds.DEFAULT));
        boolean drives = shown instanceof ControllerSpec.Drive;
        left.setEnabled(drives);
        right.setEnabled(drives);
        sections.get(3).setVisible(drives);
        left.setWorldValue(drive().leftVolts());
        right.setWorldValue(drive().rightVolts());
    }

    /** Shows a kind; an external controller, which cannot be chosen here, is in the list only while it is shown. */
    private void showKind(ControllerKind present) {
        boolean foreign = present == ControllerKind.FOREIGN;
        boolean listed = kind.getItemCount() == ControllerKind.values().length;
        if (foreign && !listed) {
            kind.addItem(ControllerKind.FOREIGN);
        }
        kind.setValue(present);
        if (!foreign && listed) {
            kind.removeItem(ControllerKind.FOREIGN);
        }
        kind.setEnabled(!foreign);
    }

    /** Shows the settings if the controller is a follower. */
    private void showFollower(RobotSpec robot, double dt) {
        if (shown instanceof WallFollowing follower) {
            distance.setWorldValue(follower.distance());
            side.setValue(follower.side());
            timing.setValue(follower.timingRule());
            period.setWorldValue(follower.period());
            diagnosis.setSelected(follower.diagnosis());
            gains.setGains(follower, robot, dt);
            thresholds.forEach((threshold, field) ->
                    field.setWorldValue(follower.thresholds().get(threshold)));
        }
    }
}
