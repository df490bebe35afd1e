package faultline.gui.text;

import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import java.util.Locale;

/** The diagnosed health of sensors, and the rungs of the ladder, in the user's language. */
public final class HealthText {

    private HealthText() {}

    /** Returns the reason why a sensor is not trusted; empty if there is none. */
    public static String reason(SensorFinding finding) {
        return finding == SensorFinding.NONE ? "" : Messages.get("finding." + finding);
    }

    /** Returns the name of a rung, or the controller's own name for it if it is not part of the ladder. */
    public static String rung(String rung) {
        return textOr("rung." + rung, rung);
    }

    /**
     * Returns the position of a rung in the ladder, or the controller's own name for it if it is not part of the
     * ladder.
     */
    public static String rungPosition(String rung) {
        return textOr("run.rung." + rung, rung);
    }

    private static String textOr(String key, String otherwise) {
        return Messages.contains(key) ? Messages.get(key) : otherwise;
    }

    /** Describes a change of a sensor's health in a sentence. */
    public static String change(SensorTrust from, SensorHealth health) {
        return switch (health.trust()) {
            case DISTRUSTED -> Messages.get("health.distrusted", health.sensor(), reason(health.finding()));
            case SUSPECTED ->
                Messages.get(
                        "health.suspected",
                        health.sensor(),
                        String.format(Locale.ROOT, "%.0f", 100 * health.evidence()));
            case TRUSTED ->
                Messages.get(from == SensorTrust.SUSPECTED ? "health.cleared" : "health.trusted", health.sensor());
        };
    }
}
