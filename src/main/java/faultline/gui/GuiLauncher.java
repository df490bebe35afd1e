package faultline.gui;

import java.nio.file.Path;
import java.util.Optional;

/** Opens the window. */
public final class GuiLauncher {

    private GuiLauncher() {
    }

    /**
     * Opens the window and returns; the program ends when the window is closed.
     *
     * @param file the scenario to show, the default one where empty
     */
    public static void open(Optional<Path> file) {
        throw new UnsupportedOperationException("the window is not built yet");
    }
}
