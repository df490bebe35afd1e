package faultline.app;

import java.io.PrintStream;
import java.nio.charset.Charset;
import java.util.List;
import java.util.Set;

/** The entry point of the program. */
public final class Main {

    private static final Set<String> PICTURE_COMMANDS = Set.of("run", "compare", "figures");

    private Main() {}

    /**
     * Returns the standard output, or standard error, of controllers in Java. Both go to standard error, because
     * standard output carries the results or the protocol. A controller that closes or locks them does not keep the
     * program from writing its messages.
     */
    private static PrintStream printsOfControllers(PrintStream err) {
        String encoding = System.getProperty("stderr.encoding", System.getProperty("sun.stderr.encoding"));
        Charset charset = encoding == null ? Charset.defaultCharset() : Charset.forName(encoding);
        return new PrintStream(err, true, charset) {
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
     * controller in Java has left a thread. If the command opened a window, the process continues until that is closed.
     */
    public static void main(String[] args) {
        if (paintsWithoutWindow(args)) {
            System.setProperty("java.awt.headless", "true");
        }
        CommandOutput output = new CommandOutput(System.out, CommandOutput.STANDARD_ERROR);
        System.setOut(printsOfControllers(output.err()));
        System.setErr(printsOfControllers(output.err()));
        int code = new CommandLine(output).run(args);
        boolean windowOpened =
                code == ExitCode.SUCCESS && CommandLine.mayOpenWindow(args) && WindowCommand.hasDisplay();
        if (!windowOpened) {
            System.exit(code);
        }
    }
}
