package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The runs of a campaign with one combination of levels, or with one of several.
 *
 * @param labels the values that the runs have in common, in the order of {@link #labelColumns}; {@link #ALL} for a sum
 * @param sum whether the cell is a sum over all faults or sensors
 * @param runs the numbers of the runs
 * @param carriedOn the share of those in which the robot carried on
 * @param withoutContact the share of those in which it touched nothing
 * @param coverageOrNaN the mean coverage, NaN if there is none
 * @param distanceRmsOrNaN the mean distance error on straight walls, metres, NaN if there is none
 */
public record CampaignCell(
        List<String> labels,
        boolean sum,
        List<Long> runs,
        Survival carriedOn,
        Survival withoutContact,
        double coverageOrNaN,
        double distanceRmsOrNaN) {

    /** The label of a cell that is a sum over all faults or sensors. */
    public static final String ALL = CellTable.ALL;

    /**
     * Creates a cell from copies of the lists.
     *
     * @param labels the values that the runs have in common, in the order of {@link #labelColumns}; {@link #ALL} for a
     *     sum
     * @param sum whether the cell is a sum over all faults or sensors
     * @param runs the numbers of the runs
     * @param carriedOn the share of those in which the robot carried on
     * @param withoutContact the share of those in which it touched nothing
     * @param coverageOrNaN the mean coverage, NaN if there is none
     * @param distanceRmsOrNaN the mean distance error on straight walls, metres, NaN if there is none
     */
    public CampaignCell {
        labels = List.copyOf(labels);
        runs = List.copyOf(runs);
    }

    /**
     * {@return the columns of {@code runs.csv} that the labels are of}
     *
     * @param plan the plan
     */
    public static List<String> labelColumns(CampaignPlan plan) {
        return new CellTable(new CampaignRuns(plan, List.of())).labelColumns();
    }

    /**
     * {@return the cells of a table, in the order in which their first runs come}
     *
     * @param plan the plan of the campaign
     * @param lines the cells of the header and of the rows of {@code runs.csv}
     */
    public static List<CampaignCell> allOf(CampaignPlan plan, List<List<String>> lines) {
        List<CampaignCell> cells = new ArrayList<>();
        CellTable table = new CellTable(new CampaignRuns(plan, lines));
        table.groups().forEach((key, rows) -> {
            int rung = key.size() - 1;
            if (key.get(rung).equals(ALL)) {
                List<String> labels = key.subList(0, rung);
                cells.add(of(labels, table.isSum(labels), rows));
            }
        });
        return cells;
    }

    /**
     * {@return the number of runs of a table that repeat an earlier one: they have the same world, levels, draws and
     * results, because nothing random changes them. Intervals count a run and its repetitions once}
     *
     * @param plan the plan of the campaign
     * @param lines the cells of the header and of the rows of {@code runs.csv}
     */
    public static long repeatCount(CampaignPlan plan, List<List<String>> lines) {
        return new CampaignRuns(plan, lines).repeatCount();
    }

    private static CampaignCell of(List<String> labels, boolean sum, List<RunRow> rows) {
        return new CampaignCell(
                labels,
                sum,
                rows.stream().map(row -> Long.parseLong(row.text("run"))).toList(),
                Survival.of(rows),
                Survival.of(rows, RunRow::withoutContact),
                mean(rows, "coverage"),
                mean(rows, "distance_rms_m"));
    }

    private static double mean(List<RunRow> rows, String column) {
        return Arrays.stream(CampaignRuns.values(rows, column)).average().orElse(Double.NaN);
    }
}
