package faultline.gui.panel;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.EditLimits;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NumberSpinner;
import faultline.gui.text.CachedDegrees;
import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.awt.GridBagConstraints;
import java.util.Objects;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** The fields for a sensor's mounting and noise. */
final class SensorMountFields {

    private static final double BEARING_STEP = 5;
    private static final double MAX_OFFSET = 10;
    private static final double OFFSET_STEP = 0.01;
    private static final double MAX_NOISE = 1;
    private static final double NOISE_STEP = 0.001;
    private static final int COLUMN_GAP = 12;

    private final CommandSender sender;
    private final NumberSpinner bearing = new NumberSpinner(
            "0.##",
            -EditLimits.MAX_ANGLE,
            EditLimits.MAX_ANGLE,
            BEARING_STEP,
            degrees -> configureSensor(spec -> spec.withBearing(Degrees.toRadians(degrees))));
    private final NumberSpinner noise = new NumberSpinner(
            "0.000##", 0, MAX_NOISE, NOISE_STEP, metres -> configureSensor(spec -> spec.withNoise(metres)));
    private final NumberSpinner forwardOffset = new NumberSpinner(
            "0.00##",
            -MAX_OFFSET,
            MAX_OFFSET,
            OFFSET_STEP,
            metres -> configureSensor(spec -> spec.withMountPosition(
                    new Vector2(metres, spec.mountPosition().y()))));
    private final NumberSpinner leftOffset = new NumberSpinner(
            "0.00##",
            -MAX_OFFSET,
            MAX_OFFSET,
            OFFSET_STEP,
            metres -> configureSensor(spec ->
                    spec.withMountPosition(new Vector2(spec.mountPosition().x(), metres))));
    private final CachedDegrees shownBearing = new CachedDegrees();
    /** The id of the sensor, null for none. */
    private String sensor;

    SensorMountFields(CommandSender sender) {
        this.sender = sender;
        fields().forEach(field -> field.withColumns(6).setEnabled(false));
    }

    private Stream<NumberSpinner> fields() {
        return Stream.of(bearing, noise, forwardOffset, leftOffset);
    }

    /** Adds the fields to two rows of a grid of four columns. */
    void addTo(JPanel grid, int row) {
        add(grid, 0, row, "bearing", bearing, "°");
        add(grid, 2, row, "noise", noise, "m");
        add(grid, 0, row + 1, "forward", forwardOffset, "m");
        add(grid, 2, row + 1, "left", leftOffset, "m");
    }

    private static void add(JPanel grid, int column, int row, String key, NumberSpinner field, String unit) {
        JLabel label = RefreshSteps.add(new JLabel(), self -> self.setText(Messages.get("mount." + key) + ", " + unit));
        label.setLabelFor(field);
        UiText.tip(label, "mount." + key + ".tip");
        field.withName("mount." + key + ".tip");
        GridBagConstraints labelCell = FormConstraints.cell(column, row);
        labelCell.insets.left += column == 0 ? 0 : COLUMN_GAP;
        grid.add(label, labelCell);
        GridBagConstraints fieldCell = FormConstraints.cell(column + 1, row);
        fieldCell.weightx = column == 0 ? 0 : 1;
        grid.add(field, fieldCell);
    }

    private void configureSensor(UnaryOperator<SensorSpec> change) {
        spec().ifPresent(spec -> sender.send(new Command.ConfigureSensor(change.apply(spec))));
    }

    private Optional<SensorSpec> spec() {
        return sensor == null ? Optional.empty() : sender.pendingEdits().robot().sensor(sensor);
    }

    /** Selects another sensor, null for none, after committing the number being typed for the previous one. */
    void setSensor(String id) {
        if (!Objects.equals(id, sensor)) {
            fields().forEach(NumberSpinner::commitPendingEdit);
            sensor = id;
            update();
        }
    }

    /** Shows the current settings of the sensor, or disabled empty fields if there is none. */
    void update() {
        Optional<SensorSpec> shown = spec();
        fields().forEach(field -> field.setEnabled(shown.isPresent()));
        if (shown.isEmpty()) {
            fields().forEach(field -> field.setWorldValue(Double.NaN));
        }
        shown.ifPresent(spec -> {
            bearing.setWorldValue(shownBearing.toDegrees(spec.bearing()));
            noise.setWorldValue(spec.noise());
            forwardOffset.setWorldValue(spec.mountPosition().x());
            leftOffset.setWorldValue(spec.mountPosition().y());
        });
    }
}
