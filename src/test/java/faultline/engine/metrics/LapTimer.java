package faultline.engine.metrics;

import faultline.control.FollowerState;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import java.util.OptionalDouble;

/**
 * Times a lap: from a gate on a straight piece of wall, chosen once the robot has settled, back to it with the same
 * heading.
 */
final class LapTimer implements TickObserver {

    private static final double SETTLING_TIME = 20;
    private static final double MIN_STRAIGHT_TIME = 1;
    private static final double LEAVE_DISTANCE = 0.5;
    private static final double RETURN_DISTANCE = 0.05;
    private static final double HEADING_TOLERANCE = 0.5;

    private Pose gate = Pose.ORIGIN;
    private double startTime = Double.NaN;
    private boolean hasLeft;
    private double lapTime = Double.NaN;

    @Override
    public void observe(Simulation simulation) {
        if (Double.isNaN(startTime)) {
            chooseGate(simulation);
        } else if (Double.isNaN(lapTime)) {
            updateLap(simulation);
        }
    }

    private void chooseGate(Simulation simulation) {
        double steady = simulation.time()
                - simulation.telemetry().sinceTick() * simulation.setup().dt();
        if (simulation.time() > SETTLING_TIME
                && steady > MIN_STRAIGHT_TIME
                && simulation.telemetry().state() == FollowerState.FOLLOW) {
            gate = simulation.pose();
            startTime = simulation.time();
        }
    }

    private void updateLap(Simulation simulation) {
        double distance = simulation.pose().position().distanceTo(gate.position());
        hasLeft |= distance > LEAVE_DISTANCE;
        if (hasLeft
                && distance < RETURN_DISTANCE
                && Math.abs(Angles.difference(gate.heading(), simulation.pose().heading())) < HEADING_TOLERANCE) {
            lapTime = simulation.time() - startTime;
        }
    }

    /** Seconds; empty before the first lap. */
    OptionalDouble lapTime() {
        return Double.isNaN(lapTime) ? OptionalDouble.empty() : OptionalDouble.of(lapTime);
    }
}
