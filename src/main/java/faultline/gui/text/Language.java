package faultline.gui.text;

import java.util.Locale;

/** The languages that the window speaks. It speaks English until another is chosen, whatever the machine speaks. */
public enum Language {
    /** English. */
    ENGLISH(Locale.ROOT),
    /** Polish, the language of the paper's home. */
    POLISH(new Locale("pl"));

    private final Locale locale;

    Language(Locale locale) {
        this.locale = locale;
    }

    /**
     * For the names of resources.
     *
     * @return the root for English
     */
    public Locale locale() {
        return locale;
    }
}
