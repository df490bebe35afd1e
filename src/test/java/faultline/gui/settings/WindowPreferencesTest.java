package faultline.gui.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.TextSize;
import faultline.gui.theme.ThemeChoice;
import java.awt.Rectangle;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class WindowPreferencesTest {

    private final Map<String, String> store = new HashMap<>();
    private final WindowPreferences preferences = new WindowPreferences(
            new WindowPreferences.PreferenceStore(key -> store.getOrDefault(key, ""), store::put));

    @Test
    void storedPreferencesAreRestored() {
        preferences.setThemeChoice(ThemeChoice.DARK);
        preferences.setBounds(new Rectangle(-20, 30, 1200, 800));
        preferences.setPanelWidth(410);
        assertEquals(ThemeChoice.DARK, preferences.themeChoice());
        assertEquals(Optional.of(new Rectangle(-20, 30, 1200, 800)), preferences.bounds());
        assertEquals(Optional.of(410), preferences.panelWidth());
    }

    @Test
    void lengthsGrowWithTheTextSize() {
        preferences.setPanelWidth(440);
        preferences.setDock(200, 300);
        TextSize.LARGEST.install();
        try {
            assertEquals(Optional.of(660), preferences.panelWidth());
            assertEquals(Optional.of(300), preferences.dockHeight());
            assertEquals(Optional.of(450), preferences.chartWidth());
        } finally {
            TextSize.NORMAL.install();
        }
    }

    @Test
    void howObstaclesSnapIsKept() {
        assertFalse(preferences.isGridSnapped());
        preferences.setSnap(true, false);
        assertTrue(preferences.isGridSnapped());
        assertFalse(preferences.isAngleSnapped());
    }

    @Test
    void damagedPreferencesAreIgnored() {
        store.putAll(Map.of("theme", "PINK", "bounds", "1 2 x 4", "divider", "-5"));
        assertEquals(ThemeChoice.LIGHT, preferences.themeChoice());
        assertEquals(Optional.empty(), preferences.bounds());
        assertEquals(Optional.empty(), preferences.panelWidth());
    }

    @Test
    void nonPersistentPreferencesKeepNothing() {
        WindowPreferences none = WindowPreferences.nonPersistent();
        none.setThemeChoice(ThemeChoice.DARK);
        assertEquals(ThemeChoice.LIGHT, none.themeChoice());
        assertEquals(Optional.empty(), none.bounds());
    }

    @Test
    void aMaximisedWindowIsRememberedBesideItsBounds() {
        assertFalse(preferences.isMaximised());
        preferences.setBounds(new Rectangle(10, 30, 1200, 800));
        preferences.setMaximised(true);
        assertTrue(preferences.isMaximised());
        assertEquals(Optional.of(new Rectangle(10, 30, 1200, 800)), preferences.bounds());
    }
}
