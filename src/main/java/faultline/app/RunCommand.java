package faultline.app;

import faultline.control.ControllerSpec;
import faultline.control.PeriodicController;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.external.ExternalController;
import faultline.external.RunDescription;
import faultline.scenario.RunSummary;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** {@code run}: runs a scenario without a window and prints its summary to standard output. */
final class RunCommand {

    private final CommandOutput output;

    RunCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        RunOptions options = RunOptions.parse(arguments);
        Scenario scenario = options.applyTo(Scenario.load(options.file()));
        try (RunOutputs outputs = new RunOutputs(options)) {
            RunResult result = options.controller().isPresent()
                    ? runExternally(scenario, options, outputs)
                    : HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
            outputs.finish(scenario, result.ticks());
            if (options.truth()) {
                output.println("truth: given to the controller");
            }
            return printResult(scenario, result);
        }
    }

    /** Runs with a controller in a child process, asked as often as the scenario's own controller would be. */
    private RunResult runExternally(Scenario scenario, RunOptions options, RunOutputs outputs) throws IOException {
        SimulationSetup setup = scenario.setup();
        double period = setup.controller() instanceof ControllerSpec.WallFollowing follower ? follower.period() : 0;
        RunDescription description = RunDescription.of(
                HelpText.version(), scenario.name(), setup, PeriodicController.ticksPerPeriod(period, setup.dt()));
        try (ExternalController child = new ExternalController(
                options.controller().orElseThrow(),
                description,
                ExternalController.Timeouts.DEFAULT.withAnswer(options.patience()),
                options.truth(),
                output::printError)) {
            List<TickObserver> observers = new ArrayList<>(outputs.observers());
            observers.add(child);
            RunResult result =
                    HeadlessRun.run(setup, new PeriodicController(child, period), ControllerMode.DIRECT, observers);
            child.finish("duration", RunSummary.formatHash(result), summary(result));
            return result;
        }
    }

    private static Map<String, String> summary(RunResult result) {
        Map<String, String> summary = new LinkedHashMap<>();
        RunSummary.lines(result).forEach(line -> summary.put(line.split(": ", 2)[0], line.split(": ", 2)[1]));
        return summary;
    }

    /** Runs a scenario without output files. */
    int run(Scenario scenario) {
        return printResult(scenario, HeadlessRun.run(scenario.setup(), ControllerMode.DIRECT, List.of()));
    }

    private int printResult(Scenario scenario, RunResult result) {
        List<String> unmet = scenario.expectation().unmet(result);
        output.println(RunSummary.lines(result));
        output.println("expectations: " + (unmet.isEmpty() ? "held" : "failed"));
        result.refusals().forEach(refusal -> output.printError("refused " + refusal));
        unmet.forEach(output::printError);
        return unmet.isEmpty() ? ExitCode.SUCCESS : ExitCode.EXPECTATION_FAILED;
    }
}
