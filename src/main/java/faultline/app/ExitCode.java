package faultline.app;

/** The exit codes of the process. */
final class ExitCode {

    /** The command succeeded, and all expectations hold. */
    static final int SUCCESS = 0;
    /** The run finished, but an expectation failed. */
    static final int EXPECTATION_FAILED = 1;
    /** The usage or a file is invalid, or an output cannot be written. */
    static final int BAD_INPUT = 2;
    /** A run broke, or the program failed with an internal error. */
    static final int RUN_FAILED = 3;

    private ExitCode() {}
}
