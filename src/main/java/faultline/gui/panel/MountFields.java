package faultline.gui.panel;

import faultline.geometry.Degrees;
import faultline.geometry.Vec;
import faultline.gui.edit.Editor;
import faultline.gui.text.Texts;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** How one sensor is mounted and how noisy it is: its bearing, its noise and its seat on the robot. */
final class MountFields {

    private static final double MOST_BEARING = 360;
    private static final double BEARING_STEP = 5;
    private static final double MOST_SEAT = 10;
    private static final double SEAT_STEP = 0.01;
    private static final double MOST_NOISE = 1;
    private static final double NOISE_STEP = 0.001;

    private final SensorEchoes echoes;
    private final Editor editor;
    private final NumberSpinner bearing = new NumberSpinner("0.##", -MOST_BEARING, MOST_BEARING, BEARING_STEP,
            degrees -> tune(spec -> spec.withBearing(Degrees.toRadians(degrees))));
    private final NumberSpinner noise = new NumberSpinner("0.000##", 0, MOST_NOISE, NOISE_STEP, metres -> tune(spec -> spec.withNoise(metres)));
    private final NumberSpinner ahead = new NumberSpinner("0.00##", -MOST_SEAT, MOST_SEAT, SEAT_STEP,
            metres -> tune(spec -> spec.withSeat(new Vec(metres, spec.seat().y()))));
    private final NumberSpinner aside = new NumberSpinner("0.00##", -MOST_SEAT, MOST_SEAT, SEAT_STEP,
            metres -> tune(spec -> spec.withSeat(new Vec(spec.seat().x(), metres))));
    private final ShownDegrees shownBearing = new ShownDegrees();
    private Optional<String> sensor = Optional.empty();

    MountFields(SensorEchoes echoes, Editor editor) {
        this.echoes = echoes;
        this.editor = editor;
        fields().forEach(field -> field.columns(6).setEnabled(false));
    }

    private Stream<NumberSpinner> fields() {
        return Stream.of(bearing, noise, ahead, aside);
    }

    /** Puts the fields into two rows of a grid of six columns. */
    void addTo(JPanel grid, int row) {
        add(grid, 0, row, "bearing", bearing, "°");
        add(grid, 3, row, "noise", noise, "m");
        add(grid, 0, row + 1, "ahead", ahead, "m");
        add(grid, 3, row + 1, "aside", aside, "m");
    }

    private static void add(JPanel grid, int column, int row, String key, NumberSpinner field, String unit) {
        JLabel label = new JLabel(Texts.text("mount." + key));
        label.setLabelFor(field);
        label.setToolTipText(Texts.text("mount." + key + ".tip"));
        field.named(Texts.text("mount." + key + ".tip"));
        grid.add(label, Grid.cell(column, row));
        grid.add(field, Grid.cell(column + 1, row));
        grid.add(new MutedLabel(unit), column == 0 ? Grid.wide(column + 2, row) : Grid.cell(column + 2, row));
    }

    private void tune(UnaryOperator<SensorSpec> change) {
        sensor.ifPresent(id -> editor.send(new Command.TuneSensor(echoes.ask(change.apply(echoes.of(id))))));
    }

    /** Goes over to another sensor, after taking what was being typed for the one before. */
    void choose(Optional<String> chosen) {
        if (!chosen.equals(sensor)) {
            fields().forEach(NumberSpinner::settle);
            sensor = chosen;
            fields().forEach(field -> field.setEnabled(chosen.isPresent()));
            follow();
        }
    }

    /** Shows how the sensor is now. */
    void follow() {
        sensor.map(echoes::of).ifPresent(spec -> {
            bearing.follow(shownBearing.of(spec.bearing()));
            noise.follow(spec.noise());
            ahead.follow(spec.seat().x());
            aside.follow(spec.seat().y());
        });
    }
}
