package faultline.gui.text;

import javax.swing.UIManager;

/** Puts our words in the place of those that Swing's own dialogs would take from the machine's language. */
public final class SwingTexts {

    private static final String PREFIX = "swing.";

    private SwingTexts() {
    }

    /** Installs every text whose key begins with {@code swing.}, for dialogs made from now on. */
    public static void install() {
        Texts.keys().filter(key -> key.startsWith(PREFIX)).forEach(key -> UIManager.put(key.substring(PREFIX.length()), Texts.text(key)));
    }
}
