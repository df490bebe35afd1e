package faultline.gui.document;

import java.awt.Dialog;
import java.awt.Window;
import java.util.stream.Stream;

/** Finds dialogs that have to be answered first. */
public final class ModalDialogs {

    private ModalDialogs() {}

    /** Returns whether a dialog has to be answered before anything else is asked. */
    public static boolean isAnyOpen() {
        return Stream.of(Window.getWindows())
                .anyMatch(window -> window instanceof Dialog dialog && dialog.isModal() && dialog.isShowing());
    }
}
