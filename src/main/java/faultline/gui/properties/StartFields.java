package faultline.gui.properties;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.EditLimits;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import java.awt.Component;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The fields of the start of the robot, in one row: position and heading. */
final class StartFields extends JPanel {

    /** The greatest distance of the start from the axes that can be entered, metres. */
    private static final double MAX_START = 1000;

    private final NumberSpinner x;
    private final NumberSpinner y;
    private final NumberSpinner heading;

    /** Creates fields; {@code onChange} runs after each number that the user enters. */
    StartFields(Runnable onChange) {
        super(new GridBagLayout());
        x = new NumberSpinner("0.00##", -MAX_START, MAX_START, 0.1, value -> onChange.run());
        y = new NumberSpinner("0.00##", -MAX_START, MAX_START, 0.1, value -> onChange.run());
        heading = new NumberSpinner("0.##", -EditLimits.MAX_ANGLE, EditLimits.MAX_ANGLE, 5, value -> onChange.run());
        add(x.withName("properties.start.x").withColumns(7), FormConstraints.cell(0, 0));
        add(y.withName("properties.start.y").withColumns(7), FormConstraints.cell(1, 0));
        JLabel label = FormConstraints.label("properties.start.heading.label", heading);
        add(label, FormConstraints.cell(2, 0));
        GridBagConstraints last = FormConstraints.fillCell(3, 0);
        last.fill = GridBagConstraints.NONE;
        add(heading.withName("properties.start.heading").withColumns(6), last);
    }

    /** Adds the label and the fields to a row of a form with a {@link GridBagLayout}. */
    void addTo(JPanel form, int row) {
        form.add(FormConstraints.label("properties.start", x), FormConstraints.leadingCell(0, row));
        GridBagConstraints cell = FormConstraints.fillRow(1, row);
        cell.anchor = GridBagConstraints.LINE_START;
        form.add(this, cell);
    }

    Component firstField() {
        return x.textField();
    }

    void setPose(Pose start) {
        x.setWorldValue(start.x());
        y.setWorldValue(start.y());
        heading.setWorldValue(Double.parseDouble(Degrees.toText(start.heading())));
    }

    /** Shows another position, metres, within the limits of the fields. */
    void setPosition(Vector2 position) {
        x.setWorldValue(Math.max(-MAX_START, Math.min(MAX_START, position.x())));
        y.setWorldValue(Math.max(-MAX_START, Math.min(MAX_START, position.y())));
    }

    Pose pose() {
        return new Pose(x.doubleValue(), y.doubleValue(), Degrees.toRadians(heading.doubleValue()));
    }

    @Override
    public void setEnabled(boolean enabled) {
        super.setEnabled(enabled);
        NumberSpinner.findIn(this).forEach(field -> field.setEnabled(enabled));
    }
}
