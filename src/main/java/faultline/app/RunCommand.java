package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.HeadlessRun;
import faultline.engine.RunResult;
import faultline.scenario.RunSummary;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.io.IOException;
import java.util.List;

/** {@code run}: a scenario without a window, its summary on standard output. */
final class RunCommand {

    private final Console console;

    RunCommand(Console console) {
        this.console = console;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        RunOptions options = RunOptions.of(arguments);
        Scenario scenario = options.applyTo(Scenario.load(options.file()));
        try (RunOutputs outputs = new RunOutputs(options)) {
            RunResult result = HeadlessRun.run(scenario.setup(), options.mode(), outputs.observers());
            outputs.finish(scenario, result.ticks());
            return tell(scenario, result);
        }
    }

    /** Runs a scenario with nothing to write. */
    int run(Scenario scenario) {
        return tell(scenario, HeadlessRun.run(scenario.setup(), ControllerMode.DIRECT, List.of()));
    }

    private int tell(Scenario scenario, RunResult result) {
        List<String> unmet = scenario.expect().unmet(result);
        console.tell(RunSummary.lines(result));
        console.tell("expectations: " + (unmet.isEmpty() ? "held" : "failed"));
        result.refused().forEach(refusal -> console.complain("refused " + refusal));
        unmet.forEach(console::complain);
        return unmet.isEmpty() ? ExitCode.DONE : ExitCode.UNMET;
    }
}
