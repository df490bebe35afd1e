package faultline.gui.instrument;

import faultline.geometry.Angles;
import faultline.gui.text.Messages;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/** The numbers of a t_D/2 manoeuvre in words; a dash for what is not known yet. */
final class AlignmentText {

    private AlignmentText() {}

    /**
     * A number with its name.
     *
     * @param name for people
     * @param value with its unit
     */
    record Row(String name, String value) {}

    static List<Row> rows(AlignmentTrace spin) {
        OptionalDouble predicted = spin.isTimed() ? OptionalDouble.of(spin.predictedHeading()) : OptionalDouble.empty();
        return List.of(
                row("f3", seconds(spin.f3())),
                row("f4", seconds(spin.f4())),
                row("tD", seconds(spin.tD())),
                row("tP", seconds(spin.tP())),
                row("predicted", degrees(predicted, "%.2f°")),
                row("achieved", degrees(spin.achievedHeading(), "%.2f°")),
                row("error", degrees(spin.headingError(), "%+.2f°")));
    }

    private static Row row(String key, String value) {
        return new Row(Messages.get("spin." + key), value);
    }

    private static String seconds(double value) {
        return Double.isNaN(value) ? "–" : String.format(Locale.ROOT, "%.3f s", value);
    }

    private static String degrees(OptionalDouble radians, String format) {
        return radians.isEmpty()
                ? "–"
                : String.format(Locale.ROOT, format, Math.toDegrees(Angles.normalize(radians.getAsDouble())))
                        .replace('-', '\u2212');
    }
}
