package faultline.campaign.run;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A part of a campaign: consecutive runs. All parts have about the same number of runs.
 *
 * @param number the number, from 1 to {@code count}
 * @param count the number of parts
 */
public record Shard(int number, int count) {

    /** The whole campaign. */
    public static final Shard ALL = new Shard(1, 1);

    private static final Pattern SYNTAX = Pattern.compile("(\\d{1,7})/(\\d{1,7})");

    /**
     * Creates a part.
     *
     * @param number the number, from 1 to {@code count}
     * @param count the number of parts
     * @throws IllegalArgumentException if the number is less than 1 or greater than the count
     */
    public Shard {
        if (number < 1 || number > count) {
            throw new IllegalArgumentException("there is no part " + number + " of " + count);
        }
    }

    /**
     * {@return the part that a text such as {@code 2/4} names; empty if it names none}
     *
     * @param text the text
     */
    public static Optional<Shard> parse(String text) {
        Matcher matcher = SYNTAX.matcher(text);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        int number = Integer.parseInt(matcher.group(1));
        int count = Integer.parseInt(matcher.group(2));
        return number < 1 || number > count ? Optional.empty() : Optional.of(new Shard(number, count));
    }

    /** {@return the first run of this part, of a campaign with a number of runs} */
    long firstRun(long runs) {
        return runs * (number - 1) / count;
    }

    /** {@return the run after the last one of this part} */
    long endRun(long runs) {
        return runs * number / count;
    }

    @Override
    public String toString() {
        return number + "/" + count;
    }
}
