package faultline.app;

import faultline.gui.GuiLauncher;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** No command: the window, or where there is no display a run without one. */
final class WindowCommand {

    private static final String DEFAULT_SCENARIO = "office.xml";

    private final CommandOutput output;

    WindowCommand(CommandOutput console) {
        this.output = console;
    }

    /** With the default scenario. */
    int run() throws ScenarioException {
        return openWindow(Optional.empty(), Scenario.loadShipped(DEFAULT_SCENARIO), DEFAULT_SCENARIO);
    }

    /** With a file, which is read first: what is wrong with it is told here, not in a window. */
    int run(Path file) throws ScenarioException {
        return openWindow(Optional.of(file), Scenario.load(file), file.toString());
    }

    /** Opens the window, and closes it when its first picture is there. */
    int measureStartup(List<String> arguments) throws UsageException {
        Arguments given = new Arguments(arguments, List.of());
        if (given.files().size() > 1) {
            throw new UsageException("the window takes one scenario file, not also \""
                    + given.files().get(1) + "\"");
        }
        if (!hasDisplay()) {
            throw new UsageException("--startup-time needs a display, and there is none");
        }
        Optional<Path> file = given.files().isEmpty()
                ? Optional.empty()
                : Optional.of(Arguments.parsePath(given.files().get(0)));
        GuiLauncher.openUntilFirstPaint(
                file, () -> output.println(String.format(Locale.ROOT, "startup_s: %.2f", ProcessAge.seconds())));
        return ExitCode.SUCCESS;
    }

    private int openWindow(Optional<Path> file, Scenario scenario, String name) {
        if (hasDisplay()) {
            GuiLauncher.open(file);
            return ExitCode.SUCCESS;
        }
        output.println("There is no display here: running " + name + " without a window.");
        return new RunCommand(output).run(scenario);
    }

    /** A display that is named but does not answer shows only when it is asked for its screens. */
    private static boolean hasDisplay() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (HeadlessException | AWTError | NoClassDefFoundError e) {
            return false;
        }
    }
}
