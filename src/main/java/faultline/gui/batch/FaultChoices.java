package faultline.gui.batch;

import faultline.campaign.plan.ValueSyntax;
import faultline.gui.form.FormConstraints;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.text.TextListener;
import faultline.gui.theme.FieldBorder;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.io.DecimalText;
import faultline.sensor.FaultKind;
import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;

/** The kinds of fault of a batch, each with a field for its number in the syntax of plans. */
final class FaultChoices extends JPanel {

    private static final int VALUE_COLUMNS = 9;
    /** The ratio of the greatest number to the default one, and of that to the least. */
    private static final double SPREAD = 2;
    /** The cells of a kind: its check box, its field and its unit. */
    private static final int CELLS = 3;

    private static final int COLUMN_GAP = 24;

    private final List<FaultChoiceRow> rows = new ArrayList<>();
    private final GridBagLayout layout = new GridBagLayout();
    private final JPanel grid = new JPanel(layout);

    /** A kind, whether it is chosen, and its number; kinds without a number have no visible field. */
    private record FaultChoiceRow(FaultKind kind, JCheckBox box, JTextField value, JLabel unit) {}

    /** Creates choices with one kind selected; {@code onChange} is called after every change. */
    FaultChoices(Runnable onChange) {
        super(new BorderLayout(0, 6));
        for (FaultKind kind : FaultKind.values()) {
            rows.add(createRow(kind, onChange));
        }
        arrange(1);
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

    /** Arranges the kinds in a number of columns, one after the other. */
    void arrange(int columns) {
        int height = (rows.size() + columns - 1) / columns;
        for (int i = 0; i < rows.size(); i++) {
            FaultChoiceRow kind = rows.get(i);
            int column = i / height;
            GridBagConstraints box = FormConstraints.cell(CELLS * column, i % height);
            box.insets.left = column == 0 ? 0 : COLUMN_GAP;
            layout.setConstraints(kind.box, box);
            layout.setConstraints(kind.value, FormConstraints.cell(CELLS * column + 1, i % height));
            GridBagConstraints unit = FormConstraints.cell(CELLS * column + 2, i % height);
            unit.weightx = column == columns - 1 ? 1 : 0;
            layout.setConstraints(kind.unit, unit);
        }
        grid.invalidate();
    }

    private FaultChoiceRow createRow(FaultKind kind, Runnable onChange) {
        JCheckBox box = new JCheckBox("", kind == FaultKind.STUCK);
        box.addActionListener(event -> onChange.run());
        JTextField value = new JTextField(VALUE_COLUMNS);
        RefreshSteps.add(
                value,
                self -> self.setToolTipText(
                        Messages.get(FaultText.valueKeyOf(kind)) + ". " + Messages.get("batch.syntax")));
        RefreshSteps.add(box, self -> {
            self.setText(FaultText.nameOf(kind));
            self.setToolTipText(FaultText.describe(kind));
            value.getAccessibleContext().setAccessibleName(Messages.get("batch.valueOf", self.getText()));
        });
        value.getDocument().addDocumentListener(new TextListener(onChange));
        JLabel unit = new JLabel();
        grid.add(box);
        if (kind.takesValue()) {
            grid.add(value);
            grid.add(RefreshSteps.add(unit, label -> label.setText(FaultText.fieldUnitOf(kind))));
        }
        return new FaultChoiceRow(kind, box, value, unit);
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

    /** Returns the first field of a chosen kind whose text is not in the syntax of plans; empty if there is none. */
    Optional<JTextField> findInvalidField() {
        return rows.stream()
                .filter(FaultChoices::isInvalid)
                .map(FaultChoiceRow::value)
                .findFirst();
    }

    /** Shows which fields of chosen kinds have a text that is not in the syntax of plans. */
    void markInvalidFields() {
        rows.forEach(row -> FieldBorder.setValid(row.value, !isInvalid(row)));
    }

    private static boolean isInvalid(FaultChoiceRow row) {
        return row.box.isSelected()
                && row.kind.takesValue()
                && ValueSyntax.count(row.value.getText().strip()).isEmpty();
    }
}
