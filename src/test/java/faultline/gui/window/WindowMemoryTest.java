package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.Theme;
import java.awt.Rectangle;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class WindowMemoryTest {

    private final Map<String, String> kept = new HashMap<>();
    private final WindowMemory memory = new WindowMemory(new WindowMemory.Store() {
        @Override
        public String get(String key) {
            return kept.getOrDefault(key, "");
        }

        @Override
        public void put(String key, String text) {
            kept.put(key, text);
        }
    });

    @Test
    void whatIsKeptComesBack() {
        memory.keepTheme(Theme.DARK);
        memory.keepBounds(new Rectangle(-20, 30, 1200, 800));
        memory.keepPanelWidth(410);
        assertEquals(Theme.DARK, memory.theme());
        assertEquals(Optional.of(new Rectangle(-20, 30, 1200, 800)), memory.bounds());
        assertEquals(Optional.of(410), memory.panelWidth());
    }

    @Test
    void howObstaclesSnapIsKept() {
        assertFalse(memory.isGridSnapped());
        memory.keepSnap(true, false);
        assertTrue(memory.isGridSnapped());
        assertFalse(memory.isAngleSnapped());
    }

    @Test
    void damagedMemoriesAreNone() {
        kept.putAll(Map.of("theme", "PINK", "bounds", "1 2 x 4", "divider", "-5"));
        assertEquals(Theme.LIGHT, memory.theme());
        assertEquals(Optional.empty(), memory.bounds());
        assertEquals(Optional.empty(), memory.panelWidth());
    }

    @Test
    void aMemoryThatForgetsKeepsNothing() {
        WindowMemory none = WindowMemory.none();
        none.keepTheme(Theme.DARK);
        assertEquals(Theme.LIGHT, none.theme());
        assertEquals(Optional.empty(), none.bounds());
    }
}
