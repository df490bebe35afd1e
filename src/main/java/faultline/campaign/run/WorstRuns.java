package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The worst runs of a table: by their outcome, then by the share of the wall that was passed, then by their numbers.
 * Each gets a scenario file that replays it.
 */
public final class WorstRuns {

    /** The number of runs that get a scenario file. */
    private static final int COUNT = 20;

    private static final Comparator<Candidate> WORST_FIRST = Comparator.comparing(Candidate::outcome)
            .thenComparing(Candidate::share)
            .thenComparing(Candidate::run);

    private final CampaignPlan plan;
    private final CampaignFolder folder;

    /** The values of a row that are compared; the duration in seconds. */
    private record Candidate(long run, Outcome outcome, double share, double simulatedSeconds) {}

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

    /** Writes the scenario files, and removes those of an earlier table. */
    void writeReplays() throws IOException {
        List<Candidate> worst = find();
        Files.createDirectories(folder.replays());
        Set<String> names = new HashSet<>();
        for (Candidate candidate : worst) {
            Path file = folder.runs().resolveSibling(replayName(candidate.run));
            names.add(file.getFileName().toString());
            replay(candidate).save(file);
        }
        try (Stream<Path> files = Files.list(folder.replays())) {
            for (Path file : files.filter(file -> file.getFileName().toString().startsWith("run-"))
                    .filter(file -> !names.contains(file.getFileName().toString()))
                    .toList()) {
                Files.delete(file);
            }
        }
    }

    private Scenario replay(Candidate candidate) throws IOException {
        try {
            return RunScenario.create(plan, candidate.run, candidate.outcome.word(), candidate.simulatedSeconds);
        } catch (ScenarioException e) {
            throw new IOException("run " + candidate.run + " cannot be replayed: " + e.getMessage(), e);
        }
    }

    private List<Candidate> find() throws IOException {
        PriorityQueue<Candidate> worst = new PriorityQueue<>(WORST_FIRST.reversed());
        try (BufferedReader in = Files.newBufferedReader(folder.runs())) {
            List<String> header = Csv.cells(in.readLine());
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                List<String> cells = Csv.cells(line);
                requireGood(header, cells);
                Outcome.ofWord(cells.get(header.indexOf("outcome")))
                        .ifPresent(outcome -> worst.add(candidate(cells, header, outcome)));
                if (worst.size() > COUNT) {
                    worst.poll();
                }
            }
        }
        List<Candidate> ordered = new ArrayList<>(worst);
        ordered.sort(WORST_FIRST);
        return ordered;
    }

    private void requireGood(List<String> header, List<String> cells) throws IOException {
        Optional<String> problem = RowCheck.findProblem(header, cells);
        if (problem.isPresent()) {
            throw new IOException(folder.runs() + ": " + problem.get());
        }
    }

    private static Candidate candidate(List<String> cells, List<String> header, Outcome outcome) {
        String share = cells.get(header.indexOf("wall_share"));
        return new Candidate(
                Long.parseLong(cells.get(0)),
                outcome,
                share.isEmpty() ? 0 : Double.parseDouble(share),
                Double.parseDouble(cells.get(header.indexOf("simulated_s"))));
    }
}
