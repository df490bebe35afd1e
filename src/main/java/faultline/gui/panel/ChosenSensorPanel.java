package faultline.gui.panel;

import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
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

/** One sensor, chosen by its name: how it is mounted, and what breaks it. Below it all that is broken. */
public final class ChosenSensorPanel extends JPanel {

    private static final int PARTS = 8;

    private final transient Editor editor;
    private final transient MountFields mount;
    private final transient List<Consumer<Optional<String>>> listeners = new ArrayList<>();
    private final JComboBox<String> sensor = new JComboBox<>();
    private final JComboBox<FaultKind> kind = new JComboBox<>(FaultKind.values());
    private final NumberSpinner value = new NumberSpinner("0.00##", 0, 1, 0.05, ignored -> {
    });
    private final MutedLabel unit = new MutedLabel("m");
    private final JButton inject = new JButton(Texts.text("faults.inject"));
    private final FaultList list;
    private List<String> ids = List.of();

    /**
     * Without sensors at first.
     *
     * @param echoes what was asked of each sensor
     * @param editor where changes and faults go
     */
    ChosenSensorPanel(SensorEchoes echoes, Editor editor) {
        super(new BorderLayout(0, PARTS));
        this.editor = editor;
        this.mount = new MountFields(echoes, editor);
        this.list = new FaultList(editor);
        prepare();
        add(form(), BorderLayout.NORTH);
        add(list, BorderLayout.CENTER);
    }

    private void prepare() {
        kind.setRenderer(new DefaultListCellRenderer() {
            @Override
            public Component getListCellRendererComponent(JList<?> items, Object item, int index, boolean selected, boolean focused) {
                return super.getListCellRendererComponent(items, FaultNames.of((FaultKind) item), index, selected, focused);
            }
        });
        sensor.addActionListener(event -> {
            mount.choose(chosen());
            listeners.forEach(listener -> listener.accept(chosen()));
        });
        kind.addActionListener(event -> showKind());
        kind.setSelectedItem(FaultKind.STUCK);
        value.named(Texts.text("faults.value")).columns(6);
        inject.setToolTipText(Texts.text("faults.inject.tip"));
        inject.addActionListener(event -> inject());
        name(sensor, "faults.sensor");
        name(kind, "faults.kind");
    }

    private static void name(JComponent control, String key) {
        control.getAccessibleContext().setAccessibleName(Texts.text(key));
        control.setToolTipText(Texts.text(key));
    }

    private JComponent form() {
        JPanel form = new JPanel(new GridBagLayout());
        form.add(label("faults.sensor", sensor), Grid.cell(0, 0));
        form.add(sensor, Grid.rest(1, 0));
        mount.addTo(form, 1);
        form.add(label("faults.kind", kind), below(Grid.cell(0, 3)));
        form.add(kind, below(Grid.rest(1, 3)));
        form.add(label("faults.value", value), Grid.cell(0, 4));
        form.add(value, Grid.cell(1, 4));
        form.add(unit, Grid.wide(2, 4));
        GridBagConstraints right = Grid.rest(3, 4);
        right.fill = GridBagConstraints.NONE;
        right.anchor = GridBagConstraints.BASELINE_TRAILING;
        form.add(inject, right);
        return form;
    }

    private static GridBagConstraints below(GridBagConstraints place) {
        place.insets.top += PARTS;
        return place;
    }

    private static JLabel label(String key, JComponent control) {
        JLabel label = new JLabel(Texts.text(key));
        label.setLabelFor(control);
        return label;
    }

    private FaultKind kind() {
        return (FaultKind) kind.getSelectedItem();
    }

    private void showKind() {
        value.setEnabled(kind().takesValue());
        value.limit(kind().least(), kind().most(), kind().usual());
        unit.setText(kind().takesValue() && kind().unit().isEmpty() ? Texts.text("faults.share") : kind().unit());
    }

    private void inject() {
        chosen().ifPresent(id -> editor.send(new Command.InjectFault(id, kind().fault(value.value()))));
    }

    private Optional<String> chosen() {
        return Optional.ofNullable((String) sensor.getSelectedItem());
    }

    /**
     * Goes over to a sensor.
     *
     * @param id of the sensor; with none, the last one stays
     */
    void choose(Optional<String> id) {
        assert EventQueue.isDispatchThread();
        if (id.isPresent() && !id.equals(chosen())) {
            sensor.setSelectedItem(id.get());
        }
    }

    /** Tells a listener, from now on, when another sensor is chosen here. */
    void addChoiceListener(Consumer<Optional<String>> listener) {
        listeners.add(listener);
    }

    /**
     * Shows which sensors there are, and what is broken now.
     *
     * @param sensors in the robot's order
     */
    public void show(List<SensorSnapshot> sensors) {
        assert EventQueue.isDispatchThread();
        List<String> now = sensors.stream().map(snapshot -> snapshot.spec().id()).toList();
        if (!now.equals(ids)) {
            ids = now;
            sensor.setModel(new DefaultComboBoxModel<>(now.toArray(String[]::new)));
            inject.setEnabled(!now.isEmpty());
            mount.choose(chosen());
        }
        mount.follow();
        list.show(sensors);
    }
}
