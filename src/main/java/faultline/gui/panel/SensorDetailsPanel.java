package faultline.gui.panel;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.edit.CommandSender;
import faultline.gui.form.EnteredTextField;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.theme.Glyph;
import faultline.gui.theme.UiText;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.GridBagConstraints;
import java.awt.GridLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The settings of the selected sensor: its id, mounting and faults. Below them, all active faults. */
public final class SensorDetailsPanel extends JPanel {

    private static final int SECTION_GAP = 8;
    private static final int BUTTON_GAP = 2;
    private static final int ID_COLUMNS = 8;
    private static final int FAULT_ROW = 3;

    private final transient CommandSender sender;
    private final transient SensorMountFields mountFields;
    private final transient List<Consumer<String>> listeners = new ArrayList<>();
    private final EnteredTextField.IdField idField;
    private final JComboBox<String> sensorChoice = new JComboBox<>();
    private final transient FaultFields<FaultKind, Fault> fault = FaultFields.forSensors();
    private final JButton inject = UiText.button("faults.inject");
    private final JButton addSensor = new JButton(Glyph.ADD.icon());
    private final JButton removeSensor = new JButton(Glyph.REMOVE.icon());
    private final FaultList faultList;
    private List<String> ids = List.of();

    /** Creates a panel without sensors. */
    SensorDetailsPanel(CommandSender sender, ControlPanel.SensorEdits edits) {
        super(new BorderLayout(0, SECTION_GAP));
        this.sender = sender;
        this.idField = new EnteredTextField.IdField("faults.id", ID_COLUMNS, edits.rename());
        this.mountFields = new SensorMountFields(sender);
        this.faultList = new FaultList(sender);
        configureControls();
        configureButtons(edits);
        add(createForm(), BorderLayout.NORTH);
        add(faultList, BorderLayout.CENTER);
    }

    private void configureControls() {
        sensorChoice.addActionListener(event -> {
            showSensor();
            selectedSensor().ifPresent(id -> listeners.forEach(listener -> listener.accept(id)));
        });
        UiText.tip(inject, "faults.inject.tip");
        inject.addActionListener(event -> inject());
        UiText.nameAndTip(sensorChoice, "faults.sensor");
        sensorChoice.setRenderer(NamedChoice.<String>rendererOf(UiText::shortName, id -> id));
    }

    private void showSensor() {
        idField.setId(selectedSensor().orElse(""));
        mountFields.setSensor(selectedSensor().orElse(null));
    }

    private void configureButtons(ControlPanel.SensorEdits edits) {
        UiText.nameAndTip(addSensor, "faults.addSensor");
        addSensor.addActionListener(event -> edits.add().run());
        UiText.nameAndTip(removeSensor, "faults.removeSensor");
        removeSensor.addActionListener(event -> selectedSensor().ifPresent(edits.remove()));
    }

    private JComponent createForm() {
        JPanel form = new JPanel(new WrappingGridLayout());
        JLabel label = FormConstraints.label("faults.sensor", sensorChoice);
        form.add(label, FormConstraints.leadingCell(0, 0));
        GridBagConstraints choiceCell = FormConstraints.fillRow(1, 0);
        choiceCell.anchor = GridBagConstraints.CENTER;
        form.add(createChoiceRow(label), choiceCell);
        mountFields.addTo(form, 1);
        fault.addTo(form, FAULT_ROW, SECTION_GAP);
        GridBagConstraints right = FormConstraints.fillCell(3, FAULT_ROW + FaultFields.VALUE_ROW);
        right.fill = GridBagConstraints.NONE;
        right.anchor = GridBagConstraints.BASELINE_TRAILING;
        form.add(inject, right);
        return form;
    }

    /** Returns the choice of a sensor with its id and the buttons that add one and remove it, given its label. */
    private JComponent createChoiceRow(JLabel label) {
        JPanel buttons = new JPanel(new GridLayout(1, 2, BUTTON_GAP, 0));
        buttons.add(addSensor);
        buttons.add(removeSensor);
        JPanel id = new JPanel(new BorderLayout(FormConstraints.GAP, 0));
        id.add(FormConstraints.label("faults.id", idField), BorderLayout.LINE_START);
        id.add(idField, BorderLayout.CENTER);
        return new SensorChoiceRow(label, sensorChoice, id, buttons);
    }

    /** Injects the fault, or nothing if the field does not contain a valid value. */
    private void inject() {
        fault.commitFault()
                .ifPresent(valid -> selectedSensor().ifPresent(id -> sender.send(new Command.InjectFault(id, valid))));
    }

    private Optional<String> selectedSensor() {
        return Optional.ofNullable((String) sensorChoice.getSelectedItem());
    }

    void selectSensor(String id) {
        assert EventQueue.isDispatchThread();
        if (!id.equals(sensorChoice.getSelectedItem())) {
            sensorChoice.setSelectedItem(id);
        }
    }

    /** Adds a listener for sensors selected here. */
    void addChoiceListener(Consumer<String> listener) {
        listeners.add(listener);
    }

    /** Prepares for another scenario, whose first sensor will be selected. */
    void startScenario() {
        setIds(List.of(), UnaryOperator.identity());
        showSensor();
    }

    /**
     * Gives the sensors the ids that they have in the next snapshot, as returned for the present ones. The fields are
     * those of the present one until then.
     */
    void renameSensors(UnaryOperator<String> presentId) {
        setIds(ids.stream().map(presentId).toList(), presentId);
    }

    /** Sets the ids of the sensors. The selected one remains selected if there is one with its present id. */
    private void setIds(List<String> newIds, UnaryOperator<String> presentId) {
        DefaultComboBoxModel<String> model = new DefaultComboBoxModel<>(newIds.toArray(String[]::new));
        selectedSensor().map(presentId).filter(newIds::contains).ifPresent(model::setSelectedItem);
        ids = newIds;
        sensorChoice.setModel(model);
    }

    /**
     * Shows the sensors and their faults, in the robot's order, given the timeline that may end the faults and the
     * present time, seconds.
     */
    void setSensors(List<SensorSnapshot> sensors, List<TimedCommand> timeline, double now) {
        assert EventQueue.isDispatchThread();
        List<String> newIds =
                sensors.stream().map(snapshot -> snapshot.spec().id()).toList();
        if (!newIds.equals(ids)) {
            setIds(newIds, UnaryOperator.identity());
        }
        showSensor();
        inject.setEnabled(!newIds.isEmpty());
        removeSensor.setEnabled(!newIds.isEmpty());
        mountFields.update();
        sensors.stream()
                .filter(sensor -> sensor.spec().id().equals(sensorChoice.getSelectedItem()))
                .forEach(sensor -> fault.setRange(sensor.spec().range()));
        faultList.setSensors(sensors, timeline, now);
    }
}
