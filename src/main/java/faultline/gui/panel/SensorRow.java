package faultline.gui.panel;

import faultline.geometry.Degrees;
import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.SensorSnapshot;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JPanel;

/** The controls of one sensor: its switch, range and cone, and what it reports. */
final class SensorRow {

    private static final double MOST_RANGE = 100;
    private static final double LEAST_RANGE = 0.01;
    private static final double LEAST_CONE = 0.1;
    private static final double MOST_CONE = 179.9;
    private static final int NAME_WIDTH = 92;

    private final Swatch swatch;
    private final JCheckBox onOff = new JCheckBox();
    private final NumberSpinner range;
    private final NumberSpinner cone;
    private final ReadingBar truth;
    private final ReadingBar reported;
    private final String id;
    private final SensorEchoes echoes;
    private final Editor editor;
    private final ShownDegrees shownCone = new ShownDegrees();

    SensorRow(int index, String id, SensorEchoes echoes, Editor editor, Consumer<String> chosen) {
        this.id = id;
        this.echoes = echoes;
        this.editor = editor;
        swatch = new Swatch(index);
        range = new NumberSpinner("0.00##", LEAST_RANGE, MOST_RANGE, 0.05, metres -> tune(spec().withRange(metres)));
        cone = new NumberSpinner("0.##", LEAST_CONE, MOST_CONE, 1, degrees -> tune(spec().withCone(Degrees.toRadians(degrees))));
        truth = new ReadingBar(id, ReadingBar.Side.TRUE);
        reported = new ReadingBar(id, ReadingBar.Side.REPORTED);
        range.named(Texts.text("sensor.range", id)).columns(4);
        cone.named(Texts.text("sensor.cone", id)).columns(3);
        prepareSwitch();
        listen(() -> chosen.accept(id));
    }

    private SensorSpec spec() {
        return echoes.of(id);
    }

    /** A row is chosen by its number, or by going to one of its controls. */
    private void listen(Runnable chosen) {
        swatch.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                chosen.run();
            }
        });
        FocusAdapter focus = new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                chosen.run();
            }
        };
        onOff.addFocusListener(focus);
        range.text().addFocusListener(focus);
        cone.text().addFocusListener(focus);
    }

    /** Where the row is in its grid. */
    Rectangle bounds() {
        return onOff.getBounds().union(reported.getBounds()).union(swatch.getBounds()).union(range.getBounds());
    }

    private void prepareSwitch() {
        onOff.setText(id);
        onOff.setOpaque(false);
        onOff.setPreferredSize(new Dimension(TextSize.scaled(NAME_WIDTH), onOff.getPreferredSize().height));
        onOff.setMinimumSize(onOff.getPreferredSize());
        onOff.setToolTipText(Texts.text("sensor.switch", id));
        onOff.getAccessibleContext().setAccessibleName(Texts.text("sensor.switch", id));
        onOff.addActionListener(event -> switchTo(onOff.isSelected()));
    }

    /** Puts the controls into a row of a grid. */
    void addTo(JPanel grid, int row) {
        grid.add(swatch, Grid.centred(0, row));
        grid.add(onOff, Grid.wide(1, row));
        grid.add(range, Grid.cell(2, row));
        grid.add(cone, Grid.cell(3, row));
        grid.add(truth, Grid.leading(4, row));
        grid.add(reported, Grid.leading(5, row));
    }

    private void switchTo(boolean on) {
        echoes.ask(spec().withOn(on));
        editor.send(new Command.SwitchSensor(id, on));
    }

    private void tune(SensorSpec wanted) {
        editor.send(new Command.TuneSensor(echoes.ask(wanted)));
    }

    /** Switches the sensor the other way. */
    void toggle() {
        switchTo(!spec().on());
    }

    /** Shows how the sensor is now. */
    void show(SensorSnapshot snapshot) {
        SensorSpec shown = spec();
        if (onOff.isSelected() != shown.on()) {
            onOff.setSelected(shown.on());
        }
        range.follow(shown.range());
        cone.follow(shownCone.of(shown.cone()));
        truth.show(snapshot);
        reported.show(snapshot);
    }
}
