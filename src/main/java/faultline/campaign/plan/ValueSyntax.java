package faultline.campaign.plan;

import faultline.io.DecimalText;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The four forms of values in a plan: {@code 0.1 0.2 0.4} lists them, {@code 0.1..0.4/4} spaces them evenly,
 * {@code 0.1..0.4} draws one between two bounds, {@code any of left right} draws one of several words. An id may stand
 * in double quotes, which it needs if it has blanks.
 */
public final class ValueSyntax {

    /** A set without sensors, in results. */
    private static final String NO_SENSOR = "none";

    /** The maximum number of values in one list. */
    static final int MAX_VALUES = 100_000;

    /** The forms of a value, for error messages. */
    static final String RULE = "one value, several with blanks between them, FROM..TO/COUNT, FROM..TO, or any of A B C;"
            + " at most " + MAX_VALUES + " values";

    /** The forms of ids in quotes, for error messages. */
    static final String ID_RULE = "ids with blanks between them, or any of A B C, with whole ids in double quotes;"
            + " at most " + MAX_VALUES + " ids";

    /** An id, in quotes or not, and the blanks or the end after it. */
    private static final Pattern ID = Pattern.compile("(?:\"([^\"]+)\"|([^\\s\"]+))(?:\\s+|$)");
    /** An id that needs no quotes. */
    private static final Pattern PLAIN_ID = Pattern.compile("(?!any$)[^\\s.]+");

    private static final Pattern BLANK = Pattern.compile("\\s");
    // Possessive quantifiers, so that the time is linear and the depth of the stack bounded.
    private static final Pattern INTERVAL = Pattern.compile("((?:(?!\\.\\.)\\S)++)\\.\\.([^\\s/]++)(?:/(\\d{1,6}+))?+");
    private static final Pattern CHOICE = Pattern.compile("any of\\s++(.++)");
    private static final String NUMBER = "-?\\d++(?:\\.\\d++)?+";

    /**
     * A list or range of numbers in another notation, such as 20, or 0-0.8 or 5,10,20; no attribute has such values.
     */
    private static final Pattern OTHER_NOTATION = Pattern.compile("N,|N-N|N(?:,N){2,}+".replace("N", NUMBER));

    private static final MathContext TWELVE_DIGITS = new MathContext(12);

    private ValueSyntax() {}

    /**
     * {@return the number of values in a text, where a drawn value counts as one; empty if the text has none of the
     * four forms}
     *
     * @param text the text
     */
    public static OptionalInt count(String text) {
        return parse(text, "", false).stream().mapToInt(List::size).findFirst();
    }

    /**
     * {@return the greatest number that a text stands for, or the upper bound of a range to draw from; empty if the
     * text has none of the four forms, or no number}
     *
     * @param text the text
     */
    public static OptionalDouble greatest(String text) {
        if (count(text).isEmpty()) {
            return OptionalDouble.empty();
        }
        String trimmed = text.strip();
        Matcher choice = CHOICE.matcher(trimmed);
        Matcher interval = INTERVAL.matcher(trimmed);
        String numbers = choice.matches() ? choice.group(1) : interval.matches() ? interval.group(2) : trimmed;
        return Stream.of(numbers.split("\\s+"))
                .flatMap(word -> DecimalText.parse(word).stream())
                .mapToDouble(BigDecimal::doubleValue)
                .max();
    }

    /**
     * {@return whether a text is a range whose first number is not the smaller one, so that it has no values}
     *
     * @param text the text
     */
    public static boolean isReversedRange(String text) {
        Matcher interval = INTERVAL.matcher(text.strip());
        return interval.matches()
                && bounds(interval).filter(each -> !each.isAscending()).isPresent();
    }

    /** The bounds of a range. */
    private record Bounds(BigDecimal from, BigDecimal to) {
        boolean isAscending() {
            return from.compareTo(to) < 0;
        }
    }

    /** Returns the bounds of a range; empty if one is no number. */
    private static Optional<Bounds> bounds(Matcher interval) {
        return DecimalText.parse(interval.group(1))
                .flatMap(from -> DecimalText.parse(interval.group(2)).map(to -> new Bounds(from, to)));
    }

    /**
     * {@return the values of an attribute, where a drawn value counts as one; empty if the text has none of the four
     * forms}
     *
     * @param text the text in the plan
     * @param stream the name of the random numbers, if values are drawn
     * @param isText whether equal numbers that are written differently, such as 0.2 and 0.20, are different values
     */
    static Optional<List<AttributeValue>> parse(String text, String stream, boolean isText) {
        String trimmed = text.strip();
        Matcher choice = CHOICE.matcher(trimmed);
        if (choice.matches()) {
            return words(choice.group(1), isText)
                    .map(words -> List.of(new AttributeValue.DrawnValue(stream, new DrawRange.Words(words))));
        }
        Matcher interval = INTERVAL.matcher(trimmed);
        if (interval.matches()) {
            return parseInterval(interval, stream);
        }
        if (trimmed.isEmpty() || trimmed.contains("..")) {
            return Optional.empty();
        }
        return words(trimmed, isText).map(ValueSyntax::fixed);
    }

    /**
     * {@return ids as they are written in a plan, with blanks between them}
     *
     * @param ids the ids, without double quotes
     */
    public static String formatIds(List<String> ids) {
        return ids.stream()
                .map(id -> PLAIN_ID.matcher(id).matches() ? id : '"' + id + '"')
                .collect(Collectors.joining(" "));
    }

    /**
     * Returns the ids of a text, as {@link #parse} does with words. With a double quote in the text, it is a list of
     * ids of which some are in quotes, or draws one of them.
     */
    static Optional<List<AttributeValue>> parseIds(String text, String stream) {
        if (!text.contains("\"")) {
            return parse(text, stream, true);
        }
        Matcher choice = CHOICE.matcher(text.strip());
        return choice.matches()
                ? ids(choice.group(1))
                        .map(ids -> List.of(new AttributeValue.DrawnValue(stream, new DrawRange.Words(ids))))
                : ids(text.strip()).map(ValueSyntax::fixed);
    }

    /** The form of a list of ids, for error messages. */
    static final String ID_LIST_RULE =
            "ids with blanks between them, with whole ids in double quotes; at most " + MAX_VALUES + " of them";

    /**
     * {@return a list of ids as it is written in a plan, with blanks between the ids} Only ids that contain blanks are
     * in quotes.
     *
     * @param ids the ids, without double quotes
     */
    static String formatIdList(List<String> ids) {
        return ids.stream()
                .map(id -> BLANK.matcher(id).find() ? '"' + id + '"' : id)
                .collect(Collectors.joining(" "));
    }

    /**
     * {@return the different ids of a list of ids, which may be empty; no result if the list has too many of them, or
     * quotes that are not around whole ids}
     *
     * @param text the text in the plan
     */
    static Optional<List<String>> parseIdList(String text) {
        return ids(text.strip());
    }

    /**
     * {@return a set of sensors as it is written in results: the word none for no sensor} A sensor whose id is that
     * word is in quotes if it is the only one.
     *
     * @param sensors the ids, without double quotes
     */
    public static String formatSensorSet(List<String> sensors) {
        String list = formatIdList(sensors);
        return sensors.isEmpty() ? NO_SENSOR : list.equals(NO_SENSOR) ? '"' + list + '"' : list;
    }

    /**
     * {@return the sensors of a set, empty for a text that is no set}
     *
     * @param text the text in results
     */
    public static Set<String> parseSensorSet(String text) {
        return text.equals(NO_SENSOR)
                ? Set.of()
                : new LinkedHashSet<>(parseIdList(text).orElse(List.of()));
    }

    /** Returns the different ids of a text; empty if it has too many, or quotes that are not around whole ids. */
    private static Optional<List<String>> ids(String text) {
        Matcher id = ID.matcher(text);
        Set<String> different = new LinkedHashSet<>();
        int end = 0;
        for (int count = 0; end < text.length(); end = id.end(), count++) {
            if (count == MAX_VALUES || !id.find(end) || id.start() > end) {
                return Optional.empty();
            }
            different.add(id.group(1) == null ? id.group(2) : id.group(1));
        }
        return Optional.of(List.copyOf(different));
    }

    private static List<AttributeValue> fixed(List<String> texts) {
        return texts.stream()
                .<AttributeValue>map(AttributeValue.FixedValue::new)
                .toList();
    }

    /** Returns the different words of a text; empty if it has too many words, or a list in another notation. */
    private static Optional<List<String>> words(String text, boolean isText) {
        String[] words = text.strip().split("\\s+", MAX_VALUES + 1);
        if (words.length > MAX_VALUES) {
            return Optional.empty();
        }
        Map<Object, String> different = new LinkedHashMap<>();
        for (String word : words) {
            if (!isText && OTHER_NOTATION.matcher(word).matches()) {
                return Optional.empty();
            }
            Optional<BigDecimal> number = isText ? Optional.empty() : DecimalText.parse(word);
            different.putIfAbsent(number.isPresent() ? number.get().stripTrailingZeros() : word, word);
        }
        return Optional.of(List.copyOf(different.values()));
    }

    private static Optional<List<AttributeValue>> parseInterval(Matcher interval, String stream) {
        Bounds bounds = bounds(interval).filter(Bounds::isAscending).orElse(null);
        if (bounds == null) {
            return Optional.empty();
        }
        for (String bound : List.of(interval.group(1), interval.group(2))) {
            if (Double.isInfinite(new BigDecimal(bound).doubleValue())) {
                // The number is beyond the limits of every attribute, so the check of the attribute reports this bound.
                return Optional.of(fixed(List.of(bound)));
            }
        }
        if (interval.group(3) == null) {
            return Optional.of(
                    List.of(new AttributeValue.DrawnValue(stream, new DrawRange.Uniform(bounds.from(), bounds.to()))));
        }
        int count = Integer.parseInt(interval.group(3));
        return count < 2 || count > MAX_VALUES
                ? Optional.empty()
                : Optional.of(evenlySpaced(bounds.from(), bounds.to(), count));
    }

    /** Returns evenly spaced values including both bounds, exact to twelve digits. */
    private static List<AttributeValue> evenlySpaced(BigDecimal from, BigDecimal to, int count) {
        BigDecimal difference = to.subtract(from);
        return new ListOnDemand<>(count, index -> {
            BigDecimal step =
                    difference.multiply(BigDecimal.valueOf(index)).divide(BigDecimal.valueOf(count - 1), TWELVE_DIGITS);
            return new AttributeValue.FixedValue(
                    DecimalText.format(from.add(step).doubleValue()));
        });
    }
}
