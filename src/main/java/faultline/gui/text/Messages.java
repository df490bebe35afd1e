package faultline.gui.text;

import faultline.io.Message;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;
import java.util.stream.Stream;

/** The texts of the user interface. Numbers are formatted by the caller, so that no locale changes them. */
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

    /** Sets the language of all texts that are requested afterwards. */
    public static void setLanguage(Language chosen) {
        language = chosen;
        bundle = bundle(MESSAGES_BUNDLE, chosen);
    }

    /** Returns the language of the texts. */
    public static Language language() {
        return language;
    }

    static Stream<String> keys() {
        return keys(language);
    }

    /** Returns the keys of all texts in a language, sorted. */
    static Stream<String> keys(Language of) {
        return bundle(MESSAGES_BUNDLE, of).keySet().stream().sorted();
    }

    /** Returns the text of a key in a given language. */
    static String get(Language of, String key) {
        return bundle(MESSAGES_BUNDLE, of).getString(key);
    }

    /** Loads an HTML page in the current language. */
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

    /** Returns the text of a key; throws a {@link MissingResourceException} if there is none. */
    public static String get(String key) {
        return bundle.getString(key);
    }

    /** Returns the text of a key with its placeholders replaced. */
    public static String get(String key, String... values) {
        return new MessageFormat(get(key), Locale.ROOT).format(values);
    }

    /** Returns a message in the current language. */
    public static String get(Message message) {
        return message.text(template -> get(template.key()));
    }

    /** Returns the text of a key of the examples' bundle, or the example's own text if there is none. */
    public static String exampleText(String key, String own) {
        ResourceBundle examples = bundle(EXAMPLES_BUNDLE, language);
        return examples.containsKey(key) ? examples.getString(key) : own;
    }

    /** Returns whether there is a text for a key. */
    public static boolean contains(String key) {
        return bundle.containsKey(key);
    }
}
