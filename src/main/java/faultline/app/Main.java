package faultline.app;

import java.io.PrintStream;
import java.util.List;
import java.util.Set;

/** The entry point of the program. */
public final class Main {

    private static final Set<String> PICTURE_COMMANDS = Set.of("run", "compare", "figures");

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
     * Returns whether a command may paint pictures but opens no window, so that it must not fail if the display that is
     * configured does not answer.
     */
    static boolean paintsWithoutWindow(String... args) {
        return args.length > 0
                && PICTURE_COMMANDS.contains(args[0])
                && !List.of(args).contains("--open");
    }

    /**
     * Runs one command as described by {@code --help}. The process ends with the command's exit code, even if a
     * controller in Java has left a thread; if a window was opened, it continues until that is closed.
     */
    public static void main(String[] args) {
        if (paintsWithoutWindow(args)) {
            System.setProperty("java.awt.headless", "true");
        }
        CommandOutput output = new CommandOutput(System.out, System.err);
        System.setOut(printsOfControllers(System.err));
        int code = new CommandLine(output).run(args);
        if (code != ExitCode.SUCCESS || !CommandLine.mayOpenWindow(args)) {
            System.exit(code);
        }
    }
}
