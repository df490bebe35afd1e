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
        preferences.set(Preference.THEME, ThemeChoice.DARK);
        preferences.set(Preference.BOUNDS, Optional.of(new Rectangle(-20, 30, 1200, 800)));
        preferences.set(Preference.PANEL_WIDTH, Optional.of(410));
        assertEquals(ThemeChoice.DARK, preferences.get(Preference.THEME));
        assertEquals(Optional.of(new Rectangle(-20, 30, 1200, 800)), preferences.get(Preference.BOUNDS));
        assertEquals(Optional.of(410), preferences.get(Preference.PANEL_WIDTH));
    }

    @Test
    void lengthsGrowWithTheTextSize() {
        preferences.set(Preference.PANEL_WIDTH, Optional.of(440));
        preferences.set(Preference.DOCK_HEIGHT, Optional.of(200));
        preferences.set(Preference.CHART_WIDTH, Optional.of(300));
        TextSize.LARGEST.install();
        try {
            assertEquals(Optional.of(660), preferences.get(Preference.PANEL_WIDTH));
            assertEquals(Optional.of(300), preferences.get(Preference.DOCK_HEIGHT));
            assertEquals(Optional.of(450), preferences.get(Preference.CHART_WIDTH));
        } finally {
            TextSize.NORMAL.install();
        }
    }

    @Test
    void howObstaclesSnapIsKept() {
        assertFalse(preferences.get(Preference.SNAP_GRID));
        preferences.set(Preference.SNAP_GRID, true);
        preferences.set(Preference.SNAP_ANGLE, false);
        assertTrue(preferences.get(Preference.SNAP_GRID));
        assertFalse(preferences.get(Preference.SNAP_ANGLE));
    }

    @Test
    void damagedPreferencesAreIgnored() {
        store.putAll(Map.of("theme", "PINK", "bounds", "1 2 x 4", "divider", "-5"));
        assertEquals(ThemeChoice.LIGHT, preferences.get(Preference.THEME));
        assertEquals(Optional.empty(), preferences.get(Preference.BOUNDS));
        assertEquals(Optional.empty(), preferences.get(Preference.PANEL_WIDTH));
    }

    @Test
    void nonPersistentPreferencesKeepNothing() {
        WindowPreferences none = WindowPreferences.nonPersistent();
        none.set(Preference.THEME, ThemeChoice.DARK);
        assertEquals(ThemeChoice.LIGHT, none.get(Preference.THEME));
        assertEquals(Optional.empty(), none.get(Preference.BOUNDS));
    }

    @Test
    void aMaximisedWindowIsRememberedBesideItsBounds() {
        assertFalse(preferences.get(Preference.MAXIMISED));
        preferences.set(Preference.BOUNDS, Optional.of(new Rectangle(10, 30, 1200, 800)));
        preferences.set(Preference.MAXIMISED, true);
        assertTrue(preferences.get(Preference.MAXIMISED));
        assertEquals(Optional.of(new Rectangle(10, 30, 1200, 800)), preferences.get(Preference.BOUNDS));
    }
}
