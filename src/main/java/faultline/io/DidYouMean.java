package faultline.io;

import java.util.Collection;
import java.util.Locale;
import java.util.Optional;

/** Suggests a known name for a misspelt one. */
public final class DidYouMean {

    private static final int MAX_LENGTH = 60;

    /**
     * The maximum number of pairs of letters that are compared, which limits the time to milliseconds: a few hundred
     * names of the maximum length, or many thousand short ones.
     */
    private static final int MAX_COMPARED = 1_000_000;

    private DidYouMean() {}

    /**
     * {@return a question to append to a problem, such as {@code ; did you mean "left"?}; empty if no known name is
     * similar}
     *
     * @param given the unknown name
     * @param known the known names
     */
    public static String hint(String given, Collection<String> known) {
        return nearest(given, known)
                .map(name -> "; did you mean " + MessageText.quoted(name) + "?")
                .orElse("");
    }

    /**
     * {@return the first of the known names that are most similar to another, ignoring case} Empty if all of them
     * differ by more than one change in three letters, or by more than a single change if the name is shorter.
     *
     * @param given the unknown name
     * @param known the known names
     */
    public static Optional<String> nearest(String given, Collection<String> known) {
        if (given.length() > MAX_LENGTH) {
            return Optional.empty();
        }
        String lower = given.toLowerCase(Locale.ROOT);
        int least = Math.max(1, given.length() / 3) + 1;
        Optional<String> best = Optional.empty();
        int compared = 0;
        for (String name : known) {
            if (Math.abs(name.length() - given.length()) >= least) {
                continue;
            }
            compared += (given.length() + 1) * (name.length() + 1);
            if (compared > MAX_COMPARED) {
                return best;
            }
            int changes = editDistance(lower, name.toLowerCase(Locale.ROOT));
            if (changes < least) {
                least = changes;
                best = Optional.of(name);
            }
        }
        return best;
    }

    /**
     * Returns the optimal string alignment distance: the number of letters to insert, delete, replace or swap with
     * their neighbour.
     */
    static int editDistance(String a, String b) {
        int[][] cost = new int[a.length() + 1][b.length() + 1];
        for (int i = 0; i <= a.length(); i++) {
            for (int j = 0; j <= b.length(); j++) {
                cost[i][j] = i == 0 || j == 0 ? i + j : minCost(a, b, i, j, cost);
            }
        }
        return cost[a.length()][b.length()];
    }

    private static int minCost(String a, String b, int i, int j, int[][] cost) {
        int exchange = cost[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        int best = Math.min(exchange, Math.min(cost[i - 1][j], cost[i][j - 1]) + 1);
        boolean swapped = i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
        return swapped ? Math.min(best, cost[i - 2][j - 2] + 1) : best;
    }
}
