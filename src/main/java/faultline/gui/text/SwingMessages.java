package faultline.gui.text;

import javax.swing.UIManager;

/** Replaces the texts of Swing's own dialogs, which would follow the system's language. */
public final class SwingMessages {

    private static final String PREFIX = "swing.";

    private SwingMessages() {}

    /** Installs every text whose key begins with {@code swing.} for dialogs created afterwards. */
    public static void install() {
        Messages.keys()
                .filter(key -> key.startsWith(PREFIX))
                .forEach(key -> UIManager.put(key.substring(PREFIX.length()), Messages.get(key)));
    }
}
