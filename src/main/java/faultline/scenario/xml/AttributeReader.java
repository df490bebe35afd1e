package faultline.scenario.xml;

import faultline.io.DecimalText;
import faultline.io.DidYouMean;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.io.XmlText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * Reads the attributes of one element. An invalid value is reported and replaced by a placeholder, so that reading
 * continues and finds the next problem; the caller discards the result if any problem was reported.
 */
public final class AttributeReader {

    /** Attributes that tell an editor where the schema is; they are ignored. */
    private static final Set<String> SCHEMA_LOCATION_ATTRIBUTES =
            Set.of("xsi:schemaLocation", "xsi:noNamespaceSchemaLocation");

    /** The placeholder of an id that could not be read; no file can contain it. */
    private static final String INVALID_ID = "\0";

    private final XmlElement node;
    private final Problems problems;
    /** Few names: a list is smaller and faster than a set. */
    private final List<String> requested = new ArrayList<>(8);

    private final Map<String, Supplier<Message>> missing = new LinkedHashMap<>();

    /**
     * Creates a reader of one element's attributes.
     *
     * @param node the element
     * @param problems the list to which problems are added
     */
    public AttributeReader(XmlElement node, Problems problems) {
        this.node = node;
        this.problems = problems;
    }

    /**
     * {@return whether the file gives an attribute}
     *
     * @param name the attribute
     */
    public boolean isPresent(String name) {
        markRequested(name);
        return node.attributes().containsKey(name);
    }

    /**
     * {@return the value of an optional attribute}
     *
     * @param name the attribute
     */
    public Optional<String> text(String name) {
        markRequested(name);
        return Optional.ofNullable(node.attributes().get(name));
    }

    /**
     * {@return the value of an optional attribute; empty, with a problem, if it is too long}
     *
     * @param name the attribute
     * @param maxLength the number of characters allowed
     */
    public Optional<String> text(String name, int maxLength) {
        Optional<String> text = text(name);
        if (text.isPresent() && text.get().length() > maxLength) {
            report(name, text.get(), Allowed.CHARACTERS.with(maxLength));
            return Optional.empty();
        }
        return text;
    }

    private void markRequested(String name) {
        if (!requested.contains(name)) {
            requested.add(name);
        }
    }

    /**
     * {@return the value of a required attribute; empty, with a problem, if it is missing}
     *
     * @param name the attribute
     * @param allowed the allowed values, for the problem
     */
    public Optional<String> requiredText(String name, Message allowed) {
        return required(name, () -> allowed);
    }

    /**
     * {@return the number of a required attribute}
     *
     * @param name the attribute
     * @param range the numbers allowed
     */
    public double number(String name, NumberRange range) {
        Optional<String> text = required(name, () -> numberRule(range));
        return text.isPresent() ? parseNumber(name, text.get(), range) : placeholder(range);
    }

    /**
     * {@return the number of an optional attribute}
     *
     * @param name the attribute
     * @param range the numbers allowed
     * @param fallback the number if the attribute is missing
     */
    public double number(String name, NumberRange range, double fallback) {
        Optional<String> text = text(name);
        return text.isPresent() ? parseNumber(name, text.get(), range) : fallback;
    }

    /**
     * {@return the angle of a required attribute, which is in degrees, in radians}
     *
     * @param name the attribute
     * @param range the numbers of degrees allowed
     */
    public double angle(String name, NumberRange range) {
        return required(name, () -> plainNumberRule(range))
                .map(text -> parseAngle(name, text, range))
                .orElse(0.0);
    }

    /**
     * {@return the angle of an optional attribute, which is in degrees, in radians}
     *
     * @param name the attribute
     * @param range the numbers of degrees allowed
     * @param fallback the angle if the attribute is missing, in radians
     */
    public double angle(String name, NumberRange range, double fallback) {
        Optional<String> text = text(name);
        return text.isPresent() ? parseAngle(name, text.get(), range) : fallback;
    }

    /**
     * {@return the truth value of a required attribute}
     *
     * @param name the attribute
     */
    public boolean flag(String name) {
        return required(name, Allowed.FLAG::with).map(text -> flag(name, text)).orElse(false);
    }

    /**
     * {@return the truth value of an optional attribute}
     *
     * @param name the attribute
     * @param fallback the value if the attribute is missing
     */
    public boolean flag(String name, boolean fallback) {
        return text(name).map(text -> flag(name, text)).orElse(fallback);
    }

    private boolean flag(String name, String text) {
        return choice(name, text, Map.of("true", true, "false", false), List.of("true", "false"))
                .orElse(false);
    }

    /**
     * {@return the whole number of an optional attribute}
     *
     * @param name the attribute
     * @param least the smallest number allowed
     * @param most the greatest number allowed
     * @param fallback the number if the attribute is missing
     */
    public long integer(String name, long least, long most, long fallback) {
        return text(name).map(text -> integer(name, text, least, most)).orElse(fallback);
    }

    private long integer(String name, String text, long least, long most) {
        OptionalLong value = DecimalText.parseWhole(text);
        if (value.isPresent() && value.getAsLong() >= least && value.getAsLong() <= most) {
            return value.getAsLong();
        }
        report(name, text, Allowed.WHOLE_NUMBER.with(Allowed.CLOSED.with(least, most)));
        return least;
    }

    /**
     * {@return the id of a required attribute}
     *
     * @param name the attribute
     */
    public String id(String name) {
        Optional<String> given = required(name, Allowed.ID::with);
        if (given.isEmpty() || isId(given.get())) {
            return given.orElse(INVALID_ID);
        }
        report(name, given.get(), Allowed.ID.with());
        return INVALID_ID;
    }

    /**
     * {@return whether {@link #id} has returned the id in the file rather than the placeholder}
     *
     * @param name the attribute
     * @param id the result of {@link #id} for it
     */
    public boolean isValid(String name, String id) {
        return id.equals(node.attributes().get(name));
    }

    /**
     * {@return whether a text is allowed as an id}
     *
     * @param text the text
     */
    public static boolean isId(String text) {
        if (text.isEmpty() || text.length() > ScenarioLimits.MAX_ID_LENGTH) {
            return false;
        }
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c == ',' || c == '"' || Character.isISOControl(c)) {
                return false;
            }
        }
        return true;
    }

    /**
     * {@return the option that a required attribute names; empty, with a problem, if it names none}
     *
     * @param <T> the type of the options
     * @param name the attribute
     * @param options the options
     * @param names returns the name of an option in the file
     */
    public <T> Optional<T> choice(String name, T[] options, Function<? super T, String> names) {
        Map<String, T> byName = byName(options, names);
        List<String> words = List.copyOf(byName.keySet());
        return required(name, () -> Allowed.names(words)).flatMap(text -> choice(name, text, byName, words));
    }

    /**
     * {@return the option that an optional attribute names}
     *
     * @param <T> the type of the options
     * @param name the attribute
     * @param options the options
     * @param names returns the name of an option in the file
     * @param fallback the option if the attribute is missing or names none
     */
    public <T> T choice(String name, T[] options, Function<? super T, String> names, T fallback) {
        return choice(name, byName(options, names), fallback);
    }

    private static <T> Map<String, T> byName(T[] options, Function<? super T, String> names) {
        Map<String, T> byName = new LinkedHashMap<>();
        Stream.of(options).forEach(option -> byName.put(names.apply(option), option));
        return byName;
    }

    /**
     * {@return the option that an optional attribute names}
     *
     * @param <T> the type of the options
     * @param name the attribute
     * @param options the options by their names in the file
     * @param fallback the option if the attribute is missing or names none
     */
    public <T> T choice(String name, Map<String, T> options, T fallback) {
        List<String> words = List.copyOf(options.keySet());
        return text(name).flatMap(text -> choice(name, text, options, words)).orElse(fallback);
    }

    private <T> Optional<T> choice(String name, String text, Map<String, T> options, List<String> words) {
        Optional<T> chosen = Optional.ofNullable(options.get(XmlText.strip(text)));
        if (chosen.isEmpty()) {
            reportValue(name, text, () -> Allowed.names(words, XmlText.strip(text)));
        }
        return chosen;
    }

    /**
     * Reports an invalid value.
     *
     * @param name the attribute
     * @param given its value
     * @param allowed the allowed values
     */
    public void report(String name, String given, Message allowed) {
        reportValue(name, given, () -> allowed);
    }

    /**
     * Reports an invalid value, with a rule that is made only if the problem is listed.
     *
     * @param name the attribute
     * @param given its value
     * @param allowed makes the allowed values
     */
    public void reportValue(String name, String given, Supplier<Message> allowed) {
        problems.add(node, () -> ProblemKind.VALUE.with(name, node.name(), MessageText.excerpt(given), allowed.get()));
    }

    /**
     * Reports every attribute that was given but never read, and every required one that is missing. An unknown
     * attribute that looks like a misspelt missing one is reported once.
     */
    public void reportUnknownAndMissing() {
        unread().forEach(name -> {
            problems.add(
                    node,
                    () -> ProblemKind.UNKNOWN_ATTRIBUTE.with(
                            node.name(),
                            MessageText.excerpt(name),
                            requested.isEmpty() ? Allowed.NONE.with() : Allowed.names(requested, name)));
            // The few missing names come first: a comparison with all names takes long in a file of unknown attributes.
            if (DidYouMean.nearest(name, missing.keySet()).isPresent()) {
                DidYouMean.nearest(name, requested).ifPresent(missing::remove);
            }
        });
        missing.forEach((name, allowed) ->
                problems.add(node, () -> ProblemKind.MISSING_ATTRIBUTE.with(node.name(), name, allowed.get())));
    }

    /** {@return the attributes that were given but never read, in the order of the file} */
    public Stream<String> unread() {
        return node.attributes().keySet().stream()
                .filter(name -> !requested.contains(name) && !SCHEMA_LOCATION_ATTRIBUTES.contains(name));
    }

    private Optional<String> required(String name, Supplier<Message> allowed) {
        Optional<String> text = text(name);
        if (text.isEmpty()) {
            missing.put(name, allowed);
        }
        return text;
    }

    /**
     * {@return whether the file gives a number in a range, so that {@link #number} has returned it rather than a
     * placeholder}
     *
     * @param name the attribute
     * @param range the numbers allowed
     */
    public boolean isNumber(String name, NumberRange range) {
        String text = node.attributes().get(name);
        return text != null && !Double.isNaN(findNumber(text, range));
    }

    private double parseNumber(String name, String text, NumberRange range) {
        double value = findNumber(text, range);
        if (Double.isNaN(value)) {
            reportValue(name, text, () -> numberRule(range));
            return placeholder(range);
        }
        return value;
    }

    /** Returns the number that a text states, or NaN if it states none in the range. */
    private static double findNumber(String text, NumberRange range) {
        double rounded = DecimalText.parseShort(text);
        if (range.isInside(rounded)) {
            return rounded;
        }
        return DecimalText.parse(text)
                .filter(range::contains)
                .map(exact -> DecimalText.toDouble(exact, text))
                .filter(nearest -> nearest != 0 || range.minInclusive())
                .orElse(Double.NaN);
    }

    private double parseAngle(String name, String text, NumberRange range) {
        Optional<Double> radians = DecimalText.parse(text)
                .filter(number -> text.indexOf('e') < 0 && text.indexOf('E') < 0)
                .filter(range::contains)
                .map(number -> DecimalText.toRadians(number, text))
                .filter(nearest -> nearest != 0 || range.minInclusive())
                .filter(nearest -> range.maxInclusive()
                        || nearest < StrictMath.toRadians(range.max().doubleValue()));
        if (radians.isEmpty()) {
            reportValue(name, text, () -> plainNumberRule(range));
        }
        return radians.orElse(1.0);
    }

    private static Message numberRule(NumberRange range) {
        return Allowed.NUMBER.with(range.rule());
    }

    private static Message plainNumberRule(NumberRange range) {
        return Allowed.PLAIN_NUMBER.with(range.rule());
    }

    /** Returns a value that causes no other problem. */
    private static double placeholder(NumberRange range) {
        return Math.min(1, range.max().doubleValue());
    }
}
