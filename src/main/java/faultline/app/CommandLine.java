package faultline.app;

import faultline.engine.RunFailedException;
import faultline.external.ControllerStartException;
import faultline.io.DidYouMean;
import faultline.io.MessageText;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Finds the command that the arguments name, runs it, and turns a failure into one line and an exit code. */
final class CommandLine {

    /** Runs a command with the arguments after its name. */
    private interface Handler {
        int run(List<String> arguments) throws UsageException, ScenarioException, IOException;
    }

    /** The option that shows all commands, also after one of them. */
    private static final String HELP = "--help";

    /** The implementations of the commands; the classes of commands that are not used are not loaded. */
    private final Map<String, Handler> handlers = new LinkedHashMap<>();

    private final CommandOutput output;

    CommandLine(CommandOutput output) {
        this.output = output;
        handlers.put("run", arguments -> new RunCommand(output).run(arguments));
        handlers.put("compare", arguments -> new CompareCommand(output).run(arguments));
        handlers.put("check", arguments -> new CheckCommand(output).run(arguments));
        handlers.put("campaign", arguments -> new CampaignCommand(output).run(arguments));
        handlers.put("merge", arguments -> new CampaignCommand(output).merge(arguments));
        handlers.put("report", arguments -> new ReportCommand(output).run(arguments));
        handlers.put("figures", arguments -> new FiguresCommand(output).run(arguments));
        handlers.put("serve", arguments -> new ProtocolCommands(output).serve(arguments));
        handlers.put("controller", arguments -> new ProtocolCommands(output).controller(arguments));
        handlers.put("import", arguments -> new ImportCommand(output).run(arguments));
        handlers.put(HELP, arguments -> println(HelpText.help()));
        handlers.put("--version", arguments -> println(HelpText.version()));
        handlers.put("--window", arguments -> new WindowCommand(output).runWithDialogs(arguments));
        handlers.put("--startup-time", arguments -> new WindowCommand(output).measureStartup(arguments));
    }

    /** Runs a command, given the arguments of the process, and returns its {@link ExitCode}. */
    int run(String... args) {
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
            output.printError(e);
            return ExitCode.BAD_INPUT;
        } catch (UncheckedIOException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + describe(e.getCause()));
        } catch (IOException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + describe(e));
        } catch (ControllerStartException e) {
            return reportError(ExitCode.BAD_INPUT, "faultline: " + e.getMessage());
        } catch (RunFailedException e) {
            return reportError(ExitCode.RUN_FAILED, "faultline: the run broke: " + e.getMessage());
        } catch (RuntimeException | Error e) {
            return reportError(ExitCode.RUN_FAILED, "faultline: the program failed, which is its own fault: " + e);
        }
    }

    /** Returns a sentence; the messages of the file system are often the name of a file alone. */
    private static String describe(IOException e) {
        if (e instanceof FileSystemException file && file.getFile() != null) {
            return file.getFile() + ": " + reason(file);
        }
        return e.getMessage();
    }

    private static String reason(FileSystemException e) {
        if (e instanceof NoSuchFileException) {
            return "there is no such file";
        }
        if (e instanceof AccessDeniedException) {
            return "access is denied";
        }
        if (e instanceof FileAlreadyExistsException) {
            return Files.isSymbolicLink(Path.of(e.getFile()))
                    ? "this link leads to no folder; expected a folder"
                    : "this is a file; expected a folder";
        }
        return e.getReason() == null ? "the file cannot be used" : e.getReason();
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
        if (handlers.containsKey(first)) {
            if (args.contains(HELP)) {
                return println(HelpText.help());
            }
            return handlers.get(first).run(args.subList(1, args.size()));
        }
        if (!looksLikeFile(first)) {
            throw new UsageException("there is no command " + MessageText.quoted(first) + "; expected "
                    + String.join(", ", handlers.keySet()) + " or a scenario file"
                    + DidYouMean.hint(first, handlers.keySet()));
        }
        return new WindowCommand(output).run(args);
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
