package faultline.app;

import java.io.PrintStream;
import java.util.List;

/** The entry point of the program. */
public final class Main {

    private Main() {}

    /**
     * Returns the standard output of controllers in Java. It goes to standard error, because standard output carries
     * the results or the protocol, and stays open if a controller closes it.
     */
    private static PrintStream printsOfControllers(PrintStream err) {
        return new PrintStream(err, true) {
            @Override
            public void close() {
                flush();
            }
        };
    }

    /**
     * Runs one command as described by {@code --help}. The process ends with the command's exit code; if that is 0, the
     * process may continue until the window is closed.
     */
    public static void main(String[] args) {
        if (args.length > 0
                && (args[0].equals("run") || args[0].equals("compare"))
                && !List.of(args).contains("--open")) {
            // Image output needs no display and must not fail if the configured one does not answer.
            System.setProperty("java.awt.headless", "true");
        }
        CommandOutput output = new CommandOutput(System.out, System.err);
        System.setOut(printsOfControllers(System.err));
        int code = new CommandLine(output).run(args);
        if (code != ExitCode.SUCCESS) {
            System.exit(code);
        }
    }
}
