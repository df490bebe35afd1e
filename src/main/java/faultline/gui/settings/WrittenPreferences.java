package faultline.gui.settings;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;
import javax.swing.Timer;

/**
 * A store in a node of the system's preferences, which is written shortly after a change. At exit little is then left
 * to write; the first writing takes about a second, because it loads the XML classes of the platform.
 */
final class WrittenPreferences {

    private static final Logger LOG = Logger.getLogger(WrittenPreferences.class.getName());
    private static final int MILLIS_BEFORE_WRITING = 2000;

    private final Preferences node;
    private final Timer timer = new Timer(MILLIS_BEFORE_WRITING, event -> startWriting());

    private WrittenPreferences(Preferences node) {
        this.node = node;
        timer.setRepeats(false);
    }

    /** Returns a store of the texts of a node, whose texts are set on the event dispatch thread. */
    static PreferenceStore storeOf(Preferences node) {
        WrittenPreferences written = new WrittenPreferences(node);
        return new PreferenceStore(key -> node.get(key, ""), written::put);
    }

    private void put(String key, String text) {
        if (!text.equals(node.get(key, ""))) {
            node.put(key, text);
            timer.restart();
        }
    }

    private void startWriting() {
        Thread writer = new Thread(this::write, "faultline-preferences");
        writer.setDaemon(true);
        writer.start();
    }

    private void write() {
        try {
            node.flush();
        } catch (BackingStoreException unavailable) {
            LOG.log(Level.FINE, "the preferences cannot be written", unavailable);
        }
    }
}
