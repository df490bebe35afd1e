package faultline.app;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.external.ControllerChoice;
import faultline.external.ProcessControllerSource;
import faultline.scenario.RunSummary;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Runs setups without a window with a controller, given how it is treated if it is a child process. */
record ControllerRunner(ControllerChoice choice, ProcessControllerSource.ChildSettings settings) {

    /** Runs a setup with this controller, and sends the result to a child. */
    RunResult run(SimulationSetup setup, ControllerMode mode, List<TickObserver> observers) {
        try (ProcessControllerSource source = new ProcessControllerSource(choice.text(), settings).keepOpen()) {
            SimulationSetup chosen = choice.applyTo(setup, source);
            if (!ControllerChoice.startsCommand(chosen)) {
                return HeadlessRun.run(chosen, mode, observers);
            }
            List<TickObserver> all = new ArrayList<>(observers);
            all.add(source);
            RunResult result = HeadlessRun.run(chosen, mode, all);
            source.finish(RunSummary.formatHash(result), summary(result));
            return result;
        }
    }

    /** Returns the lines of the summary of a run, by their keys. */
    private static Map<String, String> summary(RunResult result) {
        Map<String, String> summary = new LinkedHashMap<>();
        RunSummary.lines(result).forEach(line -> summary.put(line.split(": ", 2)[0], line.split(": ", 2)[1]));
        return summary;
    }
}
