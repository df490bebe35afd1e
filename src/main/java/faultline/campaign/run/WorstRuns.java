package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.io.Message;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
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
    public record Rank(Outcome outcome, double share, long run) implements Comparable<Rank> {

        private static final Comparator<Rank> WORST_FIRST =
                Comparator.comparing(Rank::outcome).thenComparing(Rank::share).thenComparing(Rank::run);

        @Override
        public int compareTo(Rank other) {
            return WORST_FIRST.compare(this, other);
        }
    }

    /** A run and its duration, seconds. */
    private record Candidate(Rank rank, double simulatedSeconds) {

        private static final Comparator<Candidate> WORST_FIRST = Comparator.comparing(Candidate::rank);
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
        Collection<Candidate> worst = find();
        Files.createDirectories(folder.replays());
        Set<String> names = new HashSet<>();
        for (Candidate candidate : worst) {
            Path file = folder.runs().resolveSibling(replayName(candidate.rank.run));
            names.add(file.getFileName().toString());
            replay(candidate).save(file);
        }
        try (Stream<Path> files = Files.list(folder.replays())) {
            for (Path file : files.filter(WorstRuns::isReplay)
                    .filter(file -> !names.contains(file.getFileName().toString()))
                    .toList()) {
                Files.delete(file);
            }
        }
    }

    private Scenario replay(Candidate candidate) throws IOException {
        try {
            return ReplayScenario.of(plan, candidate.rank.run, candidate.rank.outcome, candidate.simulatedSeconds);
        } catch (ScenarioException e) {
            throw new IOException("run " + candidate.rank.run + " cannot be replayed: " + e.getMessage(), e);
        }
    }

    private Collection<Candidate> find() throws IOException {
        PriorityQueue<Candidate> worst = new PriorityQueue<>(Candidate.WORST_FIRST.reversed());
        try (LineReader in = new LineReader(folder.runs())) {
            List<String> header = Csv.cells(in.next().strip());
            long number = 1;
            for (String line = in.next(); !line.isEmpty(); line = in.next()) {
                List<String> cells = Csv.cells(line.stripTrailing());
                number++;
                requireGood(header, cells, number);
                Outcome.ofWord(cells.get(header.indexOf("outcome")))
                        .ifPresent(outcome -> worst.add(candidate(cells, header, outcome)));
                if (worst.size() > COUNT) {
                    worst.poll();
                }
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

    private static Candidate candidate(List<String> cells, List<String> header, Outcome outcome) {
        String share = cells.get(header.indexOf("wall_share"));
        Rank rank = new Rank(outcome, share.isEmpty() ? 0 : Double.parseDouble(share), Long.parseLong(cells.get(0)));
        return new Candidate(rank, Double.parseDouble(cells.get(header.indexOf("simulated_s"))));
    }
}
