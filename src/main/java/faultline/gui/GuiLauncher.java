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

    /** The scenario that is open where none is asked for. */
    private static final String DEFAULT_SCENARIO = "office.xml";

    private GuiLauncher() {}

    /**
     * Opens the window, soon, on the event dispatch thread; there must be a display.
     *
     * @param file the scenario to open, empty for the default one
     */
    public static void open(Optional<Path> file) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtExceptionDialog());
        EventQueue.invokeLater(() -> openOnEventThread(file));
    }

    /**
     * Opens the window, and closes it again when it has painted its first frame.
     *
     * @param file the scenario to open, empty for the default one
     * @param painted told when that was, on the event dispatch thread
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

    private static MainWindow createWindow(WindowPreferences memory, Optional<Path> file) {
        Messages.setLanguage(memory.language());
        SwingMessages.install();
        memory.textSize().install();
        memory.theme().install();
        MainWindow window = new MainWindow(memory);
        window.setVisible(true);
        file.ifPresentOrElse(window::open, () -> window.openShipped(DEFAULT_SCENARIO));
        return window;
    }

    private static void openOnEventThread(Optional<Path> file) {
        WindowPreferences memory = WindowPreferences.forCurrentUser();
        MainWindow window = createWindow(memory, file);
        // One question at a time: the examples are not shown in front of what a crash has left.
        window.enableRecovery(RecoveryStore.forCurrentUser(), () -> {
            if (file.isEmpty() && memory.isGalleryShownAtStart()) {
                window.showExamples();
            }
        });
    }
}
