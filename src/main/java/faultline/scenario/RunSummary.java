package faultline.scenario;

import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.RunEvent;
import faultline.io.DecimalText;
import faultline.io.ShortestDecimal;
import faultline.world.Collision;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;

/** A run's result as lines of the form {@code key: value}, the same in every language. */
public final class RunSummary {

    private RunSummary() {}

    /**
     * {@return one line for each value, with the keys in a fixed order; a missing value is {@code none}}
     *
     * @param result the result of the run
     */
    public static List<String> lines(RunResult result) {
        return List.of(
                "ticks: " + result.ticks(),
                "simulated_s: " + DecimalText.format(result.simulatedSeconds()),
                "real_time_factor: " + formatNumber(result.realTimeFactor(), 1),
                "state: " + result.finalState(),
                "states: " + result.visitedNames(),
                "collision: "
                        + result.collision().map(RunSummary::formatCollision).orElse("none"),
                "collided_with: "
                        + result.collision().map(RunSummary::formatObstacle).orElse("none"),
                "coverage: " + formatNumber(result.coverageOrNaN(), 4),
                "distance_rms_m: " + formatNumber(result.distanceRmsOrNaN(), 6),
                "follow_rms_m: " + formatNumber(result.followRmsOrNaN(), 6),
                "trajectory_hash: " + formatHash(result),
                "seed: " + result.seed(),
                "rung: " + (result.rung().isEmpty() ? "none" : result.rung()),
                "rung_changes: " + join(rungChanges(result)),
                "health_changes: " + join(healthChanges(result)));
    }

    /** Returns the changes of the strategy that drives, in order. */
    static List<String> rungChanges(RunResult result) {
        return changes(result, RunSummary::formatRung);
    }

    /** Returns the changes of the sensors' health, in order. */
    static List<String> healthChanges(RunResult result) {
        return changes(result, RunSummary::formatHealth);
    }

    /**
     * {@return a result's trajectory hash as 16 hexadecimal digits}
     *
     * @param result the result of the run
     */
    public static String formatHash(RunResult result) {
        return HexFormat.of().toHexDigits(result.trajectoryHash());
    }

    /** An obstacle may have the id that means "no obstacle". */
    private static String formatObstacle(Collision collision) {
        return collision.obstacle().equals("none") ? "\"none\"" : collision.obstacle();
    }

    private static String formatCollision(Collision collision) {
        return String.format(
                Locale.ROOT,
                "%.9f,%.9f at %.9f",
                collision.point().x(),
                collision.point().y(),
                collision.time());
    }

    private static List<String> changes(RunResult result, Function<RunEvent, Optional<String>> format) {
        return result.diagnosisEvents().stream()
                .map(format)
                .flatMap(Optional::stream)
                .toList();
    }

    private static String join(List<String> changes) {
        return changes.isEmpty() ? "none" : String.join(", ", changes);
    }

    private static Optional<String> formatRung(RunEvent event) {
        return event instanceof RunEvent.RungChanged change
                ? Optional.of(change.to() + " at " + DecimalText.format(change.time()))
                : Optional.empty();
    }

    /** Formats an event if a sensor is no longer trusted or is trusted again; suspicions are omitted. */
    private static Optional<String> formatHealth(RunEvent event) {
        if (!(event instanceof RunEvent.HealthChanged change)) {
            return Optional.empty();
        }
        SensorHealth health = change.health();
        boolean wasTrusted = change.from() != SensorTrust.DISTRUSTED;
        if (health.isTrusted() == wasTrusted) {
            return Optional.empty();
        }
        String verdict = health.isTrusted() ? "trusted" : health.finding().name();
        return Optional.of(health.sensor() + " " + verdict + " at " + DecimalText.format(change.time()));
    }

    /**
     * Formats a number like {@code java.util.Formatter}, whose loading takes a twentieth of the time of a short run.
     */
    static String formatNumber(double value, int digits) {
        return Double.isFinite(value)
                ? new BigDecimal(ShortestDecimal.text(value))
                        .setScale(digits, RoundingMode.HALF_UP)
                        .toPlainString()
                : "none";
    }
}
