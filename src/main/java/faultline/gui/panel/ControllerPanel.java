package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.SimulationSetup;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.world.Command;
import java.awt.EventQueue;
import java.awt.GridBagLayout;
import java.util.function.UnaryOperator;
import javax.swing.BoxLayout;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The controller's kind and settings, and the drive that it commands. Settings that do not apply are disabled. */
public final class ControllerPanel extends JPanel {

    /** The kinds of controllers. */
    private enum Kind {
        FOLLOWER,
        DRIVE,
        NONE,
        FOREIGN;

        static Kind of(ControllerSpec spec) {
            if (!(spec instanceof ControllerSpec.BuiltIn)) {
                return FOREIGN;
            }
            return spec instanceof WallFollowing ? FOLLOWER : spec instanceof ControllerSpec.Drive ? DRIVE : NONE;
        }
    }

    private static final double MIN_DISTANCE = 0.05;
    private static final double MAX_DISTANCE = 10;
    private static final double MAX_VOLTS = 100;

    private final transient UndoController editor;
    private final NamedChoice<Kind> kind = new NamedChoice<>(
            Kind.values(), value -> Messages.get("controller.kind." + value.name()), this::selectKind);
    private final NumberSpinner distance = new NumberSpinner(
            "0.00##", MIN_DISTANCE, MAX_DISTANCE, 0.01, value -> change(old -> old.withDistance(value)));
    private final NamedChoice<WallSide> side = new NamedChoice<>(
            WallSide.values(),
            value -> Messages.get("controller.hand." + value.fileName()),
            value -> change(old -> old.withSide(value)));
    private final NamedChoice<TimingRule> timing = new NamedChoice<>(
            TimingRule.values(),
            value -> Messages.get("spin.rule." + value.fileName()),
            value -> change(old -> old.withTimingRule(value)));
    private final JCheckBox diagnosis = new JCheckBox(Messages.get("controller.diagnosis"));
    private final GainFields gains = new GainFields(rule -> change(old -> old.withGainRule(rule)));
    private final NumberSpinner left =
            new NumberSpinner("0.0##", -MAX_VOLTS, MAX_VOLTS, 0.1, value -> drive(value, drive().rightVolts()));
    private final NumberSpinner right =
            new NumberSpinner("0.0##", -MAX_VOLTS, MAX_VOLTS, 0.1, value -> drive(drive().leftVolts(), value));
    private final DriveFields driveFields;

    /**
     * Creates a panel.
     *
     * @param editor receives changes of the controller
     * @param scenarioEditor receives changes of the robot's drive, which need a new simulation
     */
    ControllerPanel(UndoController editor, ScenarioEditor scenarioEditor) {
        this.editor = editor;
        driveFields = new DriveFields(scenarioEditor);
        setLayout(new BoxLayout(this, BoxLayout.PAGE_AXIS));
        diagnosis.setToolTipText(Messages.get("controller.diagnosis.tip"));
        diagnosis.addActionListener(event -> change(old -> old.withDiagnosis(diagnosis.isSelected())));
        add(new TitledSection(createFollowerForm()));
        add(new TitledSection(Messages.get("controller.gains"), gains));
        add(new TitledSection(Messages.get("controller.voltages"), createVoltageForm()));
        add(new TitledSection(Messages.get("controller.drive"), driveFields));
    }

    private JPanel createFollowerForm() {
        JPanel form = new JPanel(new GridBagLayout());
        addRow(form, 0, "controller.kind", kind);
        addRow(form, 1, "controller.distance", distance.withColumns(6));
        addRow(form, 2, "controller.hand", side);
        addRow(form, 3, "controller.timing", timing);
        form.add(diagnosis, FormConstraints.fillRow(1, 4));
        return form;
    }

    private JPanel createVoltageForm() {
        JPanel form = new JPanel(new GridBagLayout());
        addRow(form, 0, "controller.left", left.withColumns(6));
        addRow(form, 1, "controller.right", right.withColumns(6));
        return form;
    }

    /** Adds a row with a label, a field and a tooltip for both. */
    static void addRow(JPanel form, int row, String key, JComponent field) {
        JLabel label = FormConstraints.addRow(form, row, key, field);
        label.setToolTipText(Messages.get(key + ".tip"));
        field.setToolTipText(Messages.get(key + ".tip"));
    }

    private ControllerSpec spec() {
        return editor.pendingEdits().controller();
    }

    private ControllerSpec.Drive drive() {
        return spec() instanceof ControllerSpec.Drive drive ? drive : new ControllerSpec.Drive(1, 1);
    }

    private void selectKind(Kind selected) {
        if (selected != Kind.of(spec()) && selected != Kind.FOREIGN) {
            send(
                    switch (selected) {
                        case FOLLOWER -> WallFollowing.DEFAULT;
                        case DRIVE -> drive();
                        case NONE, FOREIGN -> new ControllerSpec.None();
                    });
        }
    }

    private void change(UnaryOperator<WallFollowing> change) {
        if (spec() instanceof WallFollowing follower) {
            send(change.apply(follower));
        }
    }

    private void drive(double leftVolts, double rightVolts) {
        if (spec() instanceof ControllerSpec.Drive) {
            send(new ControllerSpec.Drive(leftVolts, rightVolts));
        }
    }

    private void send(ControllerSpec.BuiltIn changed) {
        if (!changed.equals(spec())) {
            editor.send(new Command.ConfigureController(changed));
        }
    }

    /** Shows the current settings. */
    void setSettings(ControllerSpec current, SimulationSetup setup) {
        assert EventQueue.isDispatchThread();
        editor.pendingEdits().setController(current);
        ControllerSpec shown = spec();
        boolean follows = shown instanceof WallFollowing;
        kind.setValue(Kind.of(shown));
        kind.setEnabled(Kind.of(shown) != Kind.FOREIGN);
        for (JComponent field : new JComponent[] {distance, side, timing, diagnosis}) {
            field.setEnabled(follows);
        }
        if (shown instanceof WallFollowing follower) {
            distance.setWorldValue(follower.distance());
            side.setValue(follower.side());
            timing.setValue(follower.timingRule());
            diagnosis.setSelected(follower.diagnosis());
            gains.setGains(follower, editor.pendingEdits().robot(), setup.dt());
        }
        gains.setApplicable(follows);
        left.setEnabled(Kind.of(shown) == Kind.DRIVE);
        right.setEnabled(left.isEnabled());
        left.setWorldValue(drive().leftVolts());
        right.setWorldValue(drive().rightVolts());
        driveFields.setRobot(setup.robot());
    }
}
