package faultline.engine.metrics;

import faultline.control.ControllerState;
import faultline.engine.recording.RunEvent;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of a headless run.
 *
 * @param ticks the number of ticks made
 * @param simulatedSeconds the simulated time, seconds, without a rounding error
 * @param realTimeFactor simulated seconds per second of real time
 * @param finalState the controller's last state
 * @param visitedStates all states of the controller in the order of their first appearance
 * @param coverageOrNaN the followed share of the wall that could be followed, in [0, 1]; NaN if no wall was followed or
 *     its path is too long
 * @param isPathTooLong whether the coverage is not known, because the path along the wall has too many places
 * @param distanceRmsOrNaN the distance error on straight walls, metres, root mean square; NaN if none was followed
 * @param followRmsOrNaN the distance error in all of FOLLOW, metres, root mean square; NaN without any
 * @param trajectoryHash the trajectory hash of all ticks
 * @param seed the seed of the run
 * @param refusals the refused commands of the timeline, one sentence each, in order
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
        double coverageOrNaN,
        boolean isPathTooLong,
        double distanceRmsOrNaN,
        double followRmsOrNaN,
        long trajectoryHash,
        long seed,
        List<String> refusals,
        String rung,
        List<RunEvent> diagnosisEvents,
        Snapshot finalSnapshot)
        implements RunFacts {

    /**
     * Creates a result from copies of the lists.
     *
     * @param ticks the number of ticks made
     * @param simulatedSeconds the simulated time, seconds, without a rounding error
     * @param realTimeFactor simulated seconds per second of real time
     * @param finalState the controller's last state
     * @param visitedStates all states of the controller in the order of their first appearance
     * @param coverageOrNaN the followed share of the wall that could be followed, in [0, 1]; NaN if no wall was
     *     followed or its path is too long
     * @param isPathTooLong whether the coverage is not known, because the path along the wall has too many places
     * @param distanceRmsOrNaN the distance error on straight walls, metres, root mean square; NaN if none was followed
     * @param followRmsOrNaN the distance error in all of FOLLOW, metres, root mean square; NaN without any
     * @param trajectoryHash the trajectory hash of all ticks
     * @param seed the seed of the run
     * @param refusals the refused commands of the timeline, one sentence each, in order
     * @param rung the name of the rung that drove last; empty for a controller without a diagnosis
     * @param diagnosisEvents the changes of the sensors' health and of the rung, in order
     * @param finalSnapshot the world at the end
     */
    public RunResult {
        visitedStates = List.copyOf(visitedStates);
        refusals = List.copyOf(refusals);
        diagnosisEvents = List.copyOf(diagnosisEvents);
    }

    @Override
    public Optional<Collision> collision() {
        return finalSnapshot.collision();
    }

    @Override
    public OptionalDouble coverage() {
        return RunFacts.ifNumber(coverageOrNaN);
    }

    @Override
    public OptionalDouble distanceRms() {
        return RunFacts.ifNumber(distanceRmsOrNaN);
    }

    /** {@return the distance error in all of FOLLOW, metres, root mean square; empty without any} */
    public OptionalDouble followRms() {
        return RunFacts.ifNumber(followRmsOrNaN);
    }
}
