package faultline.gui;

import faultline.gui.dialog.UncaughtExceptionDialog;
import faultline.gui.document.ControllerSelection;
import faultline.gui.document.RecoveryStore;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.window.MainWindow;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.function.Consumer;

/** Opens the window. */
public final class GuiLauncher {

    /** The scenario that is opened if none is given. */
    private static final String DEFAULT_SCENARIO = "office.xml";

    private GuiLauncher() {}

    /**
     * Opens the window asynchronously on the event dispatch thread. There must be a display.
     *
     * @param file the scenario to open, null for the default one
     */
    public static void open(Path file) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtExceptionDialog());
        EventQueue.invokeLater(() -> openOnEventThread(file, window -> openScenario(window, file)));
    }

    /**
     * Opens the window asynchronously with a scenario and controllers. There must be a display.
     *
     * @param file the scenario to open
     * @param controller drives the robot
     * @param ghostOrNull drives another robot, which is shown beside it; null for none
     */
    public static void open(Path file, ControllerSelection controller, ControllerSelection ghostOrNull) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtExceptionDialog());
        EventQueue.invokeLater(() -> openOnEventThread(file, window -> window.open(file, controller, ghostOrNull)));
    }

    /**
     * Opens the window and closes it after it has painted its first frame.
     *
     * @param file the scenario to open, null for the default one
     * @param painted called on the event dispatch thread after the first frame
     */
    public static void openUntilFirstPaint(Path file, Runnable painted) {
        EventQueue.invokeLater(() -> {
            MainWindow window = createWindow(WindowPreferences.forCurrentUser());
            openScenario(window, file);
            window.onFirstPaint(() -> {
                painted.run();
                window.dispose();
            });
        });
    }

    private static MainWindow createWindow(WindowPreferences preferences) {
        Messages.setLanguage(preferences.language());
        SwingMessages.install();
        preferences.textSize().install();
        preferences.theme().install();
        MainWindow window = new MainWindow(preferences);
        window.setVisible(true);
        return window;
    }

    private static void openScenario(MainWindow window, Path file) {
        if (file == null) {
            window.openShipped(DEFAULT_SCENARIO);
        } else {
            window.open(file);
        }
    }

    private static void openOnEventThread(Path file, Consumer<MainWindow> opener) {
        WindowPreferences preferences = WindowPreferences.forCurrentUser();
        MainWindow window = createWindow(preferences);
        opener.accept(window);
        // One question at a time: the gallery does not cover the recovery prompt.
        window.enableRecovery(RecoveryStore.forCurrentUser(), () -> {
            if (file == null && preferences.isGalleryShownAtStart()) {
                window.showExamples();
            }
        });
    }
}
