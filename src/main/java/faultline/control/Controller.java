package faultline.control;

/** Drives the robot. It is called once per decision, every tick or every period, in order, by one thread at a time. */
@FunctionalInterface
public interface Controller {

    /**
     * Decides on the voltages. An exception, or a decision that is null, ends the run with an error.
     *
     * @param observation the newest observation
     * @return the decision, which acts at the next tick
     */
    Decision decide(Observation observation);

    /**
     * {@return the name that the controller gives itself, on one line, the same at any time, not null; empty if it
     * gives none} The name of a controller from a {@link java.util.ServiceLoader provider} is that of the provider.
     */
    default String name() {
        return "";
    }

    /**
     * Applies other settings between two decisions. A controller without settings does nothing.
     *
     * @param settings the new settings, of the same kind as those that it was made with
     */
    default void configure(ControllerSpec.BuiltIn settings) {}
}
