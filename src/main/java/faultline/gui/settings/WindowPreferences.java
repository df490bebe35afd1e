package faultline.gui.settings;

import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.prefs.Preferences;

/**
 * The preferences of the window. If the system has no preference store, nothing is remembered and nothing else changes.
 */
public final class WindowPreferences {

    /**
     * The platform's messages about preferences are of no use to a user. Held in a field, because a logger that is
     * garbage collected loses its level.
     */
    private static final Logger PREFERENCES_LOG = Logger.getLogger("java.util.prefs");

    private final PreferenceStore store;

    /**
     * A store of texts by key; an empty text if there is none. The changer applies a change to the text of a key, which
     * other windows may change, too.
     */
    public record PreferenceStore(
            UnaryOperator<String> getter,
            BiConsumer<String, String> setter,
            BiConsumer<String, UnaryOperator<String>> changer) {

        /** Creates a store that no other window uses. */
        public PreferenceStore(UnaryOperator<String> getter, BiConsumer<String, String> setter) {
            this(getter, setter, (key, change) -> setter.accept(key, change.apply(getter.apply(key))));
        }

        String get(String key) {
            return getter.apply(key);
        }

        void put(String key, String text) {
            setter.accept(key, text);
        }

        void change(String key, UnaryOperator<String> change) {
            changer.accept(key, change);
        }
    }

    public WindowPreferences(PreferenceStore store) {
        this.store = store;
    }

    /** Returns the preferences of the current user; they are not stored if the system has no preference store. */
    public static WindowPreferences forCurrentUser() {
        PREFERENCES_LOG.setLevel(Level.OFF);
        try {
            return new WindowPreferences(WrittenPreferences.storeOf(
                    Preferences.userRoot().node("faultline/window"), WrittenPreferences.DELAY_MILLIS));
        } catch (IllegalStateException | SecurityException unavailable) {
            return nonPersistent();
        }
    }

    /** Returns preferences that are not stored. */
    public static WindowPreferences nonPersistent() {
        return new WindowPreferences(new PreferenceStore(key -> "", (key, text) -> {}));
    }

    /** Returns the value of a preference. */
    public <T> T get(Preference<T> preference) {
        return preference.reader().apply(store.get(preference.key()));
    }

    /** Stores the value of a preference. */
    public <T> void set(Preference<T> preference, T value) {
        store.put(preference.key(), preference.writer().apply(value));
    }

    public RecentFiles recentFiles() {
        return new RecentFiles(new RecentTexts(store, "recent"));
    }

    /** Returns the commands of controllers that were used most recently. */
    public RecentTexts recentCommands() {
        return new RecentTexts(store, "recentCommands");
    }
}
