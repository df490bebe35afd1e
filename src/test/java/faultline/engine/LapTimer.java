package faultline.engine;

import faultline.geometry.Angles;
import faultline.geometry.Pose;
import java.util.OptionalDouble;

/** Times a lap: from a gate on a straight piece of wall, chosen once the robot has settled, back to it with the same heading. */
final class LapTimer implements TickObserver {

    private static final double SETTLED = 20;
    private static final double STRAIGHT = 1;
    private static final double AWAY = 0.5;
    private static final double BACK = 0.05;
    private static final double SAME_HEADING = 0.5;

    private Pose gate = Pose.ORIGIN;
    private double opened = Double.NaN;
    private boolean away;
    private double lap = Double.NaN;

    @Override
    public void observe(Simulation simulation) {
        if (Double.isNaN(opened)) {
            lookForGate(simulation);
        } else if (Double.isNaN(lap)) {
            runLap(simulation);
        }
    }

    private void lookForGate(Simulation simulation) {
        double steady = simulation.time() - simulation.telemetry().since() * simulation.setup().dt();
        if (simulation.time() > SETTLED && steady > STRAIGHT && simulation.telemetry().state().equals("FOLLOW")) {
            gate = simulation.pose();
            opened = simulation.time();
        }
    }

    private void runLap(Simulation simulation) {
        double distance = simulation.pose().position().distanceTo(gate.position());
        away |= distance > AWAY;
        if (away && distance < BACK && Math.abs(Angles.difference(gate.heading(), simulation.pose().heading())) < SAME_HEADING) {
            lap = simulation.time() - opened;
        }
    }

    /** Seconds; empty before the first lap. */
    OptionalDouble lap() {
        return Double.isNaN(lap) ? OptionalDouble.empty() : OptionalDouble.of(lap);
    }
}
