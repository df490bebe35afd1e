package faultline.gui.settings;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.Await;
import faultline.gui.settings.WindowPreferences.PreferenceStore;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.prefs.AbstractPreferences;
import org.junit.jupiter.api.Test;

/** Preferences that are written when they change, and only then. */
class WrittenPreferencesTest {

    private final Node node = new Node();
    private final PreferenceStore store = WrittenPreferences.storeOf(node);

    /** A node in memory. */
    private static final class Node extends AbstractPreferences {
        private final Map<String, String> texts = new HashMap<>();
        private final List<String> puts = new ArrayList<>();
        private final AtomicInteger flushes = new AtomicInteger();

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
        assertEquals(List.of("bounds=1 2 3 4", "bounds=1 2 3 5"), node.puts);
        assertEquals("1 2 3 5", store.get("bounds"));
    }

    @Test
    void changesAreWrittenTogetherWithoutWaitingForTheExit() {
        runOnEdt(() -> {
            store.put("bounds", "1 2 3 4");
            store.put("theme", "DARK");
        });
        Await.until("the changes are written", () -> node.flushes.get() == 1);
    }
}
