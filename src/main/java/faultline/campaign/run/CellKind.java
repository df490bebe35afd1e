package faultline.campaign.run;

import faultline.io.DecimalText;
import faultline.io.Message;
import java.util.Locale;
import java.util.Set;
import java.util.function.DoublePredicate;
import java.util.function.Predicate;

/** The kinds of the columns of results, by what their cells can be. */
enum CellKind {
    /** Any text; the outcome, the flags and the duration, which {@link RowCheck} checks, are among them. */
    TEXT(ResultsProblem.NOTHING.with(), text -> true),
    /** A share, or nothing. */
    SHARE(ResultsProblem.SHARE.with(), numbers(number -> number >= 0 && number <= 1)),
    /** A time, a distance or another number that is not negative, or nothing. */
    SIZE(ResultsProblem.SIZE.with(), numbers(CellKind::isSize)),
    /** A whole number, or nothing. */
    COUNT(ResultsProblem.COUNT.with(), numbers(number -> isSize(number) && number == Math.rint(number))),
    /** The hash of a trajectory; nothing in a run that failed. */
    HASH(ResultsProblem.HASH.with(), CellKind::isHash);

    private static final int HASH_LENGTH = 16;

    /** Other programs write these for a missing value. */
    private static final Set<String> MISSING =
            Set.of("na", "nan", "null", "none", "inf", "-inf", "infinity", "-infinity");

    private final Message expected;
    private final Predicate<String> cells;

    CellKind(Message expected, Predicate<String> cells) {
        this.expected = expected;
        this.cells = cells;
    }

    /** Returns the cells of a kind of numbers, given which of these it has. NaN stands for a text that is no number. */
    private static Predicate<String> numbers(DoublePredicate numbers) {
        return text -> text.isEmpty() || numbers.test(number(text));
    }

    private static boolean isSize(double number) {
        return number >= 0 && number < Double.POSITIVE_INFINITY;
    }

    private static boolean isHash(String text) {
        return text.isEmpty()
                || text.length() == HASH_LENGTH
                        && text.chars().allMatch(c -> c >= '0' && c <= '9' || c >= 'a' && c <= 'f');
    }

    /** Returns what a cell can be, as the end of a sentence. */
    Message expected() {
        return expected;
    }

    /** Returns whether the program can have written a cell. */
    boolean contains(String text) {
        return cells.test(text);
    }

    /**
     * Returns whether a cell can be used that another program may have written; a number that is not finite is missing.
     */
    boolean isUsable(String text) {
        return contains(text)
                || MISSING.contains(text.toLowerCase(Locale.ROOT))
                || this != HASH && Double.isInfinite(number(text));
    }

    /**
     * Returns the value of a decimal number, infinite if it is beyond all doubles; NaN for any other text. A zero keeps
     * its sign.
     */
    static double number(String text) {
        double number = DecimalText.parseShort(text);
        return Double.isNaN(number)
                ? DecimalText.parse(text)
                        .map(exact -> DecimalText.toDouble(exact, text))
                        .orElse(Double.NaN)
                : number;
    }
}
