package faultline.app;

import faultline.engine.RunFailedException;
import faultline.external.ControllerStartException;
import faultline.io.DidYouMean;
import faultline.io.MessageException;
import faultline.io.MessageText;
import faultline.io.ProgramVersion;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** Finds the command that the arguments name, runs it, and turns a failure into one line and an exit code. */
final class CommandLine {

    /** The option that shows all commands or, after a command, that one. */
    static final String HELP = "--help";

    /** Short for {@link #HELP}. */
    static final String SHORT_HELP = "-h";

    /** The first arguments that show help. */
    private static final List<String> HELP_WORDS = List.of(HELP, SHORT_HELP, "help");

    private static final List<String> COMMANDS = List.of(
            "run",
            "compare",
            "check",
            "campaign",
            "merge",
            "report",
            "figures",
            "serve",
            "controller",
            "import",
            HELP,
            "--version",
            "--window",
            "--startup-time");

    private static final List<String> WINDOW_COMMANDS = List.of("--window", "--startup-time");

    private static final String OUT_OF_MEMORY = "faultline: there is not enough memory";
    /**
     * How often the report is tried. An allocation that fails collects garbage first, so one try takes milliseconds.
     */
    private static final int MAX_REPORTS = 1000;
    /**
     * The class of errors that {@link #run} catches, resolved when the program starts: without memory, the virtual
     * machine cannot resolve the types of the clauses that catch an exception, and skips them all.
     */
    private static final Class<?> MEMORY_ERROR = OutOfMemoryError.class;

    private final CommandOutput output;

    CommandLine(CommandOutput output) {
        this.output = output;
    }

    /** Returns whether a command, given the arguments of the process, may open a window if there is a display. */
    static boolean mayOpenWindow(String... args) {
        return args.length == 0
                || WINDOW_COMMANDS.contains(args[0])
                || !COMMANDS.contains(args[0]) && !HELP_WORDS.contains(args[0])
                || List.of(args).contains("--open");
    }

    /** Runs a command, given the arguments of the process, and returns its {@link ExitCode}. */
    int run(String... args) {
        try {
            return runWithOutput(args);
        } catch (OutOfMemoryError e) {
            return reportOutOfMemory();
        }
    }

    private int runWithOutput(String... args) {
        int code = runReportingErrors(List.of(args));
        if (!output.isWritten()) {
            output.printError("faultline: standard output cannot be written");
            return code == ExitCode.SUCCESS ? ExitCode.BAD_INPUT : code;
        }
        return code;
    }

    private int runReportingErrors(List<String> args) {
        try {
            return dispatch(args);
        } catch (UsageException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + e.getMessage() + " (see faultline --help)");
        } catch (ScenarioException e) {
            return reportProblems(e);
        } catch (UncheckedIOException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + describe(e.getCause()));
        } catch (IOException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + describe(e));
        } catch (ControllerStartException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            return reportFailure(e);
        }
    }

    /** Reports the problems of a file, and the options that take it if it is a program. */
    private int reportProblems(ScenarioException e) {
        output.printError(e);
        String file = e.problems().get(0).file().toLowerCase(Locale.ROOT);
        if (file.endsWith(".py") || file.endsWith(".jar")) {
            output.printError(
                    "faultline: a program drives the robot by run SCENARIO --controller COMMAND, a jar by --jar");
        }
        return ExitCode.BAD_INPUT;
    }

    private int reportFailure(Throwable e) {
        boolean ofController = e instanceof RunFailedException failed && failed.isOfController();
        if (!ofController && MEMORY_ERROR.isInstance(rootCause(e))) {
            return reportOutOfMemory();
        }
        return reportError(
                ExitCode.RUN_FAILED,
                e instanceof RunFailedException
                        ? "faultline: the run broke: " + e.getMessage()
                        : "faultline: internal error: " + rootCause(e));
    }

    /** Reports that memory is exhausted, as soon as the other threads have freed enough of it for the report. */
    private int reportOutOfMemory() {
        for (int attempt = 1; attempt < MAX_REPORTS; attempt++) {
            try {
                return reportError(ExitCode.RUN_FAILED, OUT_OF_MEMORY);
            } catch (OutOfMemoryError e) {
                // Another thread may free memory before the next try.
            }
        }
        return reportError(ExitCode.RUN_FAILED, OUT_OF_MEMORY);
    }

    /** Returns what a failure of the JDK goes back to: it says more than the exceptions that are made of it. */
    static Throwable rootCause(Throwable e) {
        Set<Throwable> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        Throwable root = e;
        // A controller's exceptions may be causes of each other.
        while (root.getCause() != null && seen.add(root)) {
            root = root.getCause();
        }
        return root;
    }

    /** Returns a sentence, because the messages of the file system are often only the name of a file. */
    private static String describe(IOException e) {
        if (e instanceof FileSystemException file && file.getFile() != null) {
            return file.getFile() + ": " + FileProblem.reason(file);
        }
        return e.getMessage();
    }

    /** Returns the line that reports why a file cannot be written. */
    static String problem(Path file, MessageException reason) {
        return "faultline: " + MessageText.oneLine(file.toString()) + ": " + reason.reason();
    }

    private int reportError(int code, String line) {
        output.printError(line);
        return code;
    }

    private int dispatch(List<String> args) throws UsageException, ScenarioException, IOException {
        if (args.isEmpty()) {
            return new WindowCommand(output).run();
        }
        String first = args.get(0);
        if (HELP_WORDS.contains(first)) {
            return println(help(first, args.subList(1, args.size())));
        }
        if (COMMANDS.contains(first)) {
            try {
                return runGuarded(first, args.subList(1, args.size()));
            } catch (HelpRequest e) {
                return println(HelpText.help(first));
            }
        }
        if (!looksLikeFile(first)) {
            throw new UsageException("there is no command " + MessageText.quoted(first) + "; expected "
                    + String.join(", ", COMMANDS) + " or a scenario file" + hint(first));
        }
        return new WindowCommand(output).run(args);
    }

    /** Returns the hint for a first argument that is no command. */
    private static String hint(String argument) {
        boolean option = argument.startsWith("--");
        String hint = DidYouMean.hint(
                argument,
                COMMANDS.stream()
                        .filter(command -> command.startsWith("--") == option)
                        .toList());
        return hint.isEmpty() && option ? "; options come last" : hint;
    }

    /** Returns the help of a command, or of all if none is named, for a word that asks for it. */
    private static String help(String word, List<String> commands) throws UsageException {
        if (commands.isEmpty()) {
            return HelpText.help();
        }
        String command = String.join(" ", commands);
        if (!COMMANDS.contains(command)) {
            throw new UsageException(word + " takes the name of one command, not " + MessageText.quoted(command)
                    + DidYouMean.hint(command, COMMANDS));
        }
        return HelpText.help(command);
    }

    private int printVersion(List<String> arguments) throws UsageException {
        HelpRequest.throwIfIn(arguments, List.of());
        if (!arguments.isEmpty()) {
            throw new UsageException("--version takes nothing, not " + MessageText.quoted(String.join(" ", arguments)));
        }
        return println(ProgramVersion.text());
    }

    /** Runs a command; if it has no window, which may end the process, a controller in Java must not end it. */
    private int runGuarded(String command, List<String> arguments)
            throws UsageException, ScenarioException, IOException {
        if (WINDOW_COMMANDS.contains(command)) {
            return run(command, arguments);
        }
        ExitGuard guard = ExitGuard.start(output);
        try (guard) {
            return run(command, arguments);
        }
    }

    /** Runs a command with the arguments after its name. The classes of the other commands are not loaded. */
    private int run(String command, List<String> arguments) throws UsageException, ScenarioException, IOException {
        return switch (command) {
            case "run" -> new RunCommand(output).run(arguments);
            case "compare" -> new CompareCommand(output).run(arguments);
            case "check" -> new CheckCommand(output).run(arguments);
            case "campaign" -> new CampaignCommand(output).run(arguments);
            case "merge" -> new CampaignCommand(output).merge(arguments);
            case "report" -> new ReportCommand(output).run(arguments);
            case "figures" -> new FiguresCommand(output).run(arguments);
            case "serve" -> new ProtocolCommands(output).serve(arguments);
            case "controller" -> new ProtocolCommands(output).controller(arguments);
            case "import" -> new ImportCommand(output).run(arguments);
            case "--version" -> printVersion(arguments);
            case "--window" -> new WindowCommand(output).runWithDialogs(arguments);
            case "--startup-time" -> new WindowCommand(output).measureStartup(arguments);
            default -> throw new IllegalArgumentException("no command: " + command);
        };
    }

    private static boolean looksLikeFile(String argument) throws UsageException {
        return !argument.startsWith("-")
                && (argument.endsWith(".xml")
                        || argument.endsWith(".faultline")
                        || Files.exists(Arguments.parsePath(argument)));
    }

    private int println(String text) {
        text.lines().forEach(output::println);
        return ExitCode.SUCCESS;
    }
}
