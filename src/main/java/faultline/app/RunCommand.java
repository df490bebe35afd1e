package faultline.app;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.engine.walls.Coverage;
import faultline.external.ControllerJars;
import faultline.scenario.RunJson;
import faultline.scenario.RunSummary;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** {@code run}: runs a scenario without a window and prints its summary to standard output. */
final class RunCommand {

    private final CommandOutput output;

    RunCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        RunOptions options = RunOptions.parse(arguments);
        ControllerJars.use(options.child().jars());
        options.checkController();
        Scenario scenario = options.applyTo(Scenario.load(options.file()));
        requireController(scenario, !options.controller().isScenarioDefault());
        options.formatNotes().forEach(output::printError);
        try (RunOutputs outputs = new RunOutputs(options)) {
            RunResult result =
                    keepOutputs(scenario, outputs, () -> runOnce(scenario, options, outputs), output::printError);
            Optional<String> unsaved = outputs.finish(scenario);
            int code = print(scenario, result, options);
            unsaved.ifPresent(output::printError);
            return unsaved.isPresent() ? ExitCode.BAD_INPUT : code;
        }
    }

    private int print(Scenario scenario, RunResult result, RunOptions options) {
        if (options.json()) {
            return printJson(scenario, result, options.child().truth());
        }
        if (options.child().truth()) {
            output.println("truth: given to the controller");
        }
        return printResult(scenario, result);
    }

    /** A function that runs a scenario. */
    interface ScenarioRunner {
        RunResult make() throws IOException;
    }

    /**
     * Runs a scenario; if only its result cannot be computed, the outputs are completed before the failure.
     * {@code errors} receives why one of them is not written.
     */
    static RunResult keepOutputs(Scenario scenario, RunOutputs outputs, ScenarioRunner run, Consumer<String> errors)
            throws IOException {
        try {
            return run.make();
        } catch (HeadlessRun.ResultFailedException e) {
            outputs.finish(scenario).ifPresent(errors);
            throw e;
        }
    }

    private RunResult runOnce(Scenario scenario, RunOptions options, RunOutputs outputs) throws IOException {
        return new ControllerRunner(
                        options.controller(), options.child().childSettings(scenario.name(), output::printError))
                .run(scenario.setup(), options.mode(), outputs.observers());
    }

    /** Throws an exception if a scenario wants a controller from outside, and none is chosen. */
    static void requireController(Scenario scenario, boolean chosen) throws UsageException {
        if (scenario.setup().controller() instanceof ControllerSpec.Extern && !chosen) {
            throw new UsageException("the scenario is driven by a controller from outside, which a file cannot name:"
                    + " choose one with --controller");
        }
    }

    /** Runs a scenario without output files. */
    int run(Scenario scenario) {
        return printResult(scenario, HeadlessRun.run(scenario.setup(), ControllerMode.DIRECT, List.of()));
    }

    private int printResult(Scenario scenario, RunResult result) {
        List<String> unmet = scenario.expectation().unmet(result);
        output.println(RunSummary.lines(result));
        output.println("expectations: " + (unmet.isEmpty() ? "held" : "failed"));
        return reportUnmet(result, unmet);
    }

    private int printJson(Scenario scenario, RunResult result, boolean truth) {
        List<String> unmet = scenario.expectation().unmet(result);
        output.printJson(RunJson.format(result, truth, unmet));
        return reportUnmet(result, unmet);
    }

    private int reportUnmet(RunResult result, List<String> unmet) {
        result.refusals().forEach(refusal -> output.printError("refused " + refusal));
        if (result.isPathTooLong()) {
            output.printError(
                    "the coverage is not known: the path along the wall has too many places; expected at most "
                            + Coverage.MAX_PATH_PLACES);
        }
        unmet.forEach(output::printError);
        return unmet.isEmpty() ? ExitCode.SUCCESS : ExitCode.EXPECTATION_FAILED;
    }
}
