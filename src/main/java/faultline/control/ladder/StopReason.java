package faultline.control.ladder;

/** The reason why the robot has stopped, permanently or until it can trust other sensors. */
enum StopReason {
    /** No sensor that looks to the wall's side is trusted. */
    NO_SENSOR("no trusted sensor on the side of the wall"),
    /** The strategy for a few sensors makes no progress. */
    NO_PROGRESS("no progress"),
    /** The local map does not reach as far as the wall at the wanted distance. */
    TOO_FAR("the wanted distance is too large for the local map");

    private final String condition;

    StopReason(String condition) {
        this.condition = condition;
    }

    /** Returns the condition as telemetry shows it. */
    String condition() {
        return condition;
    }
}
