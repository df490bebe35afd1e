package faultline.scenario;

import faultline.control.ControllerState;
import faultline.engine.metrics.RunResult;
import faultline.io.JsonWriter;
import faultline.world.Collision;
import java.util.List;

/** A run's result as one JSON object on one line, with the keys of {@link RunSummary}. */
public final class RunJson {

    private RunJson() {}

    /**
     * {@return a result as JSON, with {@code null} for a missing value}
     *
     * @param result the result
     * @param truth whether the controller was given the ground truth
     * @param unmet the expectations that failed, one sentence each
     */
    public static String format(RunResult result, boolean truth, List<String> unmet) {
        JsonWriter json =
                new JsonWriter().member("ticks", result.ticks()).member("simulated_s", result.simulatedSeconds());
        writeNumber(json.name("real_time_factor"), result.realTimeFactor());
        json.member("state", result.finalState().name());
        writeTexts(
                json.name("states"),
                result.visitedStates().stream().map(ControllerState::name).toList());
        writeCollision(json, result);
        writeNumber(json.name("coverage"), result.coverageOrNaN());
        writeNumber(json.name("distance_rms_m"), result.distanceRmsOrNaN());
        writeNumber(json.name("follow_rms_m"), result.followRmsOrNaN());
        json.member("trajectory_hash", RunSummary.formatHash(result)).member("seed", result.seed());
        json.name("rung");
        if (result.rung().isEmpty()) {
            json.nullValue();
        } else {
            json.value(result.rung());
        }
        writeTexts(json.name("rung_changes"), RunSummary.rungChanges(result));
        writeTexts(json.name("health_changes"), RunSummary.healthChanges(result));
        json.member("truth", truth).member("expectations", unmet.isEmpty() ? "held" : "failed");
        writeTexts(json.name("unmet"), unmet);
        return json.finish();
    }

    private static void writeCollision(JsonWriter json, RunResult result) {
        json.name("collision");
        if (result.collision().isEmpty()) {
            json.nullValue().name("collided_with").nullValue();
            return;
        }
        Collision collision = result.collision().get();
        json.beginObject()
                .member("x_m", collision.point().x())
                .member("y_m", collision.point().y())
                .member("t_s", collision.time())
                .endObject()
                .member("collided_with", collision.obstacle());
    }

    private static void writeTexts(JsonWriter json, List<String> texts) {
        json.beginArray();
        texts.forEach(json::value);
        json.endArray();
    }

    /** Writes a number, or null if it is not finite. */
    private static void writeNumber(JsonWriter json, double value) {
        if (Double.isFinite(value)) {
            json.value(value);
        } else {
            json.nullValue();
        }
    }
}
