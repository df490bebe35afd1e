package faultline.gui.document;

import faultline.engine.recording.RunEvent;
import faultline.engine.session.ReferenceRun;
import java.util.Optional;

/**
 * A comparison of the run with a reference run of a scenario, and the first tick in which they differ, null while they
 * do not.
 */
public record RunComparison(String name, ReferenceRun run, RunEvent.Diverged divergenceOrNull, boolean seedDiffers) {

    /** Returns the first tick in which the runs differ; empty while they do not. */
    public Optional<RunEvent.Diverged> divergence() {
        return Optional.ofNullable(divergenceOrNull);
    }
}
