package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.PlannedRun;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.RunResult;
import faultline.io.DecimalText;
import faultline.scenario.RunSummary;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.BiFunction;

/** The columns of {@code runs.csv}: the run, what varies, and what the run came to. */
public final class ResultColumns {

    private static final int FAILURE_LENGTH = 200;

    /** A column with the way in which its cell is made. */
    private record Result(Column column, BiFunction<RunResult, CarryOnMetrics, String> cell) {
        Result(String name, String unit, String meaning, BiFunction<RunResult, CarryOnMetrics, String> cell) {
            this(new Column(name, unit, meaning), cell);
        }
    }

    private static final List<Result> RESULTS = List.of(
            new Result(
                    "outcome",
                    "",
                    "carried_on, collided, stopped (at rest without contact), lost, "
                            + "undecided (the run was too short), or"
                            + " broken",
                    (result, carry) -> Outcome.of(result, carry).word()),
            new Result(
                    "carried_on",
                    "",
                    "1 if there was no contact and 0.80 of the wall was passed within "
                            + "0.15 m of the wanted way in the time"
                            + " of two laps after the fault, 0 if not, empty if undecided",
                    ResultColumns::carriedOn),
            new Result(
                    "collided",
                    "",
                    "1 if the robot touched something, 0 if not",
                    (result, carry) -> result.collision().isPresent() ? "1" : "0"),
            new Result("collision_time_s", "s", "time of the first contact", (result, carry) -> result.collision()
                    .map(contact -> fixed(contact.time(), 3))
                    .orElse("")),
            new Result("collided_with", "", "what it touched", (result, carry) -> result.collision()
                    .map(contact -> contact.obstacle())
                    .orElse("")),
            new Result(
                    "wall_share",
                    "",
                    "share of the wall that was passed within 0.15 m of the wanted way since the clock started",
                    (result, carry) -> fixed(carry.share(), 4)),
            new Result(
                    "laps",
                    "",
                    "how often the wall was passed since the clock started, on average over its length",
                    (result, carry) -> fixed(carry.laps(), 3)),
            new Result(
                    "clock_start_s",
                    "s",
                    "start of the clock: the fault, or the first meeting with a wall if that is later",
                    (result, carry) -> fixed(carry.clockStart(), 3)),
            new Result(
                    "coverage",
                    "",
                    "share of the wall that was followed within 0.05 m in the whole run",
                    (result, carry) -> fixed(result.coverage(), 4)),
            new Result(
                    "distance_rms_m",
                    "m",
                    "distance error on straight walls, root mean square",
                    (result, carry) -> fixed(result.distanceRms(), 6)),
            new Result("final_state", "", "last state of the controller", (result, carry) -> result.finalState()),
            new Result(
                    "simulated_s",
                    "s",
                    "how long the run lasted",
                    (result, carry) -> fixed(result.simulatedSeconds(), 9)),
            new Result(
                    "trajectory_hash",
                    "",
                    "hash over all ticks, the same for every run of the same scenario",
                    (result, carry) -> RunSummary.formatHash(result)),
            new Result("failure", "", "why the run broke, empty if it did not", (result, carry) -> ""));

    private ResultColumns() {}

    private static String carriedOn(RunResult result, CarryOnMetrics carry) {
        Outcome outcome = Outcome.of(result, carry);
        return outcome == Outcome.UNDECIDED ? "" : outcome == Outcome.CARRIED_ON ? "1" : "0";
    }

    private static String fixed(OptionalDouble value, int digits) {
        return value.isPresent() ? fixed(value.getAsDouble(), digits) : "";
    }

    private static String fixed(double value, int digits) {
        return DecimalText.format(Double.parseDouble(String.format(Locale.ROOT, "%." + digits + "f", value)));
    }

    /** Returns all columns of a plan's table. */
    public static List<Column> of(CampaignPlan plan) {
        List<Column> columns = new ArrayList<>(CampaignPlan.RUN_COLUMNS);
        columns.addAll(plan.factorColumns());
        RESULTS.forEach(result -> columns.add(result.column()));
        return columns;
    }

    /** Returns the header row of a plan's table. */
    static String header(CampaignPlan plan) {
        return Csv.row(of(plan).stream().map(Column::name).toList());
    }

    /** Returns the row of a run. */
    static String row(PlannedRun run, RunResult result, CarryOnMetrics carry) {
        List<String> cells = leadingCells(run);
        RESULTS.forEach(column -> cells.add(column.cell.apply(result, carry)));
        return Csv.row(cells);
    }

    /** Returns the row of a run that broke. */
    static String brokenRow(PlannedRun run, String failure) {
        List<String> cells = leadingCells(run);
        cells.add("broken");
        RESULTS.stream().skip(2).forEach(column -> cells.add(""));
        cells.add(failure.substring(0, Math.min(failure.length(), FAILURE_LENGTH)));
        return Csv.row(cells);
    }

    private static List<String> leadingCells(PlannedRun run) {
        List<String> cells = new ArrayList<>();
        cells.add(Long.toString(run.index()));
        cells.add(Long.toString(run.block()));
        cells.add(run.world());
        cells.add(Long.toString(run.seed()));
        cells.addAll(run.cells());
        return cells;
    }
}
