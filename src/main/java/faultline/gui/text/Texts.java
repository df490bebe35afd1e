package faultline.gui.text;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;

/** The texts that users see. Numbers in them are written before they get here, so that no locale changes them. */
public final class Texts {

    private static final ResourceBundle BUNDLE = ResourceBundle.getBundle("faultline.gui.Messages", Locale.getDefault(),
            ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));

    private Texts() {
    }

    /**
     * The text of a key.
     *
     * @param key as in the properties file
     * @return the text
     * @throws java.util.MissingResourceException if there is none
     */
    public static String text(String key) {
        return BUNDLE.getString(key);
    }

    /**
     * The text of a key with its gaps filled.
     *
     * @param key as in the properties file, whose text has gaps {0}, {1} and so on
     * @param values what goes there
     * @return the text
     * @throws java.util.MissingResourceException if there is none
     */
    public static String text(String key, String... values) {
        return new MessageFormat(text(key), Locale.ROOT).format(values);
    }

    /**
     * Whether there is a text.
     *
     * @param key as in the properties file
     * @return true where there is
     */
    public static boolean has(String key) {
        return BUNDLE.containsKey(key);
    }
}
