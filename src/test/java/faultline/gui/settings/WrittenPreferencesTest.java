package faultline.gui.settings;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.gui.Await;
import faultline.gui.settings.WindowPreferences.PreferenceStore;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.prefs.AbstractPreferences;
import java.util.prefs.Preferences;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Preferences that are written when they change, and only then. */
class WrittenPreferencesTest {

    /** The time between a change and the writing, milliseconds. */
    private static final int DELAY = 50;

    private final Node node = new Node();
    private final PreferenceStore store = WrittenPreferences.storeOf(node, DELAY);

    /** A node in memory. */
    private static final class Node extends AbstractPreferences {
        private final Map<String, String> texts = new ConcurrentHashMap<>();
        private final List<String> puts = new CopyOnWriteArrayList<>();
        private final CountDownLatch flushing = new CountDownLatch(1);
        private final CountDownLatch flushed = new CountDownLatch(1);
        private final AtomicInteger flushes = new AtomicInteger();
        private volatile boolean isSlow;
        private volatile boolean isFull;

        Node() {
            super(null, "");
        }

        @Override
        protected void putSpi(String key, String value) {
            texts.put(key, value);
            puts.add(key + "=" + value);
        }

        @Override
        protected String getSpi(String key) {
            return texts.get(key);
        }

        @Override
        protected void removeSpi(String key) {
            texts.remove(key);
        }

        @Override
        protected void removeNodeSpi() {
            texts.clear();
        }

        @Override
        protected String[] keysSpi() {
            return texts.keySet().toArray(String[]::new);
        }

        @Override
        protected String[] childrenNamesSpi() {
            return new String[0];
        }

        @Override
        protected AbstractPreferences childSpi(String name) {
            throw new UnsupportedOperationException();
        }

        @Override
        protected void syncSpi() {
            flushSpi();
        }

        @Override
        protected void flushSpi() {
            flushes.incrementAndGet();
            flushing.countDown();
            if (isFull) {
                throw new AssertionError("as the JDK's nodes do");
            }
            if (isSlow) {
                awaitRelease();
            }
        }

        private void awaitRelease() {
            try {
                flushed.await();
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Test
    void aTextThatIsThereIsNotStoredAgain() {
        runOnEdt(() -> {
            store.put("bounds", "1 2 3 4");
            store.put("bounds", "1 2 3 4");
            store.put("language", "");
            store.put("bounds", "1 2 3 5");
        });
        assertEquals("1 2 3 5", store.get("bounds"));
        Await.until("the changes are written", () -> node.flushes.get() == 1);
        assertEquals(List.of("bounds=1 2 3 4", "bounds=1 2 3 5"), node.puts);
    }

    /** The platform's nodes hold their lock for up to 0.2 s while they are written. */
    @Test
    void aChangeDoesNotWaitForTheWritingOfAnEarlierOne() throws InterruptedException {
        node.isSlow = true;
        try {
            runOnEdt(() -> store.put("theme", "DARK"));
            node.flushing.await();
            AtomicBoolean changed = new AtomicBoolean();
            EventQueue.invokeLater(() -> {
                store.put("theme", "LIGHT");
                changed.set("LIGHT".equals(store.get("theme")));
                node.flushed.countDown();
            });
            assertTrue(node.flushed.await(10, TimeUnit.SECONDS), "the change waits for the writing");
            assertTrue(changed.get());
        } finally {
            node.flushed.countDown();
        }
        Await.until("both changes are written", () -> node.flushes.get() == 2);
        assertEquals("LIGHT", node.texts.get("theme"));
    }

    @Test
    void aFullDiskIsNoErrorOfTheProgram() {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        List<Throwable> errors = new CopyOnWriteArrayList<>();
        Thread.setDefaultUncaughtExceptionHandler((thread, error) -> errors.add(error));
        try {
            node.isFull = true;
            runOnEdt(() -> store.put("theme", "DARK"));
            Await.until("the first attempt", () -> node.flushes.get() == 1);
            node.isFull = false;
            runOnEdt(() -> store.put("theme", "LIGHT"));
            Await.until("the second attempt", () -> node.flushes.get() == 2);
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
        assertEquals(List.of(), errors);
        assertEquals("LIGHT", node.texts.get("theme"));
    }

    @Test
    void whatIsStoredIsReadAtTheStart() {
        node.texts.put("language", "POLISH");
        assertEquals("POLISH", WrittenPreferences.storeOf(node, DELAY).get("language"));
        assertEquals("", WrittenPreferences.storeOf(node, DELAY).get("theme"));
    }

    @Test
    void changesAreWrittenTogetherWithoutWaitingForTheExit() {
        runOnEdt(() -> {
            store.put("bounds", "1 2 3 4");
            store.put("theme", "DARK");
        });
        Await.until("the changes are written", () -> node.flushes.get() == 1);
    }

    /** A process that prints the theme of its user, changes it and ends at once. */
    static final class Quitting {
        public static void main(String[] arguments) throws Exception {
            System.setProperty("java.util.prefs.userRoot", arguments[0]);
            PreferenceStore store = WrittenPreferences.storeOf(
                    Preferences.userRoot().node("faultline/test"), WrittenPreferences.DELAY_MILLIS);
            System.out.print(store.get("theme"));
            runOnEdt(() -> store.put("theme", arguments[1]));
            System.exit(0);
        }
    }

    @Test
    void aChangeJustBeforeTheExitIsWritten(@TempDir Path userRoot) throws IOException {
        List<String> themes = new ArrayList<>();
        for (String next : List.of("DARK", "LIGHT", "DARK")) {
            Process process = JavaProcess.builder(Quitting.class.getName(), List.of(userRoot.toString(), next))
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            themes.add(JavaProcess.output(process));
        }
        assertEquals(List.of("", "DARK", "LIGHT"), themes);
    }
}
