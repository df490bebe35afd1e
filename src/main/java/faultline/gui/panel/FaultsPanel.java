package faultline.gui.panel;

import faultline.gui.text.Texts;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GridBagLayout;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultComboBoxModel;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;

/** Breaks sensors, and lists what is broken. */
public final class FaultsPanel extends JPanel {

    private final transient Consumer<Command> commands;
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
     * @param commands where faults go
     */
    public FaultsPanel(Consumer<Command> commands) {
        super(new BorderLayout(0, 8));
        this.commands = commands;
        this.list = new FaultList(commands);
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
        form.add(label("faults.kind", kind), Grid.cell(0, 1));
        form.add(kind, Grid.rest(1, 1));
        form.add(label("faults.value", value), Grid.cell(0, 2));
        form.add(value, Grid.cell(1, 2));
        form.add(unit, Grid.wide(2, 2));
        form.add(inject, Grid.cell(3, 2));
        return form;
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
        if (sensor.getSelectedItem() instanceof String id) {
            commands.accept(new Command.InjectFault(id, kind().fault(value.value())));
        }
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
        }
        list.show(sensors);
    }
}
