package faultline.gui.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;
import java.util.stream.Stream;

/** The texts that users see. Numbers in them are written before they get here, so that no locale changes them. */
public final class Messages {

    private static final String MESSAGES_BUNDLE = "Messages";
    private static final String EXAMPLES_BUNDLE = "Examples";

    private static volatile Language language = Language.ENGLISH;
    private static volatile ResourceBundle bundle = bundle(MESSAGES_BUNDLE, Language.ENGLISH);

    private Messages() {}

    private static ResourceBundle bundle(String name, Language language) {
        return ResourceBundle.getBundle(
                "faultline.gui." + name,
                language.locale(),
                ResourceBundle.Control.getNoFallbackControl(ResourceBundle.Control.FORMAT_PROPERTIES));
    }

    /**
     * Chooses the language of all texts that are asked for from now on.
     *
     * @param chosen the language
     */
    public static void setLanguage(Language chosen) {
        language = chosen;
        bundle = bundle(MESSAGES_BUNDLE, chosen);
    }

    static Stream<String> keys() {
        return keys(language);
    }

    /** The keys of all texts in a language, in order. */
    static Stream<String> keys(Language of) {
        return bundle(MESSAGES_BUNDLE, of).keySet().stream().sorted();
    }

    /** The text of a key in a language, whichever is spoken. */
    static String get(Language of, String key) {
        return bundle(MESSAGES_BUNDLE, of).getString(key);
    }

    /**
     * A page of more than a few words.
     *
     * @param name of the page
     * @return HTML
     */
    public static String loadPage(String name) {
        String file = name
                + (language == Language.ENGLISH ? "" : "_" + language.locale().getLanguage()) + ".html";
        try (InputStream in = Messages.class.getResourceAsStream("/faultline/gui/" + file)) {
            if (in == null) {
                throw new MissingResourceException("there is no page " + file, Messages.class.getName(), file);
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    /**
     * The text of a key.
     *
     * @param key as in the properties file
     * @return the text
     * @throws java.util.MissingResourceException if there is none
     */
    public static String get(String key) {
        return bundle.getString(key);
    }

    /**
     * The text of a key with its gaps filled.
     *
     * @param key as in the properties file, whose text has gaps {0}, {1} and so on
     * @param values what goes there
     * @return the text
     * @throws java.util.MissingResourceException if there is none
     */
    public static String get(String key, String... values) {
        return new MessageFormat(get(key), Locale.ROOT).format(values);
    }

    /**
     * What is said of an example, in the user's language.
     *
     * @param key as in the examples' properties file
     * @param own what the example says itself
     * @return the text of the key, or what it says itself where there is none
     */
    public static String exampleText(String key, String own) {
        ResourceBundle examples = bundle(EXAMPLES_BUNDLE, language);
        return examples.containsKey(key) ? examples.getString(key) : own;
    }

    /**
     * Whether there is a text.
     *
     * @param key as in the properties file
     * @return true where there is
     */
    public static boolean contains(String key) {
        return bundle.containsKey(key);
    }
}
