package faultline.gui.dialog;

import faultline.gui.panel.FormConstraints;
import faultline.gui.panel.FormDialog;
import faultline.gui.panel.MutedLabel;
import faultline.gui.panel.NumberSpinner;
import faultline.gui.text.Messages;
import java.awt.Component;
import java.awt.FlowLayout;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.JPanel;

/** Asks for the speed of an obstacle along its waypoints. */
public final class SpeedDialog {

    /** About as fast as people run, metres per second. */
    private static final double MAX_SPEED = 5;

    private static final double SPEED_STEP = 0.05;
    private static final int COLUMNS = 6;

    private SpeedDialog() {}

    /** Asks for a speed in metres per second, given the current one; empty if cancelled. */
    public static OptionalDouble showDialog(Component parent, double now) {
        NumberSpinner field = new NumberSpinner("0.00##", 0, Math.max(MAX_SPEED, now), SPEED_STEP, ignored -> {})
                .withName("motionSpeed")
                .keepInvalidText()
                .withColumns(COLUMNS);
        field.setWorldValue(now);
        JPanel line = new JPanel(new FlowLayout(FlowLayout.LEADING));
        line.add(FormConstraints.label("motionSpeed", field));
        line.add(field);
        line.add(new MutedLabel("m/s"));
        boolean accepted = FormDialog.showDialog(
                parent,
                Messages.get("motionSpeed.title"),
                line,
                field.textField(),
                () -> field.commitValidEdit()
                        ? Optional.empty()
                        : Optional.of(new FormDialog.FormProblem("", field.textField())));
        return accepted ? OptionalDouble.of(field.doubleValue()) : OptionalDouble.empty();
    }
}
