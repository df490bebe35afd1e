package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.plan.PlannedRun;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.DiagnosisMetrics;
import faultline.engine.metrics.RunResult;
import faultline.engine.walls.Coverage;
import faultline.io.DecimalText;
import faultline.io.MessageText;
import faultline.scenario.RunSummary;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The columns of {@code runs.csv}: the run, its factors, and its results. */
public final class ResultColumns {

    private static final int FAILURE_LENGTH = 200;

    /** The measured results of a run. */
    private record Measures(RunResult result, CarryOnMetrics carry, DiagnosisMetrics diagnosis) {}

    /** A column with the function that makes its cells. */
    private record ResultColumn(Column column, CellKind kind, Function<Measures, String> cell) {
        ResultColumn(String name, String unit, CellKind kind, String meaning, Function<Measures, String> cell) {
            this(new Column(name, unit, meaning), kind, cell);
        }
    }

    private static final List<ResultColumn> RESULTS = List.of(
            new ResultColumn(
                    "outcome",
                    "",
                    CellKind.TEXT,
                    "carried_on, collided, stopped (at rest without contact), lost, undecided (the run was too short),"
                            + " or broken",
                    run -> Outcome.of(run.result(), run.carry()).word()),
            new ResultColumn(
                    "carried_on",
                    "",
                    CellKind.TEXT,
                    "1 if there was no contact and " + CarriedOnText.SHARE + " of the wall was passed within "
                            + CarriedOnText.DISTANCE + " of the wanted path in the time of " + CarriedOnText.LAPS
                            + " after the fault, each its length divided by the robot's speed plus "
                            + CarriedOnText.CORNERS + " for its corners; 0 if not, empty if undecided or broken",
                    run -> Outcome.of(run.result(), run.carry()).flag()),
            new ResultColumn(
                    "collided",
                    "",
                    CellKind.TEXT,
                    "1 if the robot touched something, 0 if not, empty if the run is broken",
                    run -> run.result().collision().isPresent() ? "1" : "0"),
            new ResultColumn("collision_time_s", "s", CellKind.SIZE, "time of the first contact", run -> run.result()
                    .collision()
                    .map(contact -> fixed(contact.time(), 3))
                    .orElse("")),
            new ResultColumn("collided_with", "", CellKind.TEXT, "what it touched", run -> run.result()
                    .collision()
                    .map(contact -> contact.obstacle())
                    .orElse("")),
            new ResultColumn(
                    "wall_share",
                    "",
                    CellKind.SHARE,
                    "share of the wall that was passed within " + CarriedOnText.DISTANCE
                            + " of the wanted path since the clock started",
                    run -> fixed(run.carry().share().orElse(Double.NaN), 4)),
            new ResultColumn(
                    "laps",
                    "",
                    CellKind.SIZE,
                    "passes of the wall since the clock started, on average over its length",
                    run -> fixed(run.carry().laps().orElse(Double.NaN), 3)),
            new ResultColumn(
                    "clock_start_s",
                    "s",
                    CellKind.SIZE,
                    "start of the clock: the last fault to begin, or the first meeting with a wall if that is later",
                    run -> fixed(run.carry().clockStart().orElse(Double.NaN), 3)),
            new ResultColumn(
                    "coverage",
                    "",
                    CellKind.SHARE,
                    "share of the wall that was followed within " + DecimalText.format(Coverage.TOLERANCE)
                            + " m in the whole run",
                    run -> fixed(run.result().coverage().orElse(Double.NaN), 4)),
            new ResultColumn(
                    "distance_rms_m",
                    "m",
                    CellKind.SIZE,
                    "distance error on straight walls, root mean square",
                    run -> fixed(run.result().distanceRms().orElse(Double.NaN), 6)),
            new ResultColumn(
                    "follow_rms_m",
                    "m",
                    CellKind.SIZE,
                    "distance error in all of FOLLOW, root mean square",
                    run -> fixed(run.result().followRmsOrNaN(), 6)),
            new ResultColumn("final_state", "", CellKind.TEXT, "last state of the controller", run -> run.result()
                    .finalState()
                    .name()),
            new ResultColumn(
                    "final_rung",
                    "",
                    CellKind.TEXT,
                    "last strategy of the controller, empty without a diagnosis",
                    run -> run.diagnosis().rung()),
            new ResultColumn(
                    "detection_delay_s",
                    "s",
                    CellKind.SIZE,
                    "time from the first fault until the diagnosis no longer trusts its sensor; empty if it trusts"
                            + " it until the end or a contact, if it did not before and never does again, or if the"
                            + " fault is one of motors",
                    run -> fixed(run.diagnosis().detectionDelay().orElse(Double.NaN), 3)),
            new ResultColumn(
                    "false_alarms",
                    "",
                    CellKind.COUNT,
                    "sensors that the diagnosis stopped trusting before any fault of theirs and any contact,"
                            + " while they were on; empty without a diagnosis",
                    run -> run.diagnosis().falseAlarms().isPresent()
                            ? Integer.toString(run.diagnosis().falseAlarms().getAsInt())
                            : ""),
            new ResultColumn(
                    "simulated_s",
                    "s",
                    CellKind.TEXT,
                    "how long the run lasted",
                    run -> fixed(run.result().simulatedSeconds(), 9)),
            new ResultColumn(
                    "trajectory_hash",
                    "",
                    CellKind.HASH,
                    "hash over all ticks, the same for every run of the same scenario",
                    run -> RunSummary.formatHash(run.result())),
            new ResultColumn(
                    "detection_view_s",
                    "s",
                    CellKind.SIZE,
                    "time with a surface in the sensor's range, from the tick of the fault to that of its detection,"
                            + " both included, so that it can be one tick longer than detection_delay_s",
                    run -> fixed(run.diagnosis().secondsInView().orElse(Double.NaN), 3)),
            new ResultColumn(
                    "detection_error_m",
                    "m",
                    CellKind.SIZE,
                    "largest error of a reading of the sensor from the tick of the fault to that of its detection,"
                            + " 0 if it gave none",
                    run -> fixed(run.diagnosis().errorBeforeDetection().orElse(Double.NaN), 4)),
            new ResultColumn("failure", "", CellKind.TEXT, "why the run failed, empty if it did not", run -> ""));

    /** The kinds of the columns of results, by their names, in their order. */
    static final Map<String, CellKind> KINDS = RESULTS.stream()
            .collect(Collectors.toMap(
                    result -> result.column.name(), ResultColumn::kind, (first, same) -> first, LinkedHashMap::new));

    private ResultColumns() {}

    /** Returns a rounded number; empty for NaN. */
    private static String fixed(double value, int digits) {
        return Double.isNaN(value)
                ? ""
                : DecimalText.format(Double.parseDouble(String.format(Locale.ROOT, "%." + digits + "f", value)));
    }

    /**
     * {@return all columns of a plan's table}
     *
     * @param plan the plan
     */
    public static List<Column> of(CampaignPlan plan) {
        List<Column> columns = new ArrayList<>(CampaignPlan.RUN_COLUMNS);
        columns.addAll(plan.factorColumns());
        RESULTS.forEach(result -> columns.add(result.column()));
        return columns;
    }

    /** {@return the names of the columns of results, in their order} */
    public static Stream<String> names() {
        return RESULTS.stream().map(result -> result.column.name());
    }

    /** Returns the header row of a plan's table. */
    static String header(CampaignPlan plan) {
        return Csv.row(of(plan).stream().map(Column::name).toList());
    }

    static String row(PlannedRun run, RunResult result, CarryOnMetrics carry, DiagnosisMetrics diagnosis) {
        List<String> cells = leadingCells(run);
        Measures measures = new Measures(result, carry, diagnosis);
        RESULTS.forEach(column -> cells.add(column.cell.apply(measures)));
        return Csv.row(cells);
    }

    /** Returns the row of a failed run. */
    static String brokenRow(PlannedRun run, String failure) {
        List<String> cells = leadingCells(run);
        cells.add(Outcome.BROKEN);
        RESULTS.stream().skip(2).forEach(column -> cells.add(""));
        cells.add(MessageText.start(failure, FAILURE_LENGTH));
        return Csv.row(cells);
    }

    /** Returns the cells of a run that its plan determines, which are the first ones of its row. */
    static List<String> leadingCells(PlannedRun run) {
        List<String> cells = new ArrayList<>();
        cells.add(Long.toString(run.index()));
        cells.add(Long.toString(run.block()));
        cells.add(run.world());
        cells.add(Long.toString(run.seed()));
        cells.addAll(run.cells());
        return cells;
    }
}
