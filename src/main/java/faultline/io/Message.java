package faultline.io;

import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/**
 * A message to the user as data. Its text is made where it is shown: in English by {@link #toString}, in another
 * language by {@link #text} with translated patterns.
 *
 * @param template the kind of message
 * @param arguments the values for the template's placeholders: plain values, or messages, which are translated too
 */
public record Message(Template template, List<Object> arguments) {

    /** A kind of message; most are constants of an enum. */
    public interface Template {

        /** Returns the key of the translated pattern. */
        String key();

        /** Returns the English pattern, as described in {@link MessageFormat}. */
        String english();

        /** Returns a message of this kind. */
        default Message with(Object... arguments) {
            return new Message(this, List.of(arguments));
        }
    }

    /** Returns the text of this message, formatted with the pattern that a function returns for each template. */
    public String text(Function<Template, String> patterns) {
        Object[] texts = arguments.stream()
                .map(value -> value instanceof Message message ? message.text(patterns) : value.toString())
                .toArray();
        return new MessageFormat(patterns.apply(template), Locale.ROOT).format(texts);
    }

    /** Returns the English text. */
    @Override
    public String toString() {
        return text(Template::english);
    }
}
