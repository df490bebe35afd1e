package faultline.engine.session;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.metrics.RunFacts;
import faultline.engine.metrics.RunMeasures;
import faultline.engine.recording.Recording;
import faultline.engine.recording.StateTally;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A frame that a session publishes, with what has been recorded up to its tick. Immutable.
 *
 * @param frame the state at the end of a tick
 * @param recording the recording of the run up to that tick
 * @param measures the measures of the run up to that tick
 * @param controller the settings of the controller
 * @param controllerName the name that the controller gives itself, on one line; empty if it gives none
 * @param dt the length of a tick, seconds
 */
public record SessionFrame(
        Frame frame,
        Recording recording,
        RunMeasures measures,
        ControllerSpec controller,
        String controllerName,
        double dt)
        implements RunFacts {

    /** {@return the world at the end of the tick} */
    public Snapshot snapshot() {
        return frame.snapshot();
    }

    /** {@return the controller's telemetry of the tick} */
    public Telemetry telemetry() {
        return frame.telemetry();
    }

    @Override
    public ControllerState finalState() {
        return telemetry().state();
    }

    @Override
    public List<ControllerState> visitedStates() {
        return recording.stateTally().states().stream()
                .map(StateTally.StateVisits::state)
                .toList();
    }

    @Override
    public Optional<Collision> collision() {
        return snapshot().collision();
    }

    @Override
    public OptionalDouble coverage() {
        return RunFacts.ifNumber(measures.coverage());
    }

    @Override
    public boolean isPathTooLong() {
        return measures.isPathTooLong();
    }

    @Override
    public OptionalDouble distanceRms() {
        return RunFacts.ifNumber(measures.distanceRms());
    }
}
