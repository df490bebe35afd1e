package faultline.gui.panel;

import faultline.gui.form.FormConstraints;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.FaultText;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.io.DecimalText;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaultKind;
import faultline.sensor.Fault;
import faultline.sensor.FaultDescriptor;
import faultline.sensor.FaultKind;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingConstants;

/**
 * The fields of a fault: its kind, its number and, if the kind has one, its mean length.
 *
 * @param <K> the type of the kinds
 * @param <F> the type of the faults
 */
public final class FaultFields<K extends FaultDescriptor<F>, F> {

    /** The row of the number below that of the kind. */
    static final int VALUE_ROW = 2;

    private static final int COLUMNS = 5;
    private static final int MIN_TEXT_COLUMNS = 6;
    private static final int DESCRIPTION_COLUMNS = 26;
    /** Enough for the longest sentence at the usual widths of fonts, so that the fields below stay where they are. */
    private static final int DESCRIPTION_ROWS = 2;

    private final NamedChoice<K> kind;

    private final NumberSpinner value = new NumberSpinner(FaultText.NUMBER_PATTERN, 0, 1, 0.05, ignored -> {});
    private final NumberSpinner length =
            new NumberSpinner(FaultText.NUMBER_PATTERN, FaultKind.MIN_LENGTH, FaultKind.MAX_LENGTH, 0.1, ignored -> {});
    private final JLabel lengthLabel = FormConstraints.label("faults.length", length);
    private final MutedLabel unit = new MutedLabel("m");
    private final MutedLabel lengthUnit = new MutedLabel("s");
    private final JTextArea description = UiText.wrappedText();
    private final JTextArea problem = new NarrowText();
    private final JPanel problemRow = new JPanel(new BorderLayout(4, 0));

    private double range = Double.POSITIVE_INFINITY;

    private FaultFields(K[] kinds, K initial) {
        this.kind = new NamedChoice<>(kinds, FaultText::nameOf, chosen -> updateKind());
        configureKind(kinds.length);
        configure(value, "faults.value");
        configure(length, "faults.length");
        length.setTip("faults.length.tip");
        description.setColumns(DESCRIPTION_COLUMNS);
        description.setRows(DESCRIPTION_ROWS);
        kind.setSelectedItem(initial);
        JLabel icon = new JLabel("", new GlyphIcon(Glyph.WARNING, 14, colours -> colours.warning()), JLabel.LEADING);
        icon.setVerticalAlignment(SwingConstants.TOP);
        problemRow.add(icon, BorderLayout.LINE_START);
        problemRow.add(problem, BorderLayout.CENTER);
        problemRow.setVisible(false);
        RefreshSteps.add(unit, label -> updateTexts());
    }

    /** Creates the fields of a sensor that is stuck. */
    public static FaultFields<FaultKind, Fault> forSensors() {
        return new FaultFields<>(FaultKind.values(), FaultKind.STUCK);
    }

    /** Creates the fields of motors that are weak. */
    public static FaultFields<MotorFaultKind, MotorFault> forMotors() {
        return new FaultFields<>(MotorFaultKind.values(), MotorFaultKind.WEAK);
    }

    private K selected() {
        return kind.value();
    }

    private void configureKind(int count) {
        kind.setRenderer(NamedChoice.rendererOf(FaultText::nameOf, FaultText::describe));
        kind.setMaximumRowCount(count);
        UiText.name(kind, "faults.kind");
    }

    private void configure(NumberSpinner spinner, String key) {
        spinner.withName(key).withColumns(COLUMNS).keepInvalidText().withoutNote();
        spinner.textField().addPropertyChangeListener("editValid", event -> updateProblem());
        spinner.addChangeListener(event -> updateProblem());
    }

    /**
     * Adds the fields to five rows of a form with a {@link java.awt.GridBagLayout}, below a gap in pixels. The second
     * row is empty.
     */
    public void addTo(JPanel form, int row, int gap) {
        GridBagConstraints first = FormConstraints.cell(0, row);
        first.insets.top += gap;
        form.add(FormConstraints.label("faults.kind", kind), first);
        GridBagConstraints second = FormConstraints.fillRow(1, row);
        second.insets.top += gap;
        form.add(kind, second);
        form.add(FormConstraints.label("faults.value", value), FormConstraints.cell(0, row + VALUE_ROW));
        form.add(value, FormConstraints.cell(1, row + VALUE_ROW));
        form.add(unit, FormConstraints.cell(2, row + VALUE_ROW));
        form.add(lengthLabel, FormConstraints.cell(0, row + VALUE_ROW + 1));
        form.add(length, FormConstraints.cell(1, row + VALUE_ROW + 1));
        form.add(lengthUnit, FormConstraints.cell(2, row + VALUE_ROW + 1));
        form.add(problemRow, FormConstraints.fillRow(1, row + VALUE_ROW + 2));
    }

    /** Adds the fields to five rows of a form, with a text in the second row that says what the fault does. */
    public void addWithDescription(JPanel form, int row) {
        addTo(form, row, 0);
        form.add(description, FormConstraints.fillRow(1, row + 1));
    }

    private void updateKind() {
        value.setEnabled(selected().takesValue());
        showValue(selected().defaultValue());
        length.setLimits(FaultKind.MIN_LENGTH, FaultKind.MAX_LENGTH, FaultKind.DEFAULT_LENGTH);
        for (JComponent part : new JComponent[] {lengthLabel, length, lengthUnit}) {
            part.setVisible(selected().takesLength());
        }
        updateTexts();
    }

    private void showValue(double number) {
        value.setLimits(selected().minValue(), selected().maxValue(), selected().takesValue() ? number : Double.NaN);
    }

    private void updateTexts() {
        unit.setText(FaultText.fieldUnitOf(selected()));
        value.setTip(FaultText.valueKeyOf(selected()));
        description.setText(FaultText.describe(selected()));
        kind.setToolTipText(description.getText());
        updateProblem();
    }

    /** Shows a fault; {@code newLength} is used only if its kind has a length. */
    public void setFault(K newKind, double newValue, double newLength) {
        kind.setSelectedItem(newKind);
        showValue(newValue);
        if (selected().takesLength()) {
            length.setLimits(FaultKind.MIN_LENGTH, FaultKind.MAX_LENGTH, newLength);
        }
    }

    /** Returns the choice of the kind. */
    public JComponent kindField() {
        return kind;
    }

    /** Returns the fault, or moves the focus to the invalid number and returns nothing. */
    public Optional<F> commitFault() {
        if (selected().takesValue() && !isCommitted(value) || selected().takesLength() && !isCommitted(length)) {
            return Optional.empty();
        }
        return Optional.of(selected().createFault(value.doubleValue(), length.doubleValue()));
    }

    private boolean isCommitted(NumberSpinner spinner) {
        boolean valid = spinner.commitValidEdit();
        updateProblem();
        if (!valid) {
            spinner.textField().requestFocusInWindow();
        }
        return valid;
    }

    private void updateProblem() {
        Optional<NumberSpinner> refused = refusedField();
        if (refused.isPresent()) {
            problem.setText(Messages.get("faults.invalid", refused.get().limitsText()));
        } else if (isBeyondRange()) {
            problem.setText(Messages.get("faults.beyondRange", DecimalText.format(range)));
        }
        problemRow.setVisible(refused.isPresent() || isBeyondRange());
        describe(value, problemRow.isVisible() && refused.orElse(value) == value);
        describe(length, refused.filter(length::equals).isPresent());
    }

    /** Returns the first field whose text is not an allowed number. */
    private Optional<NumberSpinner> refusedField() {
        if (selected().takesValue() && !value.textField().isEditValid()) {
            return Optional.of(value);
        }
        return selected().takesLength() && !length.textField().isEditValid() ? Optional.of(length) : Optional.empty();
    }

    /** Makes the problem the accessible description of a field, if it concerns the field. */
    private void describe(NumberSpinner field, boolean concerned) {
        field.textField().getAccessibleContext().setAccessibleDescription(concerned ? problem.getText() : null);
    }

    /** Returns whether the reported distance or the new range of the sensor exceeds its range. */
    private boolean isBeyondRange() {
        return (selected() == FaultKind.STUCK || selected() == FaultKind.SHORT_RANGE) && value.doubleValue() > range;
    }

    /** Warns of distances beyond the range of a sensor, metres. They are allowed. */
    public void setRange(double metres) {
        if (metres != range) {
            range = metres;
            updateProblem();
        }
    }

    /** A text that wraps at the width of its cell and does not widen the cell. */
    private static final class NarrowText extends JTextArea {

        NarrowText() {
            setEditable(false);
            setFocusable(false);
            setOpaque(false);
            setLineWrap(true);
            setWrapStyleWord(true);
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(MIN_TEXT_COLUMNS * getColumnWidth(), super.getPreferredSize().height);
        }

        @Override
        public Dimension getMinimumSize() {
            return getPreferredSize();
        }

        /** The height depends on the width. */
        @Override
        public void setBounds(int x, int y, int width, int height) {
            boolean resized = width != getWidth();
            super.setBounds(x, y, width, height);
            if (resized) {
                EventQueue.invokeLater(this::revalidate);
            }
        }
    }
}
