package faultline.gui.instrument;

import faultline.control.TimingRule;
import faultline.geometry.Angles;
import faultline.gui.text.Messages;
import faultline.gui.text.TurnTimes;
import java.util.List;
import java.util.Locale;

/** Formats the values of an alignment manoeuvre; a dash for a value that is not yet known. */
final class AlignmentText {

    private AlignmentText() {}

    /**
     * A labelled value.
     *
     * @param name the label
     * @param value the value with its unit
     */
    record NamedValue(String name, String value) {}

    static List<NamedValue> rows(AlignmentTrace spin, TimingRule rule) {
        double predicted = spin.isTimed() ? spin.predictedHeading() : Double.NaN;
        TurnTimes times = TurnTimes.of(spin.origin() + spin.f3(), spin.origin() + spin.f4());
        return List.of(
                row("rule", Messages.get("spin.rule." + rule.fileName())),
                row("f3", seconds(spin.isTimed(), times.f3())),
                row("f4", seconds(spin.isTimed(), times.f4())),
                row("tD", seconds(spin.isTimed(), times.tD())),
                row("tP", seconds(spin.isTimed(), times.tP())),
                row("predicted", degrees(predicted, "%.2f°")),
                row("achieved", degrees(spin.achievedHeading(), "%.2f°")),
                row("error", degrees(spin.headingError().orElse(Double.NaN), "%+.2f°")));
    }

    private static NamedValue row(String key, String value) {
        return new NamedValue(Messages.get("spin." + key), value);
    }

    private static String seconds(boolean known, String value) {
        return known ? value + " s" : "–";
    }

    private static String degrees(double radians, String format) {
        return Double.isNaN(radians)
                ? "–"
                : String.format(Locale.ROOT, format, Math.toDegrees(Angles.normalize(radians)))
                        .replace('-', '\u2212');
    }
}
