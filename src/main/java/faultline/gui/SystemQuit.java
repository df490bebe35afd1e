package faultline.gui;

import faultline.gui.document.ModalDialogs;
import java.awt.Desktop;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.desktop.QuitEvent;
import java.awt.desktop.QuitHandler;
import java.awt.desktop.QuitResponse;
import java.awt.event.WindowEvent;

/**
 * Answers <i>Quit</i> in the menu that macOS gives to each program, and its key Cmd+Q, which otherwise end the program
 * without a question about unsaved changes. On the event dispatch thread.
 */
final class SystemQuit implements QuitHandler {

    private final Runnable close;

    /** Creates a handler that calls what closes the window, unless the user does not want that. */
    SystemQuit(Runnable close) {
        this.close = close;
    }

    /** Installs a handler that closes a window. Only macOS has such a menu. */
    static void install(Window window) {
        // Elsewhere, the question whether there is such a menu would load the libraries of the desktop.
        if (System.getProperty("os.name").startsWith("Mac")
                && Desktop.getDesktop().isSupported(Desktop.Action.APP_QUIT_HANDLER)) {
            Desktop.getDesktop()
                    .setQuitHandler(new SystemQuit(
                            () -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING))));
        }
    }

    /** The program ends with its window, so the request itself is refused. */
    @Override
    public void handleQuitRequestWith(QuitEvent event, QuitResponse response) {
        response.cancelQuit();
        if (ModalDialogs.isAnyOpen()) {
            Toolkit.getDefaultToolkit().beep();
        } else {
            close.run();
        }
    }
}
