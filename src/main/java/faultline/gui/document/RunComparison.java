package faultline.gui.document;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import java.util.Optional;

/**
 * A comparison of the run with a reference run.
 *
 * @param name the name of the scenario of the reference run
 * @param run the reference run
 * @param divergenceOrNull the first tick in which the runs differ, null while they do not
 * @param seedDiffers whether the reference run has another seed
 */
public record RunComparison(String name, ReferenceRun run, RunEvent.Diverged divergenceOrNull, boolean seedDiffers) {

    /** Returns the first tick in which the runs differ; empty while they do not. */
    public Optional<RunEvent.Diverged> divergence() {
        return Optional.ofNullable(divergenceOrNull);
    }
}
