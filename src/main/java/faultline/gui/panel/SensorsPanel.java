package faultline.gui.panel;

import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.Theme;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Shape;
import java.awt.GridBagLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;

/** A row of controls for every sensor of the robot. */
public final class SensorsPanel extends JPanel {

    private static final int MARK = 2;
    private static final int MARK_ALPHA = 40;

    private final transient SensorEchoes echoes;
    private final transient Editor editor;
    private final transient List<SensorRow> rows = new ArrayList<>();
    private final transient List<Consumer<Optional<String>>> listeners = new ArrayList<>();
    private List<String> ids = List.of();
    private transient Optional<String> selected = Optional.empty();

    /**
     * Without sensors at first.
     *
     * @param echoes what was asked of each sensor
     * @param editor where switching and tuning goes
     */
    SensorsPanel(SensorEchoes echoes, Editor editor) {
        super(new GridBagLayout());
        this.echoes = echoes;
        this.editor = editor;
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

    /**
     * Marks the row of a sensor.
     *
     * @param sensor its id, empty for none
     */
    public void select(Optional<String> sensor) {
        assert EventQueue.isDispatchThread();
        if (!sensor.equals(selected)) {
            selected = sensor;
            rowOfSelected().ifPresent(row -> scrollRectToVisible(row.bounds()));
            repaint();
        }
    }

    /**
     * Tells a listener, from now on, when the user chooses a row: by a click on its number, or by going to one of its controls.
     *
     * @param listener gets the sensor's id
     */
    public void addSelectionListener(Consumer<Optional<String>> listener) {
        listeners.add(listener);
    }

    /** Marks the row of a sensor and tells the listeners. */
    void choose(Optional<String> sensor) {
        select(sensor);
        listeners.forEach(listener -> listener.accept(selected));
    }

    private Optional<SensorRow> rowOfSelected() {
        return selected.map(ids::indexOf).filter(index -> index >= 0 && index < rows.size()).map(rows::get);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        rowOfSelected().map(SensorRow::bounds).ifPresent(row -> Smooth.paint(graphics, g -> {
            Color accent = Theme.current().palette().accent();
            g.setColor(new Color(accent.getRed(), accent.getGreen(), accent.getBlue(), MARK_ALPHA));
            Shape mark = Smooth.box(0, row.y - MARK, getWidth(), row.height + 2 * MARK);
            g.fill(mark);
            g.setColor(accent);
            g.draw(mark);
        }));
    }

    private void rebuild(List<SensorSnapshot> sensors) {
        removeAll();
        rows.clear();
        add(new MutedLabel(Texts.text("sensors.sensor")), Grid.wide(1, 0));
        add(new MutedLabel(Texts.text("sensors.range")), Grid.cell(2, 0));
        add(new MutedLabel(Texts.text("sensors.cone")), Grid.cell(3, 0));
        add(new MutedLabel(Texts.text("sensors.true")), Grid.cell(4, 0));
        add(new MutedLabel(Texts.text("sensors.reported")), Grid.cell(5, 0));
        for (int i = 0; i < sensors.size(); i++) {
            SensorRow row = new SensorRow(i, ids.get(i), echoes, editor, id -> choose(Optional.of(id)));
            row.addTo(this, i + 1);
            rows.add(row);
        }
        revalidate();
        repaint();
    }
}
