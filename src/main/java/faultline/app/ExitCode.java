package faultline.app;

/** What the process ends with. */
final class ExitCode {

    /** Done, and every expectation held. */
    static final int DONE = 0;
    /** Done, but an expectation failed. */
    static final int UNMET = 1;
    /** Bad usage, a bad file, or an output that cannot be written. */
    static final int BAD_INPUT = 2;
    /** The run broke. */
    static final int BROKEN = 3;

    private ExitCode() {
    }
}
