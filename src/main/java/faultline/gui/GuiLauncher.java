package faultline.gui;

import faultline.gui.document.Recovery;
import faultline.gui.window.SimulatorFrame;
import faultline.gui.window.UncaughtDialog;
import faultline.gui.window.WindowMemory;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.Optional;

/** Opens the window. */
public final class GuiLauncher {

    /** The scenario that is open where none is asked for. */
    private static final String DEFAULT = "office.xml";

    private GuiLauncher() {
    }

    /**
     * Opens the window, soon, on the event dispatch thread; there must be a display.
     *
     * @param file the scenario to open, empty for the default one
     */
    public static void open(Optional<Path> file) {
        Thread.setDefaultUncaughtExceptionHandler(new UncaughtDialog());
        EventQueue.invokeLater(() -> openNow(file));
    }

    private static void openNow(Optional<Path> file) {
        WindowMemory memory = WindowMemory.ofUser();
        memory.theme().install();
        SimulatorFrame window = new SimulatorFrame(memory);
        window.setVisible(true);
        file.ifPresentOrElse(window::open, () -> window.openShipped(DEFAULT));
        if (file.isEmpty() && memory.galleryAtStart()) {
            window.showExamples();
        }
        window.recover(Recovery.ofUser());
    }
}
