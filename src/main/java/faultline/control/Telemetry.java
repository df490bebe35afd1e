package faultline.control;

import java.util.List;

/**
 * What a controller shows of its working; shown and traced, never fed back. A number that does not apply now is not a
 * number.
 *
 * @param state the name of its state, such as FOLLOW
 * @param condition the named condition that brought it there, empty at the start
 * @param sinceTick the tick at which it came there
 * @param transitions how many transitions it has made
 * @param wantedDistance the distance that it holds, metres
 * @param measuredDistance the distance that it goes by, metres
 * @param proportional the PD controller's P term, radians per second
 * @param derivative the PD controller's D term, radians per second
 * @param tF3 when the left sensor came to the timing distance, the paper's frame F3, seconds
 * @param tF4 when it left it, frame F4, seconds
 * @param tP how long it turns back, t_p = t_D / 2 of eq. (4), seconds
 * @param rung the name of the strategy that drives, empty for a controller without a diagnosis
 * @param health what the diagnosis thinks of each sensor, in the robot's order, empty for a controller without one
 */
public record Telemetry(
        String state,
        String condition,
        long sinceTick,
        int transitions,
        double wantedDistance,
        double measuredDistance,
        double proportional,
        double derivative,
        double tF3,
        double tF4,
        double tP,
        String rung,
        List<SensorHealth> health) {

    public Telemetry {
        health = List.copyOf(health);
    }

    /** Telemetry of a controller without a diagnosis. */
    public Telemetry(
            String state,
            String condition,
            long sinceTick,
            int transitions,
            double wantedDistance,
            double measuredDistance,
            double proportional,
            double derivative,
            double tF3,
            double tF4,
            double tP) {
        this(
                state,
                condition,
                sinceTick,
                transitions,
                wantedDistance,
                measuredDistance,
                proportional,
                derivative,
                tF3,
                tF4,
                tP,
                "",
                List.of());
    }

    /**
     * The telemetry of a controller with nothing to show but a name.
     *
     * @param state the name
     * @return telemetry without numbers
     */
    public static Telemetry ofState(String state) {
        double none = Double.NaN;
        return new Telemetry(state, "", 0, 0, none, none, none, none, none, none, none);
    }

    /**
     * Returns this telemetry with the verdict of a diagnosis, and as a later one of several controllers.
     *
     * @param newSinceTick the tick at which it came to its state
     * @param earlierTransitions the transitions made before this controller drove
     * @param newRung the name of the strategy that drives
     * @param newHealth of each sensor
     */
    public Telemetry withDiagnosis(
            long newSinceTick, int earlierTransitions, String newRung, List<SensorHealth> newHealth) {
        return new Telemetry(
                state,
                condition,
                newSinceTick,
                transitions + earlierTransitions,
                wantedDistance,
                measuredDistance,
                proportional,
                derivative,
                tF3,
                tF4,
                tP,
                newRung,
                newHealth);
    }
}
