package faultline.gui.settings;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import faultline.io.ShutdownHooks;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;
import javax.swing.Timer;

/**
 * A store in a node of the system's preferences. The texts are read once, at the start. A change is kept in memory and
 * passed to the node by another thread, because a node that is being written to disk holds a lock, for 0.1 to 0.2
 * seconds. The node is written to disk shortly after a change, so that little is left to write at exit; the first
 * writing takes about a second, because it loads the XML classes of the platform.
 */
final class WrittenPreferences {

    private static final Logger LOG = Logger.getLogger(WrittenPreferences.class.getName());
    /** The usual time between a change and the writing to disk, milliseconds. */
    static final int DELAY_MILLIS = 2000;

    private static final int MAX_SECONDS_AT_EXIT = 5;

    private final Preferences node;
    private final Map<String, String> texts = new HashMap<>();
    /** The only thread that uses the node after the start. */
    private final ExecutorService writer = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "faultline-preferences");
        thread.setDaemon(true);
        return thread;
    });

    private final Timer timer;

    private WrittenPreferences(Preferences node, int delayMillis) {
        this.node = node;
        timer = new Timer(delayMillis, event -> writer.execute(this::write));
        timer.setRepeats(false);
    }

    /**
     * Returns a store of the texts of a node, whose texts are read and set on the event dispatch thread.
     *
     * @param delayMillis the time between the last change and the writing to disk, milliseconds
     */
    static PreferenceStore storeOf(Preferences node, int delayMillis) {
        WrittenPreferences written = new WrittenPreferences(node, delayMillis);
        written.read();
        ShutdownHooks.add(new Thread(written::writeAtExit, "faultline-preferences-exit"));
        return new PreferenceStore(key -> written.texts.getOrDefault(key, ""), written::put);
    }

    private void read() {
        try {
            for (String key : node.keys()) {
                texts.put(key, node.get(key, ""));
            }
        } catch (BackingStoreException unavailable) {
            LOG.log(Level.FINE, "the preferences cannot be read", unavailable);
        }
    }

    private void put(String key, String text) {
        if (!text.equals(texts.getOrDefault(key, ""))) {
            texts.put(key, text);
            writer.execute(() -> node.put(key, text));
            timer.restart();
        }
    }

    private void write() {
        try {
            node.flush();
        } catch (BackingStoreException | AssertionError unavailable) {
            // The JDK throws an AssertionError if the disk is full.
            LOG.log(Level.FINE, "the preferences cannot be written", unavailable);
        }
    }

    /** Writes the last changes, because the platform may write the node at exit before they are passed to it. */
    private void writeAtExit() {
        try {
            writer.submit(this::write).get(MAX_SECONDS_AT_EXIT, TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException unavailable) {
            LOG.log(Level.FINE, "the preferences cannot be written", unavailable);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
