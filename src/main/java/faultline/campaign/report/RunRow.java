package faultline.campaign.report;

import faultline.campaign.run.RowCheck;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * One row of {@code runs.csv}.
 *
 * @param campaign all runs of the table
 * @param firstEqual the index of the first line of the same run: its world, levels and draws are the same, and so are
 *     its results, which therefore do not depend on the seed
 * @param cells the cells
 */
record RunRow(CampaignRuns campaign, int firstEqual, List<String> cells) {

    /** Returns a cell, empty if there is no such column. */
    String text(String column) {
        return campaign.text(cells, column);
    }

    /** Returns a cell as a number, empty if it holds none. */
    OptionalDouble number(String column) {
        return RowCheck.number(text(column));
    }

    /** Returns 1 if the robot carried on, 0 if not; empty for a run without a verdict. */
    OptionalInt carriedOn() {
        String text = text("carried_on");
        return text.isEmpty() ? OptionalInt.empty() : OptionalInt.of(text.equals("1") ? 1 : 0);
    }

    /** Returns 1 if the robot touched nothing and 0 otherwise; empty if the run failed. */
    OptionalInt withoutContact() {
        String text = text("collided");
        return text.isEmpty() ? OptionalInt.empty() : OptionalInt.of(text.equals("1") ? 0 : 1);
    }

    /** Returns the key by which runs are independent: the world, or the block if there is only one world. */
    String cluster() {
        return text(campaign.worldCount() > 1 ? "world" : "block");
    }
}
