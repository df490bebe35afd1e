package faultline.app;

import faultline.campaign.report.ControllerComparison;
import faultline.campaign.report.ControllerRuns;
import faultline.engine.ControllerMode;
import faultline.engine.Journal;
import faultline.engine.RobotPath;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.metrics.RunResult;
import faultline.external.ControllerChoice;
import faultline.external.ControllerJars;
import faultline.external.ControllerStartException;
import faultline.geometry.Pose;
import faultline.gui.GuiLauncher;
import faultline.io.MessageException;
import faultline.io.ProgramCommand;
import faultline.io.ShellText;
import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** {@code compare}: runs several controllers in the same scenario with the same seeds. */
final class CompareCommand {

    private static final List<String> OPTION_NAMES =
            List.of("--controller", "--seeds", "--out", "--until", "--jar", "--patience");
    private static final List<String> FLAG_NAMES = List.of("--truth", "--open");
    private static final int MAX_SEEDS = 10_000;

    private final CommandOutput output;

    CompareCommand(CommandOutput output) {
        this.output = output;
    }

    /** Keeps the last state of a run, and measures the path. The decisions are recorded only if the run is replayed. */
    private static final class EndObserver implements TickObserver {
        private final boolean replayed;
        private RobotPath path;
        private Journal journal;
        private Pose last;
        private double metres;

        EndObserver(boolean replayed) {
            this.replayed = replayed;
        }

        @Override
        public void observe(Simulation simulation) {
            if (!replayed) {
                simulation.stopRecordingDecisions();
            }
            Pose pose = simulation.pose();
            metres += last == null ? 0 : StrictMath.hypot(pose.x() - last.x(), pose.y() - last.y());
            last = pose;
            if (simulation.ticks() == simulation.setup().ticks()) {
                path = simulation.frame().path();
                journal = simulation.journal();
            }
        }
    }

    int run(List<String> given) throws UsageException, ScenarioException, IOException {
        Arguments arguments = new Arguments(given, OPTION_NAMES, FLAG_NAMES, List.of("--controller"));
        List<ControllerChoice> choices = new ArrayList<>();
        for (String text : arguments.values("--controller")) {
            choices.add(ControllerOptions.choice(text));
        }
        ControllerOptions options = ControllerOptions.parse(arguments, !choices.isEmpty());
        ControllerJars.use(options.jars());
        Path file = arguments.singleFile("compare");
        Path page = arguments
                .outputOption("--out")
                .orElseThrow(() -> new UsageException("compare needs --out FILE.html, the page that it writes"));
        if (choices.size() < 2 || choices.stream().distinct().count() < choices.size()) {
            throw new UsageException("compare needs --controller at least twice, each time with another one");
        }
        if (options.truth() && choices.stream().noneMatch(ControllerChoice::isCommand)) {
            throw new UsageException("--truth needs --controller COMMAND");
        }
        List<Path> inputs = new ArrayList<>(options.files(choices));
        inputs.add(file);
        ComparisonFiles files = new ComparisonFiles(page, choices.size());
        files.requireDistinct(inputs);
        boolean open = arguments.has("--open");
        if (open) {
            WindowCommand.requireDisplay("--open");
        }
        int seeds = arguments.positive("--seeds", MAX_SEEDS, 1);
        Scenario loaded = Scenario.load(file);
        requireSeeds(loaded.setup().seed(), seeds);
        Scenario scenario = loaded.withSetup(RunOptions.duration(arguments).apply(loaded.setup()));
        FormatNote.of(page, "an HTML page", List.of("html", "htm")).ifPresent(output::printError);
        int code = compare(file, scenario, choices, seeds, options, files);
        if (open && code == ExitCode.SUCCESS) {
            openWindow(file, loaded, choices, options);
        }
        return code;
    }

    /** Throws an exception if not all seeds from the first on are numbers of 64 bits. */
    private static void requireSeeds(long first, int seeds) throws UsageException {
        if (first > Long.MAX_VALUE - (seeds - 1)) {
            throw UsageException.ofValue(
                    "--seeds",
                    String.valueOf(seeds),
                    "at most " + (Long.MAX_VALUE - first + 1) + ", because the first seed is " + first
                            + " and the last possible one " + Long.MAX_VALUE);
        }
    }

    private int compare(
            Path file,
            Scenario scenario,
            List<ControllerChoice> choices,
            int seeds,
            ControllerOptions options,
            ComparisonFiles files)
            throws IOException {
        try (files) {
            files.open();
            List<ControllerRuns> compared = new ArrayList<>();
            Map<Path, Scenario> replays = new LinkedHashMap<>();
            for (ControllerChoice choice : choices) {
                compared.add(runAll(choice, scenario, seeds, options, files.replay(compared.size()), replays));
            }
            ControllerComparison comparison = new ControllerComparison(
                    scenario,
                    file.getFileName().toString(),
                    compared,
                    windowCommands(file, choices, options),
                    options.truth());
            if (options.truth()) {
                output.println("truth: given to the controllers in child processes");
            }
            return write(comparison, compared, files, replays);
        }
    }

    /** Shows the first two controllers, the second as the ghost. */
    private static void openWindow(
            Path file, Scenario scenario, List<ControllerChoice> choices, ControllerOptions options) {
        GuiLauncher.open(
                file,
                () -> scenario,
                new ControllerChoice(choices.get(0).text(), options.jars()),
                new ControllerChoice(choices.get(1).text(), options.jars()));
    }

    /** Returns the commands that show the first controller in the window with each other one as its ghost. */
    private static List<String> windowCommands(Path file, List<ControllerChoice> choices, ControllerOptions options) {
        if (options.truth()) {
            // The window does not give the ground truth to controllers.
            return List.of();
        }
        String jar = options.jars().stream()
                .map(path -> " --jar " + ShellText.quoted(path.toString()))
                .collect(Collectors.joining());
        return choices.stream()
                .skip(1)
                .map(ghost -> ProgramCommand.text() + " " + ShellText.quoted(file.toString()) + " --controller "
                        + ShellText.quoted(choices.get(0).text()) + " " + WindowCommand.GHOST_OPTION + " "
                        + ShellText.quoted(ghost.text()) + jar)
                .toList();
    }

    private ControllerRuns runAll(
            ControllerChoice choice,
            Scenario scenario,
            int seeds,
            ControllerOptions options,
            Path replayFile,
            Map<Path, Scenario> replays) {
        List<ControllerRuns.ComparedRun> runs = new ArrayList<>();
        List<ControllerRuns.FailedRun> broken = new ArrayList<>();
        for (int i = 0; i < seeds; i++) {
            SimulationSetup setup = scenario.setup().withSeed(scenario.setup().seed() + i);
            EndObserver end = new EndObserver(!replays.containsKey(replayFile));
            try {
                RunResult result = runOnce(choice, scenario.name(), setup, options, end);
                runs.add(ControllerRuns.ComparedRun.of(result, end.path, end.metres, scenario.setup()));
                replays.computeIfAbsent(replayFile, file -> JournalScenario.create(scenario, end.journal));
            } catch (RunFailedException e) {
                if (i == 0 && e instanceof ControllerStartException) {
                    // It is likely to be misspelt. A start that fails later, for lack of memory say, is one failed run.
                    throw e;
                }
                if (!e.isOfController() && e.getCause() instanceof OutOfMemoryError error) {
                    throw error;
                }
                output.printError("the run with seed " + setup.seed() + " broke: " + e.getMessage());
                broken.add(new ControllerRuns.FailedRun(setup.seed(), e.getMessage()));
            }
        }
        return new ControllerRuns(choice.text(), runs, broken);
    }

    private void reportRefusals(ControllerRuns runs) {
        runs.refusals()
                .forEach(refusal -> output.printError("the controller \"" + runs.controller() + "\": " + refusal));
    }

    private RunResult runOnce(
            ControllerChoice choice,
            String scenario,
            SimulationSetup setup,
            ControllerOptions options,
            EndObserver end) {
        return new ControllerRunner(choice, options.childSettings(scenario, output::printError))
                .run(setup, ControllerMode.DIRECT, List.of(end));
    }

    private int write(
            ControllerComparison comparison,
            List<ControllerRuns> compared,
            ComparisonFiles files,
            Map<Path, Scenario> replays)
            throws IOException {
        files.write(files.page(), comparison.html().getBytes(StandardCharsets.UTF_8));
        List<String> unsaved = List.of();
        if (files.areBesidePage()) {
            files.write(files.table(), comparison.csv().getBytes(StandardCharsets.UTF_8));
            unsaved = writeReplays(files, replays);
        }
        files.commit();
        output.println(comparison.lines());
        comparison.seedRemarks().forEach(remark -> output.println("seeds: " + remark));
        comparison.sameRunRemarks().forEach(remark -> output.println("runs: " + remark));
        output.println("page: " + files.page());
        if (files.areBesidePage()) {
            output.println("table: " + files.table());
        }
        compared.forEach(this::reportRefusals);
        comparison.windowCommands().forEach(command -> output.println("window: " + command));
        if (files.areBesidePage()) {
            replays.keySet().forEach(replay -> output.println("replay: " + replay));
        }
        unsaved.forEach(output::printError);
        if (!compared.stream().allMatch(runs -> runs.broken().isEmpty())) {
            return ExitCode.RUN_FAILED;
        }
        return unsaved.isEmpty() ? ExitCode.SUCCESS : ExitCode.BAD_INPUT;
    }

    /** Writes the replays but those that cannot be saved, which are removed. Returns why they cannot be saved. */
    static List<String> writeReplays(ComparisonFiles files, Map<Path, Scenario> replays) throws IOException {
        List<String> unsaved = new ArrayList<>();
        for (Map.Entry<Path, Scenario> replay : List.copyOf(replays.entrySet())) {
            byte[] bytes;
            try {
                bytes = replay.getValue().toBytes();
            } catch (MessageException e) {
                unsaved.add(CommandLine.problem(replay.getKey(), e));
                replays.remove(replay.getKey());
                continue;
            }
            files.write(replay.getKey(), bytes);
        }
        return unsaved;
    }
}
