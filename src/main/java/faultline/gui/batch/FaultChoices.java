package faultline.gui.batch;

import faultline.gui.panel.FormConstraints;
import faultline.gui.panel.TextListener;
import faultline.gui.text.Messages;
import faultline.gui.text.MotorFaultText;
import faultline.gui.text.ReadingText;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.io.DecimalText;
import faultline.sensor.FaultKind;
import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;

/** The kinds of fault of a batch, each with a field for its number in the syntax of plans. */
final class FaultChoices extends JPanel {

    private static final int VALUE_COLUMNS = 9;
    private static final double SPREAD = 2;

    private final List<FaultChoiceRow> rows = new ArrayList<>();

    /** A kind, whether it is chosen, and its number; kinds without a number have no visible field. */
    private record FaultChoiceRow(FaultKind kind, JCheckBox box, JTextField value) {}

    /** Creates choices with one kind selected; {@code onChange} is called after every change. */
    FaultChoices(Runnable onChange) {
        super(new BorderLayout(0, 6));
        JPanel grid = new JPanel(new GridBagLayout());
        for (FaultKind kind : FaultKind.values()) {
            rows.add(createRow(kind, grid, onChange));
        }
        JPanel buttons = new JPanel(new GridLayout(2, 2, 6, 4));
        buttons.add(button("batch.all", () -> select(true), onChange));
        buttons.add(button("batch.drawn", () -> setValues(FaultChoices::drawnValues), onChange));
        buttons.add(button("batch.none", () -> select(false), onChange));
        buttons.add(button("batch.default", () -> setValues(FaultChoices::defaultValue), onChange));
        JPanel heading = new JPanel(new FlowLayout(FlowLayout.LEADING, 0, 0));
        heading.add(buttons);
        add(heading, BorderLayout.NORTH);
        add(grid, BorderLayout.CENTER);
        setValues(FaultChoices::drawnValues);
    }

    private FaultChoiceRow createRow(FaultKind kind, JPanel grid, Runnable onChange) {
        JCheckBox box = new JCheckBox("", kind == FaultKind.STUCK);
        box.addActionListener(event -> onChange.run());
        JTextField value = new JTextField(VALUE_COLUMNS);
        UiText.tip(value, "batch.syntax");
        RefreshSteps.add(box, self -> {
            self.setText(ReadingText.nameOf(kind));
            value.getAccessibleContext().setAccessibleName(Messages.get("batch.valueOf", self.getText()));
        });
        value.getDocument().addDocumentListener(new TextListener(onChange));
        int row = rows.size();
        grid.add(box, FormConstraints.cell(0, row));
        if (kind.takesValue()) {
            grid.add(value, FormConstraints.cell(1, row));
            JLabel unit = RefreshSteps.add(new JLabel(), label -> label.setText(MotorFaultText.fieldUnitOf(kind)));
            grid.add(unit, FormConstraints.fillCell(2, row));
        }
        return new FaultChoiceRow(kind, box, value);
    }

    private static JButton button(String key, Runnable action, Runnable onChange) {
        JButton button = UiText.tip(UiText.button(key), key + ".tip");
        button.addActionListener(event -> {
            action.run();
            onChange.run();
        });
        return button;
    }

    private void select(boolean selected) {
        rows.forEach(row -> row.box.setSelected(selected));
    }

    private void setValues(Function<FaultKind, String> value) {
        rows.stream().filter(row -> row.kind.takesValue()).forEach(row -> row.value.setText(value.apply(row.kind)));
    }

    private static String defaultValue(FaultKind kind) {
        return DecimalText.format(kind.defaultValue());
    }

    /** Returns the interval from half to twice the default number, within the limits of the kind. */
    private static String drawnValues(FaultKind kind) {
        double low = Math.max(kind.minValue(), kind.defaultValue() / SPREAD);
        double high = Math.min(kind.maxValue(), kind.defaultValue() * SPREAD);
        return DecimalText.format(low) + ".." + DecimalText.format(high);
    }

    /** Returns the chosen kinds with their numbers. */
    List<BatchPlan.FaultValues> chosen() {
        return rows.stream()
                .filter(row -> row.box.isSelected())
                .map(row -> new BatchPlan.FaultValues(
                        row.kind.fileName(),
                        row.kind.takesValue() ? row.value.getText().strip() : ""))
                .toList();
    }
}
