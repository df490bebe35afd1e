package faultline.gui;

import faultline.gui.document.Recovery;
import faultline.gui.text.SwingTexts;
import faultline.gui.text.Texts;
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

    /**
     * Opens the window, and closes it again when it has painted its first frame.
     *
     * @param file the scenario to open, empty for the default one
     * @param painted told when that was, on the event dispatch thread
     */
    public static void openBriefly(Optional<Path> file, Runnable painted) {
        EventQueue.invokeLater(() -> {
            SimulatorFrame window = show(WindowMemory.ofUser(), file);
            window.whenPainted(() -> {
                painted.run();
                window.dispose();
            });
        });
    }

    private static SimulatorFrame show(WindowMemory memory, Optional<Path> file) {
        Texts.speak(memory.language());
        SwingTexts.install();
        memory.textSize().install();
        memory.theme().install();
        SimulatorFrame window = new SimulatorFrame(memory);
        window.setVisible(true);
        file.ifPresentOrElse(window::open, () -> window.openShipped(DEFAULT));
        return window;
    }

    private static void openNow(Optional<Path> file) {
        WindowMemory memory = WindowMemory.ofUser();
        SimulatorFrame window = show(memory, file);
        // One question at a time: the examples are not shown in front of what a crash has left.
        window.recover(Recovery.ofUser(), () -> {
            if (file.isEmpty() && memory.galleryAtStart()) {
                window.showExamples();
            }
        });
    }
}
