package faultline.engine.metrics;

import faultline.control.ControllerState;
import faultline.engine.recording.RunEvent;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What a headless run came to.
 *
 * @param ticks how many were made
 * @param simulatedSeconds ticks times dt
 * @param realTimeFactor simulated seconds per second of the clock
 * @param finalState the controller's last state
 * @param visitedStates all states that the controller passed through, in the order of their first appearance
 * @param collision the first contact, empty where there was none
 * @param coverage the share of the wall that could be followed that was, in [0, 1]; empty where no wall was followed
 * @param distanceRms the distance error on straight walls, metres, root mean square; empty where none was followed
 * @param trajectoryHash of all ticks
 * @param seed that the run used
 * @param refusals what the timeline asked for and the world refused, one sentence each, in order
 * @param rung the name of the rung that drove last; empty for a controller without a diagnosis
 * @param diagnosisEvents the changes of the sensors' health and of the rung, in order
 * @param finalSnapshot the world at the end
 */
public record RunResult(
        long ticks,
        double simulatedSeconds,
        double realTimeFactor,
        ControllerState finalState,
        List<ControllerState> visitedStates,
        Optional<Collision> collision,
        OptionalDouble coverage,
        OptionalDouble distanceRms,
        long trajectoryHash,
        long seed,
        List<String> refusals,
        String rung,
        List<RunEvent> diagnosisEvents,
        Snapshot finalSnapshot) {

    public RunResult {
        visitedStates = List.copyOf(visitedStates);
        refusals = List.copyOf(refusals);
        diagnosisEvents = List.copyOf(diagnosisEvents);
    }
}
