package faultline.control;

import faultline.io.MessageText;
import java.util.List;
import java.util.Objects;

/**
 * The internal values of a controller, for display and traces; they are never fed back to a controller. A value that
 * does not apply is not a number (NaN).
 *
 * @param state its state
 * @param condition the named condition that led to the state, empty at the start
 * @param sinceTick the tick at which the state was entered
 * @param transitions the number of transitions that it has made
 * @param wall its control of the distance to the wall
 * @param edges when the left sensor passed the wall
 * @param diagnosis its trust in the sensors
 */
public record Telemetry(
        ControllerState state,
        String condition,
        long sinceTick,
        int transitions,
        WallControl wall,
        EdgeTimes edges,
        Diagnosis diagnosis) {

    /** The greatest length of a text that a controller from outside gives, in {@code char} values. */
    private static final int MAX_LENGTH = 200;

    /**
     * Creates the values of a tick.
     *
     * @param state its state
     * @param condition the named condition that led to the state, empty at the start
     * @param sinceTick the tick at which the state was entered
     * @param transitions the number of transitions that it has made
     * @param wall its control of the distance to the wall
     * @param edges when the left sensor passed the wall
     * @param diagnosis its trust in the sensors
     * @throws NullPointerException if one of them is null
     */
    public Telemetry {
        Objects.requireNonNull(state, "state");
        Objects.requireNonNull(condition, "condition");
        Objects.requireNonNull(wall, "wall");
        Objects.requireNonNull(edges, "edges");
        Objects.requireNonNull(diagnosis, "diagnosis");
    }

    /**
     * The distance control.
     *
     * @param wantedDistance the distance that it maintains, metres
     * @param measuredDistance the distance that it measures, metres; positive infinity if nothing is within range
     * @param proportional the PD controller's P term, radians per second, positive towards the followed wall
     * @param derivative the PD controller's D term, radians per second, positive towards the followed wall
     */
    public record WallControl(double wantedDistance, double measuredDistance, double proportional, double derivative) {

        /** The value of a controller that follows no wall. */
        public static final WallControl NONE = new WallControl(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }

    /**
     * The times of the alignment manoeuvre, on the clock of its spin, which starts at 0 when TURN begins.
     *
     * @param tF3 when the left sensor came to the timing distance, the paper's frame F3, seconds
     * @param tF4 when it left it, frame F4, seconds
     * @param tP the time for which it turns back, t_p = t_D / 2 of eq. (4), seconds; negative if F4 is before F3 on the
     *     clock of the turned angle, as with random readings
     * @param origin the simulated time at which the clock would be 0 if it had run as simulated time does, seconds
     */
    public record EdgeTimes(double tF3, double tF4, double tP, double origin) {

        /** The value of a controller that times no wall. */
        public static final EdgeTimes NONE = new EdgeTimes(Double.NaN, Double.NaN, Double.NaN);

        /**
         * Creates times on a clock whose origin is not known.
         *
         * @param tF3 when the left sensor came to the timing distance, seconds
         * @param tF4 when it left it, seconds
         * @param tP the time for which it turns back, seconds
         */
        public EdgeTimes(double tF3, double tF4, double tP) {
            this(tF3, tF4, tP, Double.NaN);
        }
    }

    /**
     * {@return the telemetry after a controller that is not part of the program has named a state} If the state is the
     * same as before, there is no transition.
     *
     * @param newState the name of its state
     * @param why the condition that brought it there, empty if it gives none
     * @param tick the tick at which it named them
     */
    public Telemetry entering(String newState, String why, long tick) {
        return newState.equals(state.name())
                ? this
                : new Telemetry(
                        ControllerState.of(newState),
                        why,
                        tick,
                        transitions + 1,
                        WallControl.NONE,
                        EdgeTimes.NONE,
                        Diagnosis.NONE);
    }

    /**
     * {@return a text of a controller from outside, such as the name of a state, cut off if it is long} A run keeps it.
     *
     * @param text the text
     */
    public static String limited(String text) {
        return MessageText.start(text, MAX_LENGTH);
    }

    /** Returns the same values with limited texts. */
    Telemetry limited() {
        String name = state.name();
        if (Math.max(Math.max(name.length(), condition.length()), diagnosis.rung.length()) <= MAX_LENGTH) {
            return this;
        }
        return new Telemetry(
                ControllerState.of(limited(name)),
                limited(condition),
                sinceTick,
                transitions,
                wall,
                edges,
                new Diagnosis(limited(diagnosis.rung), diagnosis.health));
    }

    /**
     * The result of a sensor diagnosis.
     *
     * @param rung the name of the strategy that drives, empty without a diagnosis
     * @param health the health of the first sensors or of all, in the robot's order; that of the others is unknown;
     *     empty without a diagnosis
     */
    public record Diagnosis(String rung, List<SensorHealth> health) {

        /** The value of a controller without a diagnosis. */
        public static final Diagnosis NONE = new Diagnosis("", List.of());

        /**
         * Creates a diagnosis from a copy of the health.
         *
         * @param rung the name of the strategy that drives, empty without a diagnosis
         * @param health the health of the first sensors or of all, in the robot's order; that of the others is unknown;
         *     empty without a diagnosis
         * @throws NullPointerException if one of them is null or contains null
         */
        public Diagnosis {
            Objects.requireNonNull(rung, "rung");
            health = List.copyOf(health);
        }
    }

    /**
     * {@return the telemetry of a controller that shows nothing but its state}
     *
     * @param state the state
     */
    public static Telemetry ofState(ControllerState state) {
        return new Telemetry(state, "", 0, 0, WallControl.NONE, EdgeTimes.NONE, Diagnosis.NONE);
    }
}
