package faultline.app;

/** What the process ends with. */
final class ExitCode {

    /** Done, and every expectation held. */
    static final int SUCCESS = 0;
    /** Done, but an expectation failed. */
    static final int EXPECTATION_FAILED = 1;
    /** Bad usage, a bad file, or an output that cannot be written. */
    static final int BAD_INPUT = 2;
    /** The run broke. */
    static final int RUN_FAILED = 3;

    private ExitCode() {}
}
