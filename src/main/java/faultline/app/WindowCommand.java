package faultline.app;

import faultline.external.ControllerChoice;
import faultline.external.ControllerJars;
import faultline.gui.GuiLauncher;
import faultline.io.MessageText;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenarios;
import faultline.scenario.xml.ScenarioException;
import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;

/** The command without a name: opens the window, or runs without one if there is no display. */
final class WindowCommand {

    /** The option that names the controller of a robot beside the one that is driven. */
    static final String GHOST_OPTION = "--ghost-controller";

    private static final List<String> OPTION_NAMES = List.of("--controller", GHOST_OPTION, "--jar");

    /** The time after which a window is made for a file that is still being read. */
    private static final long MILLIS_BEFORE_WINDOW = 250;

    /** The size from which a file is not waited for at all, bytes: it takes longer than that. */
    private static final long LARGE_FILE = 1 << 20;

    private final CommandOutput output;

    WindowCommand(CommandOutput output) {
        this.output = output;
    }

    /** Opens the default scenario. */
    int run() throws UsageException, ScenarioException {
        if (hasDisplay()) {
            GuiLauncher.open();
            return ExitCode.SUCCESS;
        }
        return runWithoutWindow(Scenario.loadShipped(ShippedScenarios.DEFAULT), ShippedScenarios.DEFAULT);
    }

    /**
     * Opens a file, with other controllers if the arguments name any. Its problems are reported here and not in a
     * window.
     */
    int run(List<String> given) throws UsageException, ScenarioException {
        Arguments arguments = new Arguments(given, OPTION_NAMES);
        requireOneFile(arguments);
        Path file = Arguments.parsePath(arguments.files().get(0));
        if (given.size() == 1) {
            return run(file);
        }
        Optional<String> controller = arguments.value("--controller");
        Optional<String> ghost = arguments.value(GHOST_OPTION);
        List<Path> jars = ControllerOptions.parse(arguments, true).jars();
        ControllerChoice chosen = controller.isEmpty()
                ? ControllerChoice.SCENARIO
                : ControllerOptions.choice("--controller", controller.get(), jars);
        ControllerChoice ghostChosen =
                ghost.isEmpty() ? null : ControllerOptions.choice(GHOST_OPTION, ghost.get(), jars);
        // The file may name a controller of the jar. The threads of the window begin after this.
        ControllerJars.use(jars);
        if (controller.isEmpty() && ghost.isEmpty()) {
            return run(file);
        }
        Scenario scenario = Scenario.load(file);
        requireDisplay(controller.isPresent() ? "--controller" : GHOST_OPTION);
        GuiLauncher.open(file, () -> scenario, chosen, ghostChosen);
        return ExitCode.SUCCESS;
    }

    /** Throws an exception if there is no display for something that needs one. */
    static void requireDisplay(String what) throws UsageException {
        if (!hasDisplay()) {
            throw new UsageException(what + " needs a display here, and there is none");
        }
    }

    private int run(Path file) throws UsageException, ScenarioException {
        Future<Scenario> reading = startReading(file);
        boolean display = hasDisplay();
        if (!display) {
            return runWithoutWindow(await(reading, Long.MAX_VALUE).orElseThrow(), file.toString());
        }
        openWhileReading(file, reading, scenario -> GuiLauncher.open(file, scenario));
        return ExitCode.SUCCESS;
    }

    /**
     * Opens a window for a file. A large one is read while the window is made; if it has problems, the caller closes
     * the window by ending the process.
     */
    private static void openWhileReading(Path file, Future<Scenario> reading, Consumer<Callable<Scenario>> window)
            throws ScenarioException {
        await(reading, file.toFile().length() < LARGE_FILE ? MILLIS_BEFORE_WINDOW : 0);
        window.accept(() -> await(reading, Long.MAX_VALUE).orElseThrow());
        await(reading, Long.MAX_VALUE);
    }

    /**
     * Opens the window from a desktop, which shows no standard error: problems of the file are shown in the window. A
     * display that is missing is reported here.
     */
    int runWithDialogs(List<String> given) throws UsageException {
        Arguments arguments = new Arguments(given, List.of());
        requireOneFile(arguments);
        requireDisplay("--window");
        if (arguments.files().isEmpty()) {
            GuiLauncher.open();
        } else {
            Path file = Arguments.parsePath(arguments.files().get(0));
            GuiLauncher.open(file, () -> Scenario.load(file));
        }
        return ExitCode.SUCCESS;
    }

    private static void requireOneFile(Arguments arguments) throws UsageException {
        if (arguments.files().size() > 1) {
            throw new UsageException("the window takes one scenario file, not also "
                    + MessageText.quoted(arguments.files().get(1)));
        }
    }

    private static Future<Scenario> startReading(Path file) {
        FutureTask<Scenario> reading = new FutureTask<>(() -> Scenario.load(file));
        Thread reader = new Thread(reading, "faultline-reader");
        reader.setDaemon(true);
        reader.start();
        return reading;
    }

    /** Waits for a scenario; empty if it has not been read within the given time, milliseconds. */
    private static Optional<Scenario> await(Future<Scenario> reading, long millis) throws ScenarioException {
        try {
            return Optional.of(reading.get(millis, TimeUnit.MILLISECONDS));
        } catch (TimeoutException e) {
            return Optional.empty();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof ScenarioException bad) {
                throw bad;
            }
            throw new IllegalStateException(e.getCause());
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Opens the window and closes it after its first frame. */
    int measureStartup(List<String> arguments) throws UsageException, ScenarioException {
        Arguments parsed = new Arguments(arguments, List.of());
        requireOneFile(parsed);
        requireDisplay("--startup-time");
        Runnable report = () -> output.println(String.format(Locale.ROOT, "startup_s: %.2f", ProcessAge.seconds()));
        if (parsed.files().isEmpty()) {
            GuiLauncher.openUntilFirstPaint(report);
        } else {
            Path file = Arguments.parsePath(parsed.files().get(0));
            Future<Scenario> reading = startReading(file);
            openWhileReading(
                    file,
                    reading,
                    scenario -> GuiLauncher.openUntilFirstPaint(file, scenario, () -> reportIfRead(reading, report)));
        }
        return ExitCode.SUCCESS;
    }

    /** Returns whether a scenario has been read and reported. The first frame of a bad file is that of an example. */
    private static boolean reportIfRead(Future<Scenario> reading, Runnable report) {
        try {
            await(reading, Long.MAX_VALUE);
            report.run();
            return true;
        } catch (ScenarioException bad) {
            return false;
        }
    }

    private int runWithoutWindow(Scenario scenario, String name) throws UsageException {
        RunCommand.requireController(scenario, false);
        output.println("There is no display here: running " + name + " without a window.");
        ExitGuard guard = ExitGuard.start(output);
        try (guard) {
            return new RunCommand(output).run(scenario);
        }
    }

    /**
     * Returns whether there is a display. One that is configured but does not answer fails only when its screens are
     * listed.
     */
    static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | NoClassDefFoundError e) {
            return false;
        }
    }
}
