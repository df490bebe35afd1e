package faultline.gui.settings;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import faultline.io.ShutdownHooks;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.UnaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.BackingStoreException;
import java.util.prefs.Preferences;
import javax.swing.Timer;

/**
 * A store in a node of the system's preferences. The texts are read once, at the start. A change is kept in memory and
 * passed to the node by another thread, because a node that is being written to disk holds a lock, for 0.1 to 0.2
 * seconds. The node is written to disk shortly after a change, so that little is left to write at exit; the first
 * writing takes about a second, because it loads the XML classes of the platform. What other windows have changed in
 * the node is kept.
 */
final class WrittenPreferences {

    private static final Logger LOG = Logger.getLogger(WrittenPreferences.class.getName());
    /** The usual time between a change and the writing to disk, milliseconds. */
    static final int DELAY_MILLIS = 2000;

    private static final int MAX_SECONDS_AT_EXIT = 5;

    /** Reads or writes the file of the node. */
    private interface StoreAccess {
        void perform() throws BackingStoreException;
    }

    private final Preferences node;
    private final Map<String, String> texts = new HashMap<>();
    /** The only thread that uses the node after the start. */
    private final ExecutorService writer = Executors.newSingleThreadExecutor(task -> {
        Thread thread = new Thread(task, "faultline-preferences");
        thread.setDaemon(true);
        return thread;
    });

    /**
     * The changes of the node that wait for the next writing; used by the writer only. They are made after the node has
     * been read, because the platform writes all of its texts, also those that another process has changed.
     */
    private final List<Runnable> changes = new ArrayList<>();

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
        return new PreferenceStore(key -> written.texts.getOrDefault(key, ""), written::put, written::change);
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
        change(key, before -> text);
    }

    /** Changes a text that other windows may change, too; the change of each window is applied to the node. */
    private void change(String key, UnaryOperator<String> change) {
        String before = texts.getOrDefault(key, "");
        String after = change.apply(before);
        if (!after.equals(before)) {
            texts.put(key, after);
            writer.execute(() -> changes.add(() -> node.put(key, change.apply(node.get(key, "")))));
            timer.restart();
        }
    }

    private void write() {
        if (!changes.isEmpty()) {
            // On Linux, only the second call reads what another process has written.
            attempt(node::sync);
            attempt(node::sync);
            changes.forEach(Runnable::run);
            changes.clear();
        }
        attempt(node::flush);
    }

    private static void attempt(StoreAccess access) {
        try {
            access.perform();
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
