package faultline.gui.text;

import javax.swing.UIManager;

/** Puts our words in the place of those that Swing's own dialogs would take from the machine's language. */
public final class SwingMessages {

    private static final String PREFIX = "swing.";

    private SwingMessages() {}

    /** Installs every text whose key begins with {@code swing.}, for dialogs made from now on. */
    public static void install() {
        Messages.keys()
                .filter(key -> key.startsWith(PREFIX))
                .forEach(key -> UIManager.put(key.substring(PREFIX.length()), Messages.get(key)));
    }
}
