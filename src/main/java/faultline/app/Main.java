package faultline.app;

/** Where the program starts. */
public final class Main {

    private Main() {}

    /**
     * Runs one command. The process ends with its exit code; where that is 0 it may go on until the window is closed.
     *
     * @param args as {@code --help} tells
     */
    public static void main(String[] args) {
        if (args.length > 0 && args[0].equals("run")) {
            // A picture needs no display, and must not fail for one that does not answer.
            System.setProperty("java.awt.headless", "true");
        }
        int code = new CommandLine(new CommandOutput(System.out, System.err)).run(args);
        if (code != ExitCode.SUCCESS) {
            System.exit(code);
        }
    }
}
