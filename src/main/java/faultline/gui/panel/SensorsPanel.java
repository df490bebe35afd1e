package faultline.gui.panel;

import faultline.gui.text.Texts;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.EventQueue;
import java.awt.GridBagLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;

/** A row of controls for every sensor of the robot. */
public final class SensorsPanel extends JPanel {

    private final transient Consumer<Command> commands;
    private final transient List<SensorRow> rows = new ArrayList<>();
    private List<String> ids = List.of();

    /**
     * Without sensors at first.
     *
     * @param commands where switching and tuning goes
     */
    public SensorsPanel(Consumer<Command> commands) {
        super(new GridBagLayout());
        this.commands = commands;
    }

    /**
     * Shows how the sensors are now.
     *
     * @param sensors in the robot's order
     */
    public void show(List<SensorSnapshot> sensors) {
        assert EventQueue.isDispatchThread();
        List<String> now = sensors.stream().map(sensor -> sensor.spec().id()).toList();
        if (!now.equals(ids)) {
            ids = now;
            rebuild(sensors);
        }
        for (int i = 0; i < rows.size(); i++) {
            rows.get(i).show(sensors.get(i));
        }
    }

    /**
     * Switches a sensor the other way.
     *
     * @param index its place in the robot's order, from 0; nothing happens where there is none
     */
    public void toggle(int index) {
        assert EventQueue.isDispatchThread();
        if (index < rows.size()) {
            rows.get(index).toggle();
        }
    }

    private void rebuild(List<SensorSnapshot> sensors) {
        removeAll();
        rows.clear();
        add(new MutedLabel(Texts.text("sensors.sensor")), Grid.wide(1, 0));
        add(new MutedLabel(Texts.text("sensors.range")), Grid.cell(2, 0));
        add(new MutedLabel(Texts.text("sensors.cone")), Grid.cell(3, 0));
        add(new MutedLabel(Texts.text("sensors.reading")), Grid.cell(4, 0));
        for (int i = 0; i < sensors.size(); i++) {
            SensorRow row = new SensorRow(i, sensors.get(i).spec(), commands);
            row.addTo(this, i + 1);
            rows.add(row);
        }
        revalidate();
        repaint();
    }
}
