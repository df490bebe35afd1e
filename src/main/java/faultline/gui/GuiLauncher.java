package faultline.gui;

import faultline.gui.dialog.UncaughtExceptionDialog;
import faultline.gui.document.RecoveryStore;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.window.MainWindow;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.Optional;

/** Opens the window. */
public final class GuiLauncher {

    /** The scenario that is opened if none is given. */
    private static final String DEFAULT_SCENARIO = "office.xml";

    private GuiLauncher() {}

    /**
     * Opens the window asynchronously on the event dispatch thread. There must be a display.
     *
     * @param file the scenario to open, empty for the default one
     */
    public static void open(Optional<Path> file) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtExceptionDialog());
        EventQueue.invokeLater(() -> openOnEventThread(file));
    }

    /**
     * Opens the window and closes it after it has painted its first frame.
     *
     * @param file the scenario to open, empty for the default one
     * @param painted called on the event dispatch thread after the first frame
     */
    public static void openUntilFirstPaint(Optional<Path> file, Runnable painted) {
        EventQueue.invokeLater(() -> {
            MainWindow window = createWindow(WindowPreferences.forCurrentUser(), file);
            window.onFirstPaint(() -> {
                painted.run();
                window.dispose();
            });
        });
    }

    private static MainWindow createWindow(WindowPreferences preferences, Optional<Path> file) {
        Messages.setLanguage(preferences.language());
        SwingMessages.install();
        preferences.textSize().install();
        preferences.theme().install();
        MainWindow window = new MainWindow(preferences);
        window.setVisible(true);
        file.ifPresentOrElse(window::open, () -> window.openShipped(DEFAULT_SCENARIO));
        return window;
    }

    private static void openOnEventThread(Optional<Path> file) {
        WindowPreferences preferences = WindowPreferences.forCurrentUser();
        MainWindow window = createWindow(preferences, file);
        // One question at a time: the gallery does not cover the recovery prompt.
        window.enableRecovery(RecoveryStore.forCurrentUser(), () -> {
            if (file.isEmpty() && preferences.isGalleryShownAtStart()) {
                window.showExamples();
            }
        });
    }
}
