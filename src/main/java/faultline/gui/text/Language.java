package faultline.gui.text;

import java.util.Locale;

/** The languages of the window. English is the default, whatever the system's language. */
public enum Language {
    ENGLISH(Locale.ROOT),
    POLISH(new Locale("pl"));

    private final Locale locale;

    Language(Locale locale) {
        this.locale = locale;
    }

    /** Returns the locale of the resource bundles, {@link Locale#ROOT} for English. */
    public Locale locale() {
        return locale;
    }
}
