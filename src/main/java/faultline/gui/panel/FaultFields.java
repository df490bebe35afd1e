package faultline.gui.panel;

import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.awt.Component;
import java.awt.GridBagConstraints;
import java.util.Optional;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;

/** The fields of a fault: its kind, its number and, if the kind has one, its mean length. */
public final class FaultFields {

    private static final double MIN_LENGTH = 0.001;
    private static final int COLUMNS = 5;

    private final JComboBox<FaultKind> kind = new JComboBox<>(FaultKind.values());
    private final NumberSpinner value = new NumberSpinner("0.00##", 0, 1, 0.05, ignored -> {});
    private final NumberSpinner length =
            new NumberSpinner("0.00##", MIN_LENGTH, FaultKind.MAX_LENGTH, 0.1, ignored -> {});
    private final JLabel lengthLabel = FormConstraints.label("faults.length", length);
    private final MutedLabel unit = new MutedLabel("m");
    private final MutedLabel lengthUnit = new MutedLabel("s");
    private final JLabel problem =
            new JLabel(" ", new GlyphIcon(Glyph.WARNING, 14, colours -> colours.warning()), JLabel.LEADING);

    /** Creates the fields of a sensor that is stuck. */
    public FaultFields() {
        kind.setRenderer(new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> items, Object item, int index, boolean selected, boolean focused) {
                return super.getListCellRendererComponent(
                        items, FaultNames.nameOf((FaultKind) item), index, selected, focused);
            }
        });
        kind.setMaximumRowCount(FaultKind.values().length);
        kind.addActionListener(event -> updateKind());
        kind.getAccessibleContext().setAccessibleName(Messages.get("faults.kind"));
        kind.setToolTipText(Messages.get("faults.kind"));
        configure(value, "faults.value");
        configure(length, "faults.length");
        kind.setSelectedItem(FaultKind.STUCK);
        problem.setVisible(false);
    }

    private void configure(NumberSpinner spinner, String key) {
        spinner.withName(Messages.get(key)).withColumns(COLUMNS).keepInvalidText();
        spinner.textField().addPropertyChangeListener("editValid", event -> updateProblem());
    }

    /**
     * Adds the fields to a form.
     *
     * @param form has a {@link java.awt.GridBagLayout}
     * @param row the first of four rows
     * @param gap the gap above the first row, pixels
     */
    public void addTo(JPanel form, int row, int gap) {
        GridBagConstraints first = FormConstraints.cell(0, row);
        first.insets.top += gap;
        form.add(FormConstraints.label("faults.kind", kind), first);
        GridBagConstraints second = FormConstraints.fillRow(1, row);
        second.insets.top += gap;
        form.add(kind, second);
        form.add(FormConstraints.label("faults.value", value), FormConstraints.cell(0, row + 1));
        form.add(value, FormConstraints.cell(1, row + 1));
        form.add(unit, FormConstraints.cell(2, row + 1));
        form.add(lengthLabel, FormConstraints.cell(0, row + 2));
        form.add(length, FormConstraints.cell(1, row + 2));
        form.add(lengthUnit, FormConstraints.cell(2, row + 2));
        form.add(problem, FormConstraints.fillRow(1, row + 3));
    }

    private FaultKind kind() {
        return (FaultKind) kind.getSelectedItem();
    }

    private void updateKind() {
        value.setEnabled(kind().takesValue());
        value.setLimits(kind().minValue(), kind().maxValue(), kind().defaultValue());
        length.setLimits(MIN_LENGTH, FaultKind.MAX_LENGTH, FaultKind.DEFAULT_LENGTH);
        for (JComponent part : new JComponent[] {lengthLabel, length, lengthUnit}) {
            part.setVisible(kind().takesLength());
        }
        boolean share = kind().unit().isEmpty() && kind().maxValue() == 1;
        unit.setText(share ? Messages.get("faults.share") : kind().unit());
        updateProblem();
    }

    /** Shows a fault. */
    public void setFault(Fault fault) {
        kind.setSelectedItem(fault.kind());
        value.setLimits(fault.kind().minValue(), fault.kind().maxValue(), fault.value());
        if (fault.kind().takesLength()) {
            length.setLimits(MIN_LENGTH, FaultKind.MAX_LENGTH, fault.length());
        }
    }

    /** Returns the fault, or moves the focus to the invalid number and returns nothing. */
    public Optional<Fault> commitFault() {
        if (kind().takesValue() && !isCommitted(value) || kind().takesLength() && !isCommitted(length)) {
            return Optional.empty();
        }
        return Optional.of(kind().createFault(value.doubleValue(), length.doubleValue()));
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
        boolean wrongValue = kind().takesValue() && !value.textField().isEditValid();
        boolean wrongLength = kind().takesLength() && !length.textField().isEditValid();
        if (wrongValue || wrongLength) {
            problem.setText(Messages.get("faults.invalid", (wrongValue ? value : length).limitsText()));
        }
        problem.setVisible(wrongValue || wrongLength);
    }
}
