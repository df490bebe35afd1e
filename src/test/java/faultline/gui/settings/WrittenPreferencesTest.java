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
import java.util.stream.Stream;
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
        protected void syncSpi() {}

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

    private static RecentFiles recentFiles(PreferenceStore store) {
        return new WindowPreferences(store).recentFiles();
    }

    @Test
    void theRecentFilesOfTwoWindowsAreKept() {
        RecentFiles first = recentFiles(store);
        RecentFiles second = recentFiles(WrittenPreferences.storeOf(node, DELAY));
        List<Path> files = Stream.of("a", "b", "c")
                .map(name -> Path.of(name).toAbsolutePath())
                .toList();
        runOnEdt(() -> {
            first.add(files.get(0));
            first.add(files.get(1));
        });
        Await.until("the first files", () -> node.flushes.get() == 1);
        runOnEdt(() -> second.add(files.get(2)));
        Await.until("the second file", () -> node.flushes.get() == 2);
        runOnEdt(() -> {
            assertEquals(List.of(files.get(1), files.get(0)), first.files());
            first.remove(files.get(0));
        });
        Await.until("the removal", () -> node.flushes.get() == 3);
        assertEquals(
                List.of(files.get(2), files.get(1)),
                recentFiles(WrittenPreferences.storeOf(node, DELAY)).files());
        runOnEdt(second::clear);
        Await.until("the end", () -> node.texts.get("recent").isEmpty());
    }

    /** A process that prints two preferences and the recent files, and adds one of each when its input ends. */
    static final class Adding {
        public static void main(String[] arguments) throws Exception {
            System.setProperty("java.util.prefs.userRoot", arguments[0]);
            Preferences node = Preferences.userRoot().node("faultline/test");
            PreferenceStore store = WrittenPreferences.storeOf(node, DELAY);
            RecentFiles recent = recentFiles(store);
            System.out.print(store.get("a") + " " + store.get("b") + " ");
            recent.files().forEach(file -> System.out.print(file.getFileName() + " "));
            System.out.print('.');
            System.out.flush();
            while (System.in.read() >= 0) {
                Thread.onSpinWait();
            }
            runOnEdt(() -> {
                recent.add(Path.of(arguments[1]));
                store.put(arguments[1], "there");
            });
            // At the exit, the platform reads and writes the node at the same time.
            Await.until("the writing", () -> node.get(arguments[1], "").equals("there"));
            System.exit(0);
        }
    }

    private static String add(Process process) throws IOException {
        process.getOutputStream().close();
        return JavaProcess.output(process);
    }

    private static Process startAdding(Path userRoot, String file) throws IOException {
        return JavaProcess.builder(Adding.class.getName(), List.of(userRoot.toString(), file))
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    @Test
    void whatTwoProcessesHaveChangedIsKept(@TempDir Path userRoot) throws IOException {
        add(startAdding(userRoot, "old"));
        Process first = startAdding(userRoot, "a");
        assertEquals(' ', first.getInputStream().read());
        add(startAdding(userRoot, "b"));
        add(first);
        assertEquals("there there a b old .", add(startAdding(userRoot, "c")));
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
