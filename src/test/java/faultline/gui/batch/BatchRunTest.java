package faultline.gui.batch;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.PlanHeader;
import faultline.campaign.report.CampaignCell;
import faultline.campaign.report.Interval;
import faultline.campaign.report.Survival;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Outcome;
import faultline.campaign.run.ReplayScenario;
import faultline.campaign.run.Shard;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.gui.Await;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.SensorSpec;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The runs of a batch are those of the command {@code campaign} with the same plan. */
class BatchRunTest {

    private static final List<BatchPlan.FaultValues> FAULTS = List.of(
            new BatchPlan.FaultValues("stuck", "0.2..0.7"),
            new BatchPlan.FaultValues("off", ""),
            new BatchPlan.FaultValues("noise", "0.01 0.05"));

    @TempDir
    private Path folder;

    /** The yard with the robot elsewhere than in its file. */
    private static Scenario editedYard() throws ScenarioException {
        Scenario yard = Scenario.load(Path.of("scenarios/yard.xml"));
        Pose start = yard.setup().start();
        return yard.withSetup(yard.setup()
                .withStart(new Pose(start.x() + 0.07, start.y() - 0.03, start.heading() + 0.4))
                .withDuration(8));
    }

    private static BatchPlan plan(DiagnosisChoice diagnosis, double duration) throws ScenarioException {
        return plan(diagnosis, duration, 2);
    }

    private static BatchPlan plan(DiagnosisChoice diagnosis, double duration, int seeds) throws ScenarioException {
        return new BatchPlan(
                editedYard(), 31, seeds, duration, false, diagnosis, true, FAULTS, "1..3", List.of("front", "left"));
    }

    private static byte[] runsOf(CampaignPlan plan, Path out) throws Exception {
        CampaignRunner runner = new CampaignRunner(plan, new CampaignFolder(out), Shard.ALL, 1);
        assertTrue(runner.run(false, (made, runs) -> {}, () -> false).isComplete());
        return Files.readAllBytes(out.resolve("runs.csv"));
    }

    @Test
    void theSavedPlanGivesTheTableOfTheWindow() throws Exception {
        BatchPlan plan = plan(DiagnosisChoice.BOTH, 5);
        assertEquals(36, plan.runCount().orElseThrow());
        BatchRun run = new BatchRun(plan, 2);
        assertEquals(new CampaignRunner.RunCounts(36, 36, 0), run.make());
        run.saveResults(folder.resolve("results"));
        plan.save(folder.resolve("study.xml"));
        byte[] expected = Files.readAllBytes(folder.resolve("results/runs.csv"));
        assertArrayEquals(expected, runsOf(PlanFiles.read(folder.resolve("study.xml")), folder.resolve("again")));
        assertArrayEquals(
                expected,
                runsOf(PlanFiles.read(folder.resolve("results/plan/plan.xml")), folder.resolve("fromCopy")),
                "the copy of the plan beside the results can be run too");
        run.delete();
    }

    /** The name of the plan begins with more words, and is as long as that of a scenario at most. */
    @Test
    void aScenarioMayHaveTheLongestName() throws Exception {
        Scenario yard = editedYard().withName("y".repeat(10_000));
        new BatchPlan(yard, 31, 1, 1, false, DiagnosisChoice.OFF, false, FAULTS, "0.5", List.of("left"))
                .save(folder.resolve("study.xml"));
        PlanHeader header = PlanFiles.read(folder.resolve("study.xml")).header();
        assertEquals(10_000, header.name().length());
        assertTrue(header.name().startsWith("Batch of yy"), header.name().substring(0, 20));
    }

    /** Ids of scenarios may have blanks, dots and all that is not a double quote. */
    @Test
    void sensorsWithAnyIdCanFail() throws Exception {
        List<String> ids = List.of("front nose", "any", "1..2", "left");
        Scenario yard = editedYard();
        List<SensorSpec> sensors = new ArrayList<>(yard.setup().robot().sensors());
        for (int i = 0; i < ids.size(); i++) {
            sensors.set(i, sensors.get(i).withId(ids.get(i)));
        }
        BatchPlan plan = new BatchPlan(
                yard.withSetup(yard.setup().withRobot(yard.setup().robot().withSensors(sensors))),
                31,
                1,
                1,
                false,
                DiagnosisChoice.OFF,
                false,
                FAULTS,
                "0.5",
                ids);
        BatchRun run = new BatchRun(plan, 1);
        long runs = plan.runCount().orElseThrow();
        assertEquals(new CampaignRunner.RunCounts((int) runs, (int) runs, 0), run.make());
        BatchResults results = new BatchResults(run.planOrNull());
        for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
            results.add(row);
        }
        run.delete();
        assertEquals(
                Set.copyOf(ids),
                IntStream.range(0, results.size())
                        .mapToObj(row -> results.value(row, "fault_sensor"))
                        .collect(Collectors.toSet()));
    }

    /** Makes a batch and ends the process as a window does that is closed meanwhile. */
    static final class ClosedWindow {

        private ClosedWindow() {}

        public static void main(String[] arguments) throws Exception {
            new BatchRun(plan(DiagnosisChoice.OFF, 1), 1).make();
            try (Stream<Path> left = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
                System.out.print(left.count());
            }
            System.exit(0);
        }
    }

    @Test
    void theFilesOfABatchAreDeletedWhenTheProgramEnds() throws Exception {
        ProcessBuilder builder = JavaProcess.builder(ClosedWindow.class.getName(), List.of());
        builder.command().add(1, "-Djava.io.tmpdir=" + folder);
        assertEquals("1", JavaProcess.output(builder.start()));
        try (Stream<Path> left = Files.list(folder)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void theTimeLeftIsThatOfTheRunsThatAreMissing() {
        assertEquals(16, new BatchRun.Completion(2, 10, 4).secondsLeft());
        assertEquals(0, new BatchRun.Completion(10, 10, 4).secondsLeft());
        assertTrue(Double.isNaN(new BatchRun.Completion(0, 10, 4).secondsLeft()));
        assertEquals("2 of 10 runs, 16 s left", BatchProgressPanel.progressText(new BatchRun.Completion(2, 10, 4)));
        assertEquals("0 of 10 runs", BatchProgressPanel.progressText(new BatchRun.Completion(0, 10, 4)));
    }

    private static List<List<String>> labels(List<BatchPlan.FaultValues> faults, List<String> sensors)
            throws Exception {
        BatchRun run = new BatchRun(
                new BatchPlan(editedYard(), 31, 1, 1, false, DiagnosisChoice.OFF, false, faults, "0.5", sensors), 1);
        run.make();
        run.delete();
        return run.cells().stream().map(CampaignCell::labels).toList();
    }

    @Test
    void aSumIsListedOnlyIfItIsOverSeveralFaultsOrSensors() throws Exception {
        BatchPlan.FaultValues off = new BatchPlan.FaultValues("off", "");
        BatchPlan.FaultValues stuck = new BatchPlan.FaultValues("stuck", "0.3");
        assertEquals(List.of(List.of("off", "front")), labels(List.of(off), List.of("front")));
        assertEquals(
                List.of(List.of("off", "front"), List.of("stuck", "front"), List.of("all", "front")),
                labels(List.of(off, stuck), List.of("front")));
        assertEquals(
                List.of(List.of("off", "front"), List.of("off", "left"), List.of("off", "all")),
                labels(List.of(off), List.of("front", "left")));
    }

    @Test
    void aSecondPlanReplacesNoOtherScenario() throws Exception {
        BatchPlan plan = plan(DiagnosisChoice.SCENARIO, 5);
        Path other = Files.writeString(folder.resolve("study-scenario.xml"), "mine");
        plan.save(folder.resolve("study.xml"));
        plan.save(folder.resolve("study.xml"));
        assertEquals("mine", Files.readString(other));
        try (var files = Files.list(folder)) {
            assertEquals(
                    List.of("study-scenario-2.xml", "study-scenario.xml", "study.xml"),
                    files.map(file -> file.getFileName().toString()).sorted().toList());
        }
        assertEquals(18, PlanFiles.read(folder.resolve("study.xml")).runCount());
    }

    @Test
    void aPlanThatCannotBeWrittenLeavesNoScenarioBesideIt() throws Exception {
        BatchPlan plan = plan(DiagnosisChoice.SCENARIO, 5);
        Path taken = Files.createDirectory(folder.resolve("study.xml"));
        assertThrows(IOException.class, () -> plan.save(taken));
        try (var files = Files.list(folder)) {
            assertEquals(List.of(taken), files.toList());
        }
    }

    @Test
    void everyRunOpensWithTheTrajectoryOfItsRow() throws Exception {
        BatchRun run = new BatchRun(plan(DiagnosisChoice.OFF, 4), 2);
        run.make();
        BatchResults results = results(run);
        for (int index : new int[] {0, 3, results.size() - 1}) {
            Scenario scenario = ReplayScenario.of(
                    results.plan(),
                    index,
                    Outcome.ofWord(results.value(index, "outcome")).orElseThrow(),
                    Double.parseDouble(results.value(index, "simulated_s")));
            assertEquals(results.value(index, "trajectory_hash"), hashInSession(scenario), "run " + index);
        }
        run.delete();
    }

    private static BatchResults results(BatchRun run) {
        BatchResults results = new BatchResults(run.planOrNull());
        for (List<String> row = run.takeRow(); row != null; row = run.takeRow()) {
            results.add(row);
        }
        return results;
    }

    /** Runs a scenario as the window does. */
    private static String hashInSession(Scenario scenario) {
        long ticks = scenario.setup().ticks();
        try (Session session = Session.start(scenario.setup())) {
            session.setSpeed(Double.POSITIVE_INFINITY);
            session.pauseAt(ticks);
            session.resume();
            Await.until("the end of the run", () -> session.frame().snapshot().tick() == ticks);
            return String.format(
                    Locale.ROOT,
                    "%016x",
                    session.frame().recording().hashTrace().hashAt(ticks));
        }
    }

    @Test
    void aCancelledBatchKeepsWholeRowsAndCanGoOn() throws Exception {
        // So many runs that it is cancelled before the last one, however late.
        BatchPlan plan = plan(DiagnosisChoice.SCENARIO, 2, 100_000);
        BatchRun run = new BatchRun(plan, 1);
        Thread canceller = new Thread(() -> {
            while (run.completion().made() < 3) {
                Thread.onSpinWait();
            }
            run.progress().cancel();
        });
        canceller.start();
        CampaignRunner.RunCounts result = run.make();
        canceller.join();
        assertFalse(result.isComplete());
        assertTrue(result.made() >= 3);
        assertEquals(result.made(), results(run).size());
        Path saved = folder.resolve("results");
        run.saveResults(saved);
        String table = Files.readString(saved.resolve("runs.csv"));
        assertEquals(result.made() + 1, table.lines().count());
        assertTrue(table.endsWith("\n"));
        CampaignRunner rest = new CampaignRunner(run.planOrNull(), new CampaignFolder(saved), Shard.ALL, 2);
        AtomicLong seen = new AtomicLong();
        CampaignRunner.RunCounts continued =
                rest.run(true, (made, runs) -> seen.set(made), () -> seen.get() > result.made());
        assertEquals(result.made() + 1, continued.made());
        run.delete();
    }

    @Test
    void aCancelledBatchIsContinuedAsIfItHadBeenMadeAtOnce() throws Exception {
        BatchPlan plan = plan(DiagnosisChoice.BOTH, 2);
        BatchRun run = new BatchRun(plan, 1);
        run.progress().cancel();
        assertEquals(new CampaignRunner.RunCounts(0, 36, 0), run.make());
        run.prepareToContinue();
        Thread canceller = new Thread(() -> {
            while (run.completion().made() < 3) {
                Thread.onSpinWait();
            }
            run.progress().cancel();
        });
        canceller.start();
        run.make();
        canceller.join();
        double seconds = run.completion().seconds();
        run.prepareToContinue();
        assertEquals(new CampaignRunner.RunCounts(36, 36, 0), run.make());
        assertTrue(run.completion().seconds() >= seconds);
        assertEquals(
                LongStream.range(0, 36).boxed().toList(),
                IntStream.range(0, 36).mapToObj(results(run)::run).toList());
        run.saveResults(folder.resolve("results"));
        run.delete();
        assertArrayEquals(
                runsOf(PlanFiles.read(folder.resolve("results/plan/plan.xml")), folder.resolve("again")),
                Files.readAllBytes(folder.resolve("results/runs.csv")));
    }

    /** Its rows are of no result. */
    @Test
    void resultsAreSavedWithoutTheTableOfTimes() throws Exception {
        BatchRun run = new BatchRun(plan(DiagnosisChoice.SCENARIO, 2), 1);
        run.make();
        String table = Files.readString(run.results().resolve("runs.csv"));
        Files.delete(run.results().resolve("timing.csv"));
        Path saved = folder.resolve("results");
        run.saveResults(saved);
        run.delete();
        assertEquals(table, Files.readString(saved.resolve("runs.csv")));
        assertFalse(Files.exists(saved.resolve("timing.csv")));
    }

    /** Rows that a full disk did not take, for example, are not in the table. */
    @Test
    void runsThatTheTableLacksAreMadeAgainAndCountOnce() throws Exception {
        BatchPlan plan =
                new BatchPlan(editedYard(), 31, 2, 2, false, DiagnosisChoice.OFF, true, FAULTS, "1", List.of("left"));
        BatchRun whole = new BatchRun(plan, 1);
        whole.make();
        whole.delete();
        BatchRun run = new BatchRun(plan, 1);
        run.make();
        Files.delete(run.results().resolve("runs.csv"));
        run.prepareToContinue();
        assertEquals(new CampaignRunner.RunCounts(10, 10, 0), run.make());
        assertEquals(whole.cells(), run.cells());
        assertEquals(whole.repeatCount(), run.repeatCount());
        Files.delete(run.results().resolve("runs.csv"));
        run.prepareToContinue();
        run.progress().cancel();
        assertEquals(new CampaignRunner.RunCounts(0, 10, 0), run.make());
        assertTrue(run.cells().stream().allMatch(cell -> cell.runs().isEmpty()));
        run.delete();
    }

    /** A controller can be built between the two parts. */
    @Test
    void aBatchIsNotContinuedWithAChangedProgramOrController() throws Exception {
        BatchPlan plan =
                new BatchPlan(editedYard(), 31, 1, 2, false, DiagnosisChoice.OFF, true, FAULTS, "1", List.of("left"));
        BatchRun run = new BatchRun(plan, 1);
        run.make();
        Path manifest = run.results().resolve("campaign.json");
        String text = Files.readString(manifest);
        Files.writeString(manifest, text.replaceFirst("(\"program_sha256\": \")..", "$1zz"));
        run.prepareToContinue();
        assertThrows(BatchRun.ChangedException.class, run::make);
        Files.writeString(manifest, text);
        run.prepareToContinue();
        assertTrue(run.make().isComplete());
        run.delete();
    }

    @Test
    void savingResultsLeavesOtherFilesAlone() throws Exception {
        BatchRun run = new BatchRun(plan(DiagnosisChoice.SCENARIO, 2), 1);
        run.make();
        Path hidden = Files.createDirectory(folder.resolve(".results.tmp"));
        Path other = Files.writeString(hidden.resolve("note.txt"), "mine");
        run.saveResults(folder.resolve("results"));
        run.delete();
        assertEquals("mine", Files.readString(other));
        try (Stream<Path> files = Files.list(folder)) {
            assertEquals(Set.of(hidden, folder.resolve("results")), files.collect(Collectors.toSet()));
        }
    }

    @Test
    void cellsHaveTheirRunsAndSumsComeLast() throws Exception {
        BatchRun run = new BatchRun(plan(DiagnosisChoice.SCENARIO, 2), 2);
        run.make();
        List<CampaignCell> cells = run.cells();
        // No fault, three kinds on two sensors; each kind, each sensor, all.
        assertEquals(1 + 6 + 3 + 2 + 1, cells.size());
        assertEquals(List.of("none", ""), cells.get(0).labels());
        assertEquals(List.of(0L, 9L), cells.get(0).runs());
        List<CampaignCell> sums = cells.subList(7, cells.size());
        assertTrue(sums.stream().allMatch(cell -> cell.labels().contains(CampaignCell.ALL)));
        CampaignCell total = sums.stream()
                .filter(cell -> cell.labels().equals(List.of(CampaignCell.ALL, CampaignCell.ALL)))
                .findFirst()
                .orElseThrow();
        assertEquals(16, total.runs().size());
        assertEquals(16, total.withoutContact().n());
        run.delete();
    }

    /** Nothing is random in the yard, so all seeds give the run of the first. */
    @Test
    void runsThatDifferInTheirSeedOnlyAreReportedAndCountOnce() throws Exception {
        List<BatchPlan.FaultValues> off = List.of(new BatchPlan.FaultValues("off", ""));
        BatchRun run = new BatchRun(
                new BatchPlan(editedYard(), 31, 5, 2, false, DiagnosisChoice.OFF, false, off, "0.5", List.of("front")),
                1);
        CampaignRunner.RunCounts counts = run.make();
        run.delete();
        assertEquals(4, run.repeatCount());
        Survival withoutContact = run.cells().get(0).withoutContact();
        assertEquals(5, withoutContact.n());
        assertEquals(Interval.wilson(1, 1), withoutContact.interval());
        assertEquals(
                "Runs: 5 in 2 s, failed: 0. Runs that repeat another one, except for the seed: 4",
                BatchProgressPanel.endText(counts, 2, run.repeatCount()));
        assertEquals("Runs: 5 in 2 s, failed: 0", BatchProgressPanel.endText(counts, 2, 0));
    }

    @Test
    void aPlanThatTheScenarioCannotTakeIsReportedAndMakesNoRun() throws Exception {
        BatchPlan plan = new BatchPlan(
                editedYard(),
                1,
                1,
                5,
                false,
                DiagnosisChoice.SCENARIO,
                false,
                List.of(new BatchPlan.FaultValues("dropout", "1.5")),
                "1",
                List.of("front"));
        BatchRun run = new BatchRun(plan, 1);
        ScenarioException problem = assertThrows(ScenarioException.class, run::make);
        assertTrue(problem.getMessage().contains("1.5"), problem.getMessage());
        assertEquals(0, run.completion().runs());
        run.delete();
    }

    @Test
    void aRunIsNamedInTheLanguageOfTheWindow() {
        Scenario scenario = new Scenario(
                "Run 2",
                "",
                false,
                SimulationSetup.of(new WorldSpec(3, 2, true, 0, List.of()), new Pose(1, 1, 0)),
                Expectation.NONE);
        try {
            Messages.setLanguage(Language.POLISH);
            assertEquals("Przebieg 2", BatchActions.named(scenario, 2).name());
        } finally {
            Messages.setLanguage(Language.ENGLISH);
        }
    }
}
