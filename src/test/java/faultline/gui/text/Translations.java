package faultline.gui.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.io.Message;
import java.util.regex.Pattern;

/** Checks the translations of messages. */
public final class Translations {

    private static final Pattern ENGLISH_WORDS =
            Pattern.compile("\\b(is|expected|the|of|from|than|number|holds|has|one|or|and|metres|seconds)\\b");

    private Translations() {}

    private static void assertPatternsTranslated(Message message) {
        String pattern = Messages.get(Language.POLISH, message.template().key());
        String own = pattern.replaceAll("\"[^\"]*\"|<[^>]*>", "");
        assertFalse(ENGLISH_WORDS.matcher(own).find(), pattern);
        message.arguments().stream()
                .filter(Message.class::isInstance)
                .forEach(argument -> assertPatternsTranslated((Message) argument));
    }

    /** Checks that the English text of a message is the window's, and that all of it is translated into Polish. */
    public static void assertTranslated(Message message) {
        String english = message.toString();
        assertEquals(english, message.text(template -> Messages.get(Language.ENGLISH, template.key())));
        String polish = message.text(template -> Messages.get(Language.POLISH, template.key()));
        assertNotEquals(english, polish);
        assertPatternsTranslated(message);
    }
}
