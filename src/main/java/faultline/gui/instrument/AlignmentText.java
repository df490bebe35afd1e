package faultline.gui.instrument;

import faultline.gui.text.AngleText;
import faultline.gui.text.Messages;
import faultline.gui.text.TurnTimes;
import java.util.List;

/** Formats the values of an alignment manoeuvre; a dash for a value that is not yet known. */
final class AlignmentText {

    private AlignmentText() {}

    /** A label, and a value with its unit. */
    record NamedValue(String name, String value) {}

    static List<NamedValue> rows(AlignmentTrace spin) {
        double predicted = spin.isTimed() ? spin.predictedHeading() : Double.NaN;
        TurnTimes times = TurnTimes.of(spin.origin() + spin.f3(), spin.origin() + spin.f4());
        return List.of(
                row("rule", Messages.get("spin.rule." + spin.rule().fileName())),
                row("f3", seconds(spin.isTimed(), times.f3())),
                row("f4", seconds(spin.isTimed(), times.f4())),
                row("tD", seconds(spin.isTimed(), times.tD())),
                row("tP", seconds(spin.isTimed(), times.tP())),
                row("predicted", heading(predicted)),
                row("achieved", heading(spin.achievedHeading())),
                row(
                        "error",
                        spin.headingError().isPresent()
                                ? unit(AngleText.signedDegrees(
                                        spin.headingError().getAsDouble(), 2))
                                : "–"));
    }

    private static NamedValue row(String key, String value) {
        return new NamedValue(Messages.get("spin." + key), value);
    }

    private static String seconds(boolean known, String value) {
        return known ? value + " s" : "–";
    }

    private static String heading(double radians) {
        return Double.isNaN(radians) ? "–" : unit(AngleText.degrees(radians, 2));
    }

    private static String unit(String degrees) {
        return degrees.replace('-', '\u2212') + "°";
    }
}
