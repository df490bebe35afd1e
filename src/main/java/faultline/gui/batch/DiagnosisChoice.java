package faultline.gui.batch;

/** Whether the controller of a batch watches its sensors. */
enum DiagnosisChoice {
    /** As in the scenario. */
    SCENARIO(""),
    /** In every run. */
    ON("on"),
    /** In no run. */
    OFF("off"),
    /** Every run is made twice, with and without. */
    BOTH("on off");

    private final String setting;

    DiagnosisChoice(String setting) {
        this.setting = setting;
    }

    /** Returns the values of the attribute in a plan; empty if the scenario keeps its own. */
    String setting() {
        return setting;
    }

    /**
     * Returns whether the controller of a run watches its sensors although a scenario wants otherwise, or vice versa.
     */
    boolean differsFrom(boolean watched) {
        return this == BOTH || this == (watched ? OFF : ON);
    }
}
