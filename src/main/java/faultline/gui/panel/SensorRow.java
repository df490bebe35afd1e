package faultline.gui.panel;

import faultline.geometry.Degrees;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditLimits;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.CachedDegrees;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
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
import java.util.function.UnaryOperator;
import javax.swing.JCheckBox;
import javax.swing.JPanel;

/** The controls of one sensor: its switch, range and cone, and its readings. */
final class SensorRow {

    private static final double MIN_CONE = 0.1;
    private static final double MAX_CONE = 179.9;
    private static final int NAME_WIDTH = 92;

    private final SensorBadge badge;
    private final JCheckBox enabledBox = new JCheckBox();
    private final NumberSpinner range;
    private final NumberSpinner cone;
    private final ReadingBar actualReading;
    private final ReadingBar reportedReading;
    private final String id;
    private final CommandSender sender;
    private final CachedDegrees coneDegrees = new CachedDegrees();

    SensorRow(int index, String id, CommandSender sender, Consumer<String> chosen) {
        this.id = id;
        this.sender = sender;
        badge = new SensorBadge(index);
        range = new NumberSpinner(
                "0.00##",
                EditLimits.MIN_SENSOR_RANGE,
                EditLimits.MAX_SENSOR_RANGE,
                0.05,
                metres -> configureSensor(spec -> spec.withRange(metres)));
        cone = new NumberSpinner(
                "0.##",
                MIN_CONE,
                MAX_CONE,
                1,
                degrees -> configureSensor(spec -> spec.withCone(Degrees.toRadians(degrees))));
        actualReading = new ReadingBar(index, id, ReadingBar.ReadingKind.ACTUAL);
        reportedReading = new ReadingBar(index, id, ReadingBar.ReadingKind.REPORTED);
        range.withName("sensor.range", id).withColumns(5);
        cone.withName("sensor.cone", id).withColumns(4);
        configureEnabledBox();
        installSelectionListeners(() -> chosen.accept(id));
    }

    /** Selects the row on a click on its badge, or when one of its controls gains the focus. */
    private void installSelectionListeners(Runnable chosen) {
        badge.addMouseListener(new MouseAdapter() {
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
        enabledBox.addFocusListener(focus);
        range.textField().addFocusListener(focus);
        cone.textField().addFocusListener(focus);
    }

    /** Returns the bounds of the row in its grid. */
    Rectangle bounds() {
        return enabledBox
                .getBounds()
                .union(reportedReading.getBounds())
                .union(badge.getBounds())
                .union(range.getBounds());
    }

    private void configureEnabledBox() {
        enabledBox.setText(id);
        enabledBox.setOpaque(false);
        RefreshSteps.add(enabledBox, box -> {
            box.setPreferredSize(null);
            Dimension natural = box.getPreferredSize();
            int width = TextSize.scaled(NAME_WIDTH);
            box.setPreferredSize(new Dimension(width, natural.height));
            box.setMinimumSize(new Dimension(Math.min(width, natural.width), natural.height));
            box.setToolTipText(Messages.get("sensor.switch", id));
            box.getAccessibleContext().setAccessibleName(Messages.get("sensor.switch", id));
        });
        enabledBox.addActionListener(event -> sender.send(new Command.SwitchSensor(id, enabledBox.isSelected())));
    }

    /** Adds the controls to a row of a grid. */
    void addTo(JPanel grid, int row) {
        grid.add(badge, FormConstraints.centredCell(0, row));
        grid.add(enabledBox, FormConstraints.fillCell(1, row));
        grid.add(range, FormConstraints.cell(2, row));
        grid.add(cone, FormConstraints.cell(3, row));
        grid.add(actualReading, FormConstraints.leadingCell(4, row));
        grid.add(reportedReading, FormConstraints.leadingCell(5, row));
    }

    /** Changes the sensor; does nothing if a field loses the focus because the robot has no such sensor any more. */
    private void configureSensor(UnaryOperator<SensorSpec> change) {
        sender.pendingEdits()
                .robot()
                .sensor(id)
                .ifPresent(spec -> sender.send(new Command.ConfigureSensor(change.apply(spec))));
    }

    /**
     * Shows the settings of the sensor as they will be after all pending edits, and its current readings; returns the
     * place of the readings, empty if they are the same as before.
     */
    Rectangle setSensor(SensorSpec shown, SensorSnapshot snapshot) {
        if (enabledBox.isSelected() != shown.on()) {
            enabledBox.setSelected(shown.on());
        }
        range.setWorldValue(shown.range());
        cone.setWorldValue(coneDegrees.toDegrees(shown.cone()));
        boolean changed = actualReading.setSnapshot(snapshot) | reportedReading.setSnapshot(snapshot);
        return changed ? actualReading.getBounds().union(reportedReading.getBounds()) : new Rectangle();
    }
}
