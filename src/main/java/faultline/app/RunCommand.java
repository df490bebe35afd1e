package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.scenario.RunSummary;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.io.IOException;
import java.util.List;

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
            RunResult result = HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
            outputs.finish(scenario, result.ticks());
            return printResult(scenario, result);
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
        result.refusals().forEach(refusal -> output.printError("refused " + refusal));
        unmet.forEach(output::printError);
        return unmet.isEmpty() ? ExitCode.SUCCESS : ExitCode.EXPECTATION_FAILED;
    }
}
