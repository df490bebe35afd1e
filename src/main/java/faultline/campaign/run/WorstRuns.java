package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.io.Message;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The worst runs of a table: by their outcome, then by the share of the wall that was passed, then by their numbers.
 * Each gets a scenario file that replays it.
 */
public final class WorstRuns {

    /** The number of runs that get a scenario file. */
    public static final int COUNT = 20;

    private static final Pattern REPLAY = Pattern.compile("run-\\d{7,}\\.xml");

    private final CampaignPlan plan;
    private final CampaignFolder folder;

    /**
     * The place of a run among others, the worst one first.
     *
     * @param outcome the outcome of the run
     * @param share the share of the wall that was passed, in [0, 1]; 0 if it is not known
     * @param run the number of the run
     */
    private record Rank(Outcome outcome, double share, long run) implements Comparable<Rank> {

        private static final Comparator<Rank> WORST_FIRST =
                Comparator.comparing(Rank::outcome).thenComparing(Rank::share).thenComparing(Rank::run);

        /** Returns the rank of a row that can be used, given its cells by column; empty if the run is broken. */
        private static Optional<Rank> of(UnaryOperator<String> cell) {
            return Outcome.ofWord(cell.apply("outcome"))
                    .map(outcome -> new Rank(
                            outcome,
                            RowCheck.number(cell.apply("wall_share")).orElse(0),
                            Long.parseLong(cell.apply("run"))));
        }

        @Override
        public int compareTo(Rank other) {
            return WORST_FIRST.compare(this, other);
        }
    }

    /**
     * Keeps the worst of the runs that are added to it.
     *
     * @param <T> the type of what is kept of a run
     */
    public static final class WorstList<T> {

        private final NavigableMap<Rank, T> runs = new TreeMap<>();

        /**
         * Adds a run, unless it is broken or {@value WorstRuns#COUNT} others are worse.
         *
         * @param cell the function that returns the text of a column of its row
         * @param run what is kept of it
         */
        public void add(UnaryOperator<String> cell, T run) {
            Rank.of(cell).ifPresent(rank -> runs.put(rank, run));
            if (runs.size() > COUNT) {
                runs.pollLastEntry();
            }
        }

        /** {@return what is kept of the worst runs, the worst one first} */
        public List<T> runs() {
            return List.copyOf(runs.values());
        }
    }

    WorstRuns(CampaignPlan plan, CampaignFolder folder) {
        this.plan = plan;
        this.folder = folder;
    }

    /**
     * {@return the name of the file that replays a run, in the folder of the campaign}
     *
     * @param run the index of the run
     */
    public static String replayName(long run) {
        return String.format(Locale.ROOT, "replays/run-%07d.xml", run);
    }

    /** Returns whether a file in the folder of replays has the name of one. */
    static boolean isReplay(Path file) {
        return REPLAY.matcher(file.getFileName().toString()).matches();
    }

    /** Writes the scenario files, and removes those of an earlier table. */
    void writeReplays() throws IOException {
        WorstList<Double> worst = find();
        Files.createDirectories(folder.replays());
        Set<String> names = new HashSet<>();
        for (Map.Entry<Rank, Double> run : worst.runs.entrySet()) {
            Path file = folder.runs().resolveSibling(replayName(run.getKey().run));
            names.add(file.getFileName().toString());
            replay(run.getKey(), run.getValue()).save(file);
        }
        try (Stream<Path> files = Files.list(folder.replays())) {
            for (Path file : files.filter(WorstRuns::isReplay)
                    .filter(file -> !names.contains(file.getFileName().toString()))
                    .toList()) {
                Files.delete(file);
            }
        }
    }

    private Scenario replay(Rank rank, double simulatedSeconds) throws IOException {
        try {
            return ReplayScenario.of(plan, rank.run, rank.outcome, simulatedSeconds);
        } catch (ScenarioException e) {
            throw new IOException("run " + rank.run + " cannot be replayed: " + e.getMessage(), e);
        }
    }

    /** Returns the durations of the worst runs, seconds. */
    private WorstList<Double> find() throws IOException {
        WorstList<Double> worst = new WorstList<>();
        try (LineReader in = new LineReader(folder.runs())) {
            List<String> header = Csv.cells(in.next().strip());
            long number = 1;
            for (String line = in.next(); !line.isEmpty(); line = in.next()) {
                List<String> cells = Csv.cells(line.stripTrailing());
                number++;
                requireGood(header, cells, number);
                double seconds = RowCheck.number(cells.get(header.indexOf("simulated_s")))
                        .orElse(0);
                worst.add(column -> cells.get(header.indexOf(column)), seconds);
            }
        }
        return worst;
    }

    private void requireGood(List<String> header, List<String> cells, long line) throws IOException {
        Optional<Message> problem = RowCheck.findProblem(header, cells);
        if (problem.isPresent()) {
            throw new IOException(folder.runs() + ":" + line + ": " + problem.get());
        }
    }
}
