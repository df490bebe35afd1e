package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.ResultColumns;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The runs of a campaign as a program shows them that has not made them itself.
 *
 * @param plan the plan of the campaign
 * @param lines the names of {@link ResultColumns#of} and below them the cells of each run, in the order of the plan. A
 *     cell is empty if the file has no such column
 * @param ofThisProgram whether this program, with the controllers that it finds now, would make the same runs
 */
public record CampaignTable(CampaignPlan plan, List<List<String>> lines, boolean ofThisProgram) {

    /**
     * Creates a table from a copy of the list.
     *
     * @param plan the plan of the campaign
     * @param lines the names of the columns and below them the cells of each run
     * @param ofThisProgram whether this program, with the controllers that it finds now, would make the same runs
     */
    public CampaignTable {
        lines = List.copyOf(lines);
    }

    /**
     * Reads and checks the table of a campaign, as a report does.
     *
     * @param folder the folder of the campaign; of an unfinished campaign, the finished runs are read
     * @return the table, with at least one run
     * @throws IOException if there are no runs, or a row cannot be used
     * @throws ScenarioException if the copy of the plan is not valid
     */
    public static CampaignTable read(Path folder) throws IOException, ScenarioException {
        CampaignRuns campaign = CampaignRuns.read(folder);
        List<String> columns =
                ResultColumns.of(campaign.plan()).stream().map(Column::name).toList();
        List<List<String>> lines = new ArrayList<>();
        lines.add(columns);
        campaign.rows().stream()
                .map(row -> columns.stream().map(row::text).toList())
                .forEach(lines::add);
        return new CampaignTable(campaign.plan(), lines, new CampaignFolder(folder).isOfThisProgram(campaign.plan()));
    }
}
