package faultline.gui.dialog;

import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.Messages;
import faultline.scenario.xml.ScenarioLimits;
import java.awt.Component;
import java.awt.FlowLayout;
import java.util.OptionalDouble;
import javax.swing.JPanel;

/**
 * Asks for a number that is not negative.
 *
 * @param key the key of the label; that of the title is {@code KEY.title}
 * @param unit the unit
 * @param max the greatest number, if the present one is not greater
 * @param step the change by one press of an arrow key
 */
public record NumberDialog(String key, String unit, double max, double step) {

    /** Asks for the speed of an obstacle along its waypoints, metres per second, up to that of people who run. */
    public static final NumberDialog MOTION_SPEED = new NumberDialog("motionSpeed", "m/s", 5, 0.05);

    /** Asks for a time of the run, seconds. */
    public static final NumberDialog TIME = new NumberDialog("goToTime", "s", ScenarioLimits.MAX_DURATION, 1);

    private static final String PATTERN = "0.00##";
    private static final int COLUMNS = 8;

    /** Asks for the number, given the present one; empty if cancelled. */
    public OptionalDouble ask(Component parent, double now) {
        NumberSpinner field = new NumberSpinner(PATTERN, 0, Math.max(max, now), step, ignored -> {})
                .withName(key)
                .keepInvalidText()
                .withColumns(COLUMNS);
        field.setWorldValue(now);
        JPanel line = new JPanel(new FlowLayout(FlowLayout.LEADING));
        line.add(FormConstraints.label(key, field));
        line.add(field);
        line.add(new MutedLabel(unit));
        boolean accepted = FormDialog.showDialog(
                parent,
                Messages.get(key + ".title"),
                line,
                field.textField(),
                () -> FormDialog.findRefusedNumber(line));
        return accepted ? OptionalDouble.of(field.doubleValue()) : OptionalDouble.empty();
    }
}
