package faultline.gui.panel;

import faultline.gui.edit.CommandSender;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.MutedLabel;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Palette;
import faultline.sensor.SensorSpec;
import faultline.world.SensorSnapshot;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.JPanel;

/** The controls of all sensors, one row each. */
public final class SensorsPanel extends JPanel {

    private static final int SELECTION_MARGIN = 2;
    private static final int SELECTION_ALPHA = 40;

    private final transient CommandSender sender;
    private final transient List<SensorRow> rows = new ArrayList<>();
    private final transient List<Consumer<String>> listeners = new ArrayList<>();
    private List<String> ids = List.of();
    /** The id of the highlighted sensor, null for none. */
    private String selected;

    /** Creates a panel without sensors. */
    SensorsPanel(CommandSender sender) {
        super(new WrappingGridLayout());
        this.sender = sender;
    }

    /** Shows the current state of the sensors, in the robot's order. */
    public void setSensors(List<SensorSnapshot> sensors) {
        assert EventQueue.isDispatchThread();
        List<String> now = sensors.stream().map(sensor -> sensor.spec().id()).toList();
        if (!now.equals(ids)) {
            ids = now;
            rebuild(sensors);
        }
        List<SensorSpec> expected = sender.pendingEdits().robot().sensors();
        Rectangle changed = new Rectangle();
        for (int i = 0; i < rows.size(); i++) {
            Rectangle readings = rows.get(i).setSensor(expected.get(i), sensors.get(i));
            changed = changed.isEmpty() ? readings : readings.isEmpty() ? changed : changed.union(readings);
        }
        // Bars that are painted one by one would show readings of two frames side by side.
        repaint(changed);
    }

    /** Gives the highlighted sensor the id that it has in the next snapshot, as returned for the present one. */
    void renameSensors(UnaryOperator<String> presentId) {
        selected = selected == null ? null : presentId.apply(selected);
    }

    /** Highlights the row of a sensor, null for none. */
    void selectSensor(String id) {
        assert EventQueue.isDispatchThread();
        if (!Objects.equals(id, selected)) {
            selected = id;
            selectedRow().ifPresent(row -> scrollRectToVisible(row.bounds()));
            repaint();
        }
    }

    /**
     * Adds a listener for the ids of sensors whose row the user selects, by a click on the badge or by moving the
     * focus.
     */
    public void addSelectionListener(Consumer<String> listener) {
        listeners.add(listener);
    }

    /** Highlights the row of a sensor and notifies the listeners. */
    void selectByUser(String id) {
        selectSensor(id);
        listeners.forEach(listener -> listener.accept(id));
    }

    private Optional<SensorRow> selectedRow() {
        int index = ids.indexOf(selected);
        return index >= 0 && index < rows.size() ? Optional.of(rows.get(index)) : Optional.empty();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        selectedRow()
                .map(SensorRow::bounds)
                .ifPresent(row -> Antialiasing.paint(graphics, g -> {
                    Color accent = Theme.current().palette().accent();
                    g.setColor(Palette.withAlpha(accent, SELECTION_ALPHA));
                    Shape mark = Antialiasing.roundedRectangle(
                            0, row.y - SELECTION_MARGIN, getWidth(), row.height + 2 * SELECTION_MARGIN);
                    g.fill(mark);
                    g.setColor(accent);
                    g.draw(mark);
                }));
    }

    private void rebuild(List<SensorSnapshot> sensors) {
        removeAll();
        rows.clear();
        add(MutedLabel.ofKey("sensors.sensor"), FormConstraints.fillCell(1, 0));
        add(MutedLabel.ofKey("sensors.range"), FormConstraints.cell(2, 0));
        add(MutedLabel.ofKey("sensors.cone"), FormConstraints.cell(3, 0));
        add(MutedLabel.ofKey("sensors.true"), FormConstraints.cell(4, 0));
        add(MutedLabel.ofKey("sensors.reported"), FormConstraints.cell(5, 0));
        for (int i = 0; i < sensors.size(); i++) {
            SensorRow row = new SensorRow(i, ids.get(i), sender, this::selectByUser);
            row.addTo(this, i + 1);
            rows.add(row);
        }
        revalidate();
        repaint();
    }
}
