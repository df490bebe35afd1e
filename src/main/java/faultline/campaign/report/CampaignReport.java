package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.Column;
import faultline.campaign.run.CarriedOnText;
import faultline.campaign.run.Outcome;
import faultline.campaign.run.ResultColumns;
import faultline.campaign.run.WorstRuns;
import faultline.io.ProgramCommand;
import faultline.io.ShellText;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Makes the report of a campaign: one self-contained HTML page. */
public final class CampaignReport {

    /**
     * Below this number of worlds, or of seeds in one world, their correlation is so uncertain that the page says it.
     */
    private static final int FEW_CLUSTERS = 10;

    private final CampaignRuns campaign;
    private final Path folder;

    /**
     * Reads a campaign.
     *
     * @param folder the folder of the campaign; of an unfinished campaign, the finished runs are reported
     * @throws IOException if there are no runs
     * @throws ScenarioException if the copy of the plan is not valid
     */
    public CampaignReport(Path folder) throws IOException, ScenarioException {
        this.folder = folder;
        this.campaign = CampaignRuns.read(folder);
    }

    /** {@return the number of runs in the report} */
    public int runCount() {
        return campaign.rows().size();
    }

    /** {@return the numbers of every cell as CSV} */
    public String cellsCsv() {
        return new CellTable(campaign).csv();
    }

    /**
     * {@return the page}
     *
     * @param jars the jars that the plan's controllers in Java come from, for the commands that open runs
     */
    public String html(List<Path> jars) {
        CampaignPlan plan = campaign.plan();
        String title =
                plan.header().name().isEmpty() ? "Campaign" : plan.header().name();
        FaultSections faults = new FaultSections(campaign);
        VariantSections variants = new VariantSections(campaign);
        return Html.page(
                title,
                plan.header().description(),
                summary()
                        + faults.matrix()
                        + variants.comparisons()
                        + faults.sensorSets()
                        + faults.delays()
                        + variants.responses()
                        + variants.distributions()
                        + worstRuns(jars)
                        + dictionary());
    }

    private String summary() {
        CampaignPlan plan = campaign.plan();
        Survival all = Survival.of(campaign.rows());
        List<List<String>> rows = new ArrayList<>();
        for (Outcome outcome : Outcome.values()) {
            addOutcome(outcome.word(), rows);
        }
        addOutcome(Outcome.BROKEN, rows);
        String size = campaign.rows().size() + " of " + Html.count(plan.runCount(), "run") + ": "
                + Html.count(plan.worldCount(), "world") + ", " + Html.count(plan.seedCount(), "seed") + " each, "
                + Html.count(plan.cellCount(), "combination") + " in each. ";
        String meaning = "A robot carries on if it touches nothing and, in the time of " + CarriedOnText.LAPS
                + " after the fault, passes at least " + CarriedOnText.SHARE
                + " of the wall that it follows within " + CarriedOnText.DISTANCE + " of the wanted path. ";
        return Html.section(
                "Summary",
                Html.paragraph(size + meaning + independence())
                        + ownFaults()
                        + overruledAttributes()
                        + repeats()
                        + undecided()
                        + broken()
                        + "<p>All runs: " + Html.survival(all)
                        + "</p>\n" + Html.table("numbers", List.of("outcome", "runs", "share"), rows));
    }

    private String ownFaults() {
        List<String> scenarios = campaign.plan().scenariosWithFaults();
        return scenarios.isEmpty()
                ? ""
                : Html.paragraph(
                        "The faults in the timeline of a scenario act in all of its runs, also in those that are"
                                + " called healthy here. Scenarios with such faults: " + Allowed.names(scenarios)
                                + ".");
    }

    private String overruledAttributes() {
        Map<String, List<String>> overruled = campaign.plan().overruledAttributes();
        return overruled.isEmpty()
                ? ""
                : Html.paragraph(
                        "A change of a built-in controller in the timeline of a scenario replaces what the plan sets,"
                                + " so runs that differ only in this continue with the same value. Attributes of the"
                                + " controller that are replaced: "
                                + overruled.entrySet().stream()
                                        .map(entry -> String.join(", ", entry.getValue()) + " in "
                                                + Allowed.names(List.of(entry.getKey())))
                                        .collect(Collectors.joining("; "))
                                + ".");
    }

    /** Returns how intervals regard runs that are not independent. */
    private String independence() {
        boolean worlds = campaign.worldCount() > 1;
        long count = campaign.rows().stream().map(RunRow::cluster).distinct().count();
        String effect = worlds
                ? "Runs in one world are correlated, so intervals use the effective number of independent runs."
                : "All runs are in one world: intervals cover other seeds and draws in it, but not other worlds.";
        return count >= FEW_CLUSTERS || count == 1 && !worlds
                ? effect
                : effect + " With only " + Html.count(count, worlds ? "world" : "seed")
                        + ", the correlation of runs is uncertain, which makes intervals wider.";
    }

    private String repeats() {
        long count = campaign.repeatCount();
        return count == 0
                ? ""
                : Html.paragraph(
                        "Repeated runs (" + count + ") differ from an earlier one only in their seed, because nothing"
                                + " random changes their results. Intervals count a run and its repetitions once.");
    }

    private String undecided() {
        long count = count(Outcome.UNDECIDED.word());
        return count == 0
                ? ""
                : Html.paragraph(
                        "Undecided runs (" + count + ") ended before their verdict was known, and no share counts"
                                + " them. Shares count short runs with a contact, so they are lower than those of"
                                + " longer runs. A greater @duration in the plan decides more runs.");
    }

    private String broken() {
        long count = count(Outcome.BROKEN);
        return count == 0
                ? ""
                : Html.paragraph(
                        "Broken runs (" + count + ") have no verdict, and no share counts them. If a controller"
                                + " breaks off some of its runs, its shares are those of the others only.");
    }

    private long count(String outcome) {
        return campaign.rows().stream()
                .filter(row -> row.text("outcome").equals(outcome))
                .count();
    }

    private void addOutcome(String word, List<List<String>> rows) {
        long count = count(word);
        if (count > 0) {
            rows.add(List.of(
                    word.replace('_', ' '),
                    String.valueOf(count),
                    Html.percent((double) count / campaign.rows().size())));
        }
    }

    /** Returns the runs that have a separate scenario file; none in an unfinished campaign. */
    private String worstRuns(List<Path> jars) {
        WorstRuns.WorstList<RunRow> list = new WorstRuns.WorstList<>();
        campaign.rows().forEach(row -> list.add(row::text, row));
        List<RunRow> worst = list.runs().stream()
                .filter(row -> Files.exists(folder.resolve(WorstRuns.replayName(Long.parseLong(row.text("run"))))))
                .toList();
        if (worst.isEmpty()) {
            return "";
        }
        String options = jars.stream()
                .map(jar -> " --jar " + ShellText.quoted(jar.toString()))
                .collect(Collectors.joining());
        List<List<String>> rows =
                worst.stream().map(row -> worstRow(row, options)).toList();
        return Html.section(
                "Worst runs",
                Html.paragraph("Each command opens the run in the window, from its start.")
                        + Html.table("worst", List.of("run", "world", "what varies", "outcome", "command"), rows));
    }

    private List<String> worstRow(RunRow row, String options) {
        StringBuilder varied = new StringBuilder();
        for (Column column : campaign.plan().factorColumns()) {
            String text = row.text(column.name());
            if (!text.isEmpty()) {
                varied.append(varied.isEmpty() ? "" : ", ")
                        .append(column.name())
                        .append(' ')
                        .append(text);
            }
        }
        Path replay = folder.resolve(WorstRuns.replayName(Long.parseLong(row.text("run"))));
        String command = ProgramCommand.text() + " " + ShellText.quoted(replay.toString()) + options;
        String collision = row.text("collided_with");
        return List.of(
                row.text("run"),
                Html.escape(row.text("world") + ", seed " + row.text("seed")),
                Html.escape(varied.toString()),
                row.text("outcome").replace('_', ' ')
                        + (collision.isEmpty()
                                ? ""
                                : Html.escape(" with " + collision + " at " + row.text("collision_time_s") + " s")),
                "<code>" + Html.escape(command) + "</code>");
    }

    private String dictionary() {
        List<List<String>> rows = ResultColumns.of(campaign.plan()).stream()
                .map(column -> List.of(
                        "<code>" + Html.escape(column.name()) + "</code>",
                        Html.escape(column.unit()),
                        Html.escape(column.meaning())))
                .toList();
        return Html.section(
                "Columns of runs.csv", Html.table("dictionary", List.of("column", "unit", "meaning"), rows));
    }
}
