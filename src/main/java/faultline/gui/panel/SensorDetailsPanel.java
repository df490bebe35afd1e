package faultline.gui.panel;

import faultline.gui.edit.UndoController;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.GlyphIcon;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridBagLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;

/** The settings of the selected sensor: its mounting and faults. Below them, all active faults. */
public final class SensorDetailsPanel extends JPanel {

    private static final int SECTION_GAP = 8;

    private final transient UndoController editor;
    private final transient SensorMountFields mountFields;
    private final transient List<Consumer<Optional<String>>> listeners = new ArrayList<>();
    private final JComboBox<String> sensorChoice = new JComboBox<>();
    private final JComboBox<FaultKind> faultKind = new JComboBox<>(FaultKind.values());
    private final NumberSpinner valueSpinner = new NumberSpinner("0.00##", 0, 1, 0.05, ignored -> {});
    private final MutedLabel unitLabel = new MutedLabel("m");
    private final JButton inject = new JButton(Messages.get("faults.inject"));
    private final JLabel valueProblem = new JLabel(
            " ", new GlyphIcon(Glyph.WARNING, 14, colours -> Optional.of(colours.warning())), JLabel.LEADING);
    private final FaultList faultList;
    private List<String> ids = List.of();

    /**
     * Creates a panel without sensors.
     *
     * @param editor receives changes and faults
     */
    SensorDetailsPanel(UndoController editor) {
        super(new BorderLayout(0, SECTION_GAP));
        this.editor = editor;
        this.mountFields = new SensorMountFields(editor);
        this.faultList = new FaultList(editor);
        configureControls();
        add(createForm(), BorderLayout.NORTH);
        add(faultList, BorderLayout.CENTER);
    }

    private void configureControls() {
        faultKind.setRenderer(new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(
                    JList<?> items, Object item, int index, boolean selected, boolean focused) {
                return super.getListCellRendererComponent(
                        items, FaultNames.nameOf((FaultKind) item), index, selected, focused);
            }
        });
        sensorChoice.addActionListener(event -> {
            mountFields.setSensor(selectedSensor());
            listeners.forEach(listener -> listener.accept(selectedSensor()));
        });
        faultKind.setMaximumRowCount(FaultKind.values().length);
        faultKind.addActionListener(event -> updateFaultKind());
        faultKind.setSelectedItem(FaultKind.STUCK);
        valueSpinner.withName(Messages.get("faults.value")).withColumns(5).keepInvalidText();
        valueSpinner.textField().addPropertyChangeListener("editValid", event -> updateValueProblem());
        valueProblem.setVisible(false);
        inject.setToolTipText(Messages.get("faults.inject.tip"));
        inject.addActionListener(event -> inject());
        name(sensorChoice, "faults.sensor");
        name(faultKind, "faults.kind");
    }

    private static void name(JComponent control, String key) {
        control.getAccessibleContext().setAccessibleName(Messages.get(key));
        control.setToolTipText(Messages.get(key));
    }

    private JComponent createForm() {
        JPanel form = new JPanel(new GridBagLayout());
        form.add(label("faults.sensor", sensorChoice), FormConstraints.cell(0, 0));
        form.add(sensorChoice, FormConstraints.fillRow(1, 0));
        mountFields.addTo(form, 1);
        form.add(label("faults.kind", faultKind), withSectionGap(FormConstraints.cell(0, 3)));
        form.add(faultKind, withSectionGap(FormConstraints.fillRow(1, 3)));
        form.add(label("faults.value", valueSpinner), FormConstraints.cell(0, 4));
        form.add(valueSpinner, FormConstraints.cell(1, 4));
        form.add(unitLabel, FormConstraints.cell(2, 4));
        GridBagConstraints right = FormConstraints.fillCell(3, 4);
        right.fill = GridBagConstraints.NONE;
        right.anchor = GridBagConstraints.BASELINE_TRAILING;
        form.add(inject, right);
        form.add(valueProblem, FormConstraints.fillRow(1, 5));
        return form;
    }

    private static GridBagConstraints withSectionGap(GridBagConstraints constraints) {
        constraints.insets.top += SECTION_GAP;
        return constraints;
    }

    private static JLabel label(String key, JComponent control) {
        JLabel label = new JLabel(Messages.get(key));
        label.setLabelFor(control);
        return label;
    }

    private FaultKind faultKind() {
        return (FaultKind) faultKind.getSelectedItem();
    }

    private void updateFaultKind() {
        valueSpinner.setEnabled(faultKind().takesValue());
        valueSpinner.setLimits(
                faultKind().minValue(), faultKind().maxValue(), faultKind().defaultValue());
        unitLabel.setText(
                faultKind().takesValue() && faultKind().unit().isEmpty()
                        ? Messages.get("faults.share")
                        : faultKind().unit());
        updateValueProblem();
    }

    /** Injects the fault, or nothing if the field does not contain a valid value. */
    private void inject() {
        if (faultKind().takesValue() && !valueSpinner.commitValidEdit()) {
            updateValueProblem();
            valueSpinner.textField().requestFocusInWindow();
            return;
        }
        selectedSensor()
                .ifPresent(id ->
                        editor.send(new Command.InjectFault(id, faultKind().createFault(valueSpinner.doubleValue()))));
    }

    private void updateValueProblem() {
        boolean invalid = faultKind().takesValue() && !valueSpinner.textField().isEditValid();
        if (invalid) {
            valueProblem.setText(Messages.get("faults.invalid", valueSpinner.limitsText()));
        }
        valueProblem.setVisible(invalid);
        revalidate();
    }

    private Optional<String> selectedSensor() {
        return Optional.ofNullable((String) sensorChoice.getSelectedItem());
    }

    /**
     * Selects a sensor.
     *
     * @param id the id of the sensor; empty keeps the selection
     */
    void selectSensor(Optional<String> id) {
        assert EventQueue.isDispatchThread();
        if (id.isPresent() && !id.equals(selectedSensor())) {
            sensorChoice.setSelectedItem(id.get());
        }
    }

    /** Adds a listener for sensors selected here. */
    void addChoiceListener(Consumer<Optional<String>> listener) {
        listeners.add(listener);
    }

    /** Shows the sensors and their faults, in the robot's order. */
    public void setSensors(List<SensorSnapshot> sensors) {
        assert EventQueue.isDispatchThread();
        List<String> now =
                sensors.stream().map(snapshot -> snapshot.spec().id()).toList();
        if (!now.equals(ids)) {
            ids = now;
            sensorChoice.setModel(new DefaultComboBoxModel<>(now.toArray(String[]::new)));
            inject.setEnabled(!now.isEmpty());
            mountFields.setSensor(selectedSensor());
        }
        mountFields.update();
        faultList.setSensors(sensors);
    }
}
