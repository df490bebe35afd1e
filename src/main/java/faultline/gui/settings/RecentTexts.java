package faultline.gui.settings;

import faultline.gui.settings.WindowPreferences.PreferenceStore;
import faultline.io.XmlText;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The texts used most recently, such as names of files, newest first, under a key of the preferences. */
public final class RecentTexts {

    private static final int MAX_TEXTS = 8;
    /** The longest value that a preference may have. */
    private static final int MAX_VALUE_LENGTH = 8192;

    private static final Pattern LINE_BREAK = Pattern.compile("[\\n\\r]");

    private final PreferenceStore store;
    private final String key;

    RecentTexts(PreferenceStore store, String key) {
        this.store = store;
        this.key = key;
    }

    /** Returns the texts, newest first. */
    public List<String> texts() {
        return lines(store.get(key)).toList();
    }

    private static Stream<String> lines(String stored) {
        return stored.lines().filter(line -> !line.isBlank());
    }

    /**
     * Adds a text as the newest one. One with a line break is not kept, because lines separate the texts, nor one that
     * is longer than the preferences allow. With a character that XML cannot hold, such as a control character, the
     * platform could not read any preference again.
     */
    public void add(String text) {
        if (text.length() <= MAX_VALUE_LENGTH && !LINE_BREAK.matcher(text).find() && XmlText.isValid(text)) {
            store.change(
                    key,
                    stored -> joined(Stream.concat(Stream.of(text), without(text, stored))
                            .limit(MAX_TEXTS)
                            .toList()));
        }
    }

    void remove(String text) {
        store.change(key, stored -> joined(without(text, stored).toList()));
    }

    void clear() {
        store.change(key, stored -> "");
    }

    private static Stream<String> without(String text, String stored) {
        return lines(stored).filter(other -> !other.equals(text));
    }

    /** Joins as many of the newest texts as the preferences have room for. */
    private static String joined(List<String> texts) {
        String lines = String.join("\n", texts);
        return lines.length() > MAX_VALUE_LENGTH ? joined(texts.subList(0, texts.size() - 1)) : lines;
    }
}
