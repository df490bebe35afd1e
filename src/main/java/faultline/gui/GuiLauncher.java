package faultline.gui;

import faultline.external.ControllerChoice;
import faultline.gui.dialog.ExitNotice;
import faultline.gui.dialog.UncaughtExceptionDialog;
import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.RecoveryStore;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.window.MainWindow;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenarios;
import java.awt.EventQueue;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;

/** Opens the window. */
public final class GuiLauncher {

    private GuiLauncher() {}

    /**
     * Opens the window with the default scenario asynchronously on the event dispatch thread. There must be a display.
     */
    public static void open() {
        open(window -> window.openShipped(ShippedScenarios.DEFAULT), true);
    }

    /** Opens the window asynchronously with a scenario, which is read on another thread. There must be a display. */
    public static void open(Path file, Callable<Scenario> reader) {
        open(window -> window.open(file, reader), false);
    }

    /**
     * Opens the window asynchronously with a scenario, which is read on another thread, and controllers: of the robot,
     * and of a ghost that is shown beside it, null for none. There must be a display.
     */
    public static void open(
            Path file, Callable<Scenario> reader, ControllerChoice controller, ControllerChoice ghostOrNull) {
        open(window -> window.open(file, reader, controller, ghostOrNull), false);
    }

    private static void open(Consumer<MainWindow> scenario, boolean galleryWanted) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtExceptionDialog());
        EventQueue.invokeLater(() -> {
            WindowPreferences preferences = WindowPreferences.forCurrentUser();
            MainWindow window = createWindow(preferences, scenario);
            // One question at a time: the gallery does not cover the recovery prompt.
            window.enableRecovery(RecoveryStore.forCurrentUser(), () -> {
                if (galleryWanted && preferences.get(Preference.GALLERY_SHOWN)) {
                    window.showExamples();
                }
            });
        });
    }

    /**
     * Opens the window with the default scenario and closes it after its first frame, when the listener has been
     * called.
     */
    public static void openUntilFirstPaint(Runnable painted) {
        openUntilFirstPaint(window -> window.openShipped(ShippedScenarios.DEFAULT), () -> {
            painted.run();
            return true;
        });
    }

    /**
     * Opens the window with a scenario, which is read on another thread. Calls {@code painted} on the event dispatch
     * thread after the first frame, and closes the window if that returns true.
     */
    public static void openUntilFirstPaint(Path file, Callable<Scenario> reader, BooleanSupplier painted) {
        openUntilFirstPaint(window -> window.open(file, reader), painted);
    }

    private static void openUntilFirstPaint(Consumer<MainWindow> scenario, BooleanSupplier painted) {
        EventQueue.invokeLater(() -> {
            MainWindow window = createWindow(WindowPreferences.forCurrentUser(), scenario);
            window.onFirstPaint(() -> {
                if (painted.getAsBoolean()) {
                    window.dispose();
                }
            });
        });
    }

    /**
     * Ends the program, which otherwise takes another second or two to find that no window is left. An open window,
     * such as an error message, keeps it running until the window is closed.
     */
    private static void exitUnlessWindowsAreOpen() {
        if (Stream.of(Window.getWindows()).noneMatch(Window::isShowing)) {
            System.exit(0);
        }
    }

    private static MainWindow createWindow(WindowPreferences preferences, Consumer<MainWindow> scenario) {
        Messages.setLanguage(preferences.get(Preference.LANGUAGE));
        SwingMessages.install();
        preferences.get(Preference.TEXT_SIZE).install();
        preferences.get(Preference.THEME).theme().install();
        MainWindow window = new MainWindow(preferences);
        window.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                ExitNotice notice = new ExitNotice(() -> System.exit(0));
                BackgroundTasks.runAfterAll(() -> {
                    notice.close();
                    exitUnlessWindowsAreOpen();
                });
            }
        });
        SystemQuit.install(window);
        // The scenario is read while the window is laid out and painted for the first time.
        scenario.accept(window);
        window.setVisible(true);
        return window;
    }
}
