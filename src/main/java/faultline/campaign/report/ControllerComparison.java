package faultline.campaign.report;

import faultline.campaign.run.Csv;
import faultline.engine.SimulationSetup;
import faultline.io.DecimalText;
import faultline.io.ProgramVersion;
import faultline.scenario.Scenario;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Several controllers in the same scenario with the same seeds: a table and one self-contained page. */
public final class ControllerComparison {

    private final Scenario scenario;
    private final String file;
    private final List<ControllerRuns> controllers;
    private final List<String> windowCommands;
    private final boolean truth;

    /**
     * Creates a comparison.
     *
     * @param scenario the scenario of all runs
     * @param file the name of its file
     * @param controllers the controllers, at least one, each with the same seeds
     * @param windowCommands the commands that show pairs of the controllers in the window
     * @param truth whether controllers in child processes were given the ground truth
     */
    public ControllerComparison(
            Scenario scenario,
            String file,
            List<ControllerRuns> controllers,
            List<String> windowCommands,
            boolean truth) {
        this.scenario = scenario;
        this.file = file;
        this.controllers = List.copyOf(controllers);
        this.windowCommands = List.copyOf(windowCommands);
        this.truth = truth;
    }

    /** {@return the commands that show pairs of the controllers in the window} */
    public List<String> windowCommands() {
        return windowCommands;
    }

    /** {@return the first line of every table, with its line feed} */
    public static String csvHeader() {
        return Csv.row(Stream.concat(
                        Stream.of("controller", "seed"),
                        Stream.concat(
                                Arrays.stream(Metric.values()).map(Metric::column),
                                Stream.of("state", "trajectory_hash", "problem")))
                .toList());
    }

    /** {@return the header and one row for each run} */
    public String csv() {
        StringBuilder out = new StringBuilder(csvHeader());
        for (ControllerRuns controller : controllers) {
            controller.runs().forEach(run -> out.append(row(controller, run)));
            for (ControllerRuns.FailedRun broken : controller.broken()) {
                List<String> cells = new ArrayList<>(List.of(controller.controller(), "" + broken.seed()));
                Arrays.stream(Metric.values()).forEach(metric -> cells.add(""));
                cells.addAll(List.of("", "", broken.reason()));
                out.append(Csv.row(cells));
            }
        }
        return out.toString();
    }

    private static String row(ControllerRuns controller, ControllerRuns.ComparedRun run) {
        List<String> cells = new ArrayList<>(List.of(controller.controller(), "" + run.seed()));
        for (Metric metric : Metric.values()) {
            metric.of(run).ifPresentOrElse(value -> cells.add(metric.cell(value)), () -> cells.add(""));
        }
        cells.addAll(List.of(run.finalState(), run.trajectoryHash(), ""));
        return Csv.row(cells);
    }

    /** {@return one line for each controller and for each difference to the first one, under a header, in columns} */
    public List<String> lines() {
        List<List<String>> table = new ArrayList<>();
        table.add(header());
        controllers.forEach(controller -> table.add(cells(controller)));
        for (int i = 1; i < controllers.size(); i++) {
            table.add(differences((i + 1) + " less 1", controllers.get(i)));
        }
        int columns = table.get(0).size();
        int[] widths = new int[columns];
        table.forEach(
                row -> Arrays.setAll(widths, i -> Math.max(widths[i], row.get(i).length())));
        return table.stream()
                .map(row -> {
                    StringBuilder line = new StringBuilder();
                    for (int i = 0; i < columns; i++) {
                        line.append(row.get(i))
                                .append(" ".repeat(widths[i] - row.get(i).length() + 2));
                    }
                    return line.toString().stripTrailing();
                })
                .toList();
    }

    private static List<String> header() {
        return Stream.concat(
                        Stream.of("controller", "runs"),
                        Arrays.stream(Metric.values()).map(Metric::column))
                .toList();
    }

    private static List<String> cells(ControllerRuns controller) {
        String runs = controller.runs().size()
                + (controller.broken().isEmpty()
                        ? ""
                        : " and " + controller.broken().size() + " broken");
        return Stream.concat(
                        Stream.of(controller.controller(), runs),
                        Arrays.stream(Metric.values()).map(metric -> metric.summary(controller.countedRuns())))
                .toList();
    }

    private List<String> differences(String name, ControllerRuns controller) {
        ControllerRuns first = controllers.get(0);
        List<ControllerRuns.RunPair> counted = controller.countedPairs(first);
        return Stream.concat(
                        Stream.of(name, Html.count(controller.pairs(first).size(), "pair")),
                        Arrays.stream(Metric.values()).map(metric -> metric.difference(counted)))
                .toList();
    }

    /**
     * {@return a sentence for each controller whose completed runs have equal results, which count as one run; one
     * sentence if nothing is random in any run}
     */
    public List<String> seedRemarks() {
        List<ControllerRuns> equal =
                controllers.stream().filter(ControllerRuns::areAllEqual).toList();
        if (controllers.stream().allMatch(ControllerRuns::haveOneTrajectory)
                && controllers.stream().allMatch(runs -> runs.broken().isEmpty())) {
            return List.of("nothing in these runs is random, so every seed gives the same run");
        }
        return equal.stream()
                .map(runs -> "the completed runs of " + runs.controller() + " have the same results and count once")
                .toList();
    }

    /** {@return the page} */
    public String html() {
        String title = "Controllers in " + (scenario.name().isEmpty() ? "a scenario" : scenario.name());
        return Html.page(
                title,
                scenario.description(),
                Html.paragraph(conditions()) + paths() + numbers() + refused() + spread() + inTheWindow() + broken());
    }

    /** Returns what a reader needs to repeat the runs. */
    private String conditions() {
        SimulationSetup setup = scenario.setup();
        int seeds = seeds();
        String timeline = TimelineWords.of(setup.timeline());
        return "Scenario file: " + file + ". "
                + (seeds == 1
                        ? "Seed: " + setup.seed()
                        : "Seeds: " + setup.seed() + " to " + (setup.seed() + seeds - 1))
                + ". Duration: " + DecimalText.format(setup.duration()) + " s."
                + (timeline.isEmpty() ? "" : " Timeline: " + timeline + ".")
                + " Version: " + ProgramVersion.text() + ".";
    }

    private int seeds() {
        ControllerRuns any = controllers.get(0);
        return any.runs().size() + any.broken().size();
    }

    /** {@return a sentence for each group of controllers with the same completed runs, whose paths coincide} */
    public List<String> sameRunRemarks() {
        Map<List<String>, List<String>> numbers = new LinkedHashMap<>();
        for (int i = 0; i < controllers.size(); i++) {
            List<String> hashes = controllers.get(i).runs().stream()
                    .map(run -> run.seed() + " " + run.trajectoryHash())
                    .toList();
            numbers.computeIfAbsent(hashes, runs -> new ArrayList<>()).add("" + (i + 1));
        }
        numbers.remove(List.of());
        return numbers.values().stream()
                .filter(same -> same.size() > 1)
                .map(same -> "the completed runs of the controllers " + String.join(" and ", same) + " are the same")
                .toList();
    }

    private String paths() {
        String drawn = seeds() > ComparisonChart.MAX_DRAWN
                ? " Only the runs with the first " + ComparisonChart.MAX_DRAWN + " seeds are drawn."
                : "";
        return Html.section(
                "Paths",
                Html.paragraph("Thick: the first seed. Thin: the others. Robot: the start. Dots: the ends."
                                + " Crosses: the ends of runs with a collision." + drawn + sentences(sameRunRemarks()))
                        + ComparisonChart.paths(scenario.setup(), controllers)
                        + ComparisonChart.legend(controllers));
    }

    private String numbers() {
        List<List<String>> rows = controllers.stream()
                .map(controller -> cells(controller).stream().map(Html::escape).toList())
                .toList();
        return Html.section(
                "Numbers",
                Html.paragraph("Means over the seeds with their 95 % confidence intervals;"
                                + " n: the runs that have the number, if not all do."
                                + (truth ? " Controllers in child processes were given the ground truth." : "")
                                + sentences(seedRemarks()))
                        + Html.table("numbers", header(), rows)
                        + pairedDifferences());
    }

    private static String sentences(List<String> remarks) {
        return remarks.stream()
                .map(remark -> " " + Character.toUpperCase(remark.charAt(0)) + remark.substring(1) + ".")
                .collect(Collectors.joining());
    }

    private String pairedDifferences() {
        String first = controllers.get(0).controller();
        List<List<String>> rows = controllers.stream()
                .skip(1)
                .map(controller -> differences(controller.controller(), controller).stream()
                        .map(Html::escape)
                        .toList())
                .toList();
        return rows.isEmpty()
                ? ""
                : Html.paragraph("Differences to " + first
                                + " in runs with the same seed: means with their 95 % confidence intervals.")
                        + Html.table("numbers", header(), rows);
    }

    private String refused() {
        List<List<String>> rows = controllers.stream()
                .flatMap(controller -> controller.refusals().stream()
                        .map(refusal -> List.of(Html.escape(controller.controller()), Html.escape(refusal))))
                .toList();
        return rows.isEmpty()
                ? ""
                : Html.section(
                        "Refused commands",
                        Html.paragraph("Commands of the timeline that had no effect on the robot of a controller.")
                                + Html.table("dictionary", List.of("controller", "command"), rows));
    }

    private String spread() {
        StringBuilder charts = new StringBuilder("<div class=\"charts\">\n");
        for (Metric metric : Metric.values()) {
            charts.append(ComparisonChart.spread(metric, controllers));
        }
        return Html.section(
                "Spread",
                Html.paragraph("Marks: the runs. Bars: the 95 % confidence intervals of the means.") + charts
                        + "</div>\n" + ComparisonChart.legend(controllers));
    }

    private String inTheWindow() {
        List<List<String>> rows = windowCommands.stream()
                .map(command -> List.of("<code>" + Html.escape(command) + "</code>"))
                .toList();
        return rows.isEmpty()
                ? ""
                : Html.section(
                        "In the window",
                        Html.paragraph("The first controller drives, and another one drives a ghost beside it.")
                                + Html.table("dictionary", List.of("command"), rows));
    }

    private String broken() {
        List<List<String>> rows = controllers.stream()
                .flatMap(controller -> controller.broken().stream()
                        .map(broken -> List.of(
                                Html.escape(controller.controller()),
                                "" + broken.seed(),
                                Html.escape(broken.reason()))))
                .toList();
        return rows.isEmpty()
                ? ""
                : Html.section("Broken runs", Html.table("dictionary", List.of("controller", "seed", "problem"), rows));
    }
}
