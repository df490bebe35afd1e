package faultline.gui.document;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import java.util.Optional;

/**
 * A comparison of the run with a reference run of a scenario.
 *
 * @param name the name of the reference run
 * @param run the reference run
 * @param divergenceOrNull the first tick in which the runs differ, null while they do not
 * @param whole whether the run has passed the end of the reference run, so all of it has been compared
 * @param seedDiffers whether the seed of the reference run is not that of the scenario
 */
public record RunComparison(
        String name, ReferenceRun run, RunEvent.Diverged divergenceOrNull, boolean whole, boolean seedDiffers) {

    /** Creates the comparison of a run that has not been compared yet. */
    RunComparison(String name, ReferenceRun run) {
        this(name, run, null, false, false);
    }

    /** Returns the first tick in which the runs differ; empty while they do not. */
    public Optional<RunEvent.Diverged> divergence() {
        return Optional.ofNullable(divergenceOrNull);
    }
}
