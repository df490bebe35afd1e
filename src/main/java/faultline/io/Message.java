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

        /** {@return the key of the translated pattern} */
        String key();

        /** {@return the English pattern, as described in {@link MessageFormat}} */
        String english();

        /**
         * {@return a message of this kind}
         *
         * @param arguments the values of the pattern's placeholders, in order
         */
        default Message with(Object... arguments) {
            return new Message(this, List.of(arguments));
        }
    }

    /**
     * Creates a message.
     *
     * @param template the kind of message
     * @param arguments the values for the template's placeholders, as many as it has
     */
    public Message {
        arguments = List.copyOf(arguments);
        assert arguments.size() == placeholders(template) : template + ": " + arguments;
    }

    private static int placeholders(Template template) {
        return new MessageFormat(template.english(), Locale.ROOT).getFormatsByArgumentIndex().length;
    }

    /**
     * {@return the text of this message, formatted with the pattern that a function returns for each template}
     *
     * @param patterns returns the pattern for a template
     */
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
