package faultline.gui.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What the packages below say, in the user's language: what is wrong with a file. They say it in English, as journals,
 * reports and the command line keep it; here each sentence, and each phrase within one, is known by its English text.
 */
public final class MessageTranslator {

    /** The keys of all texts that are known by their wording begin like one of these. */
    private static final List<String> KEY_PREFIXES = List.of("complaint.", "allowed.");

    private static final Pattern PLACEHOLDER = Pattern.compile("([\"<]?)\\{(\\d)}");

    /** Those that say most come first, because others would take their words for what fills a gap. */
    private static final List<MessagePattern> PATTERNS = Messages.keys(Language.ENGLISH)
            .filter(key -> KEY_PREFIXES.stream().anyMatch(key::startsWith))
            .map(MessagePattern::of)
            .sorted(Comparator.comparing(MessagePattern::literalLength)
                    .reversed()
                    .thenComparing(MessagePattern::key))
            .toList();

    private MessageTranslator() {}

    /**
     * A text that is known by its wording.
     *
     * @param key of the text
     * @param pattern with a group for each gap
     * @param groupIndexes which gap each group is
     * @param verbatim whether each group is somebody's own words or a name, as those in quotes and angle brackets are:
     *     never translated
     * @param literalLength how many letters are not in gaps
     */
    private record MessagePattern(
            String key, Pattern pattern, List<Integer> groupIndexes, List<Boolean> verbatim, int literalLength) {

        static MessagePattern of(String key) {
            String text = Messages.get(Language.ENGLISH, key).replace("''", "'");
            StringBuilder pattern = new StringBuilder();
            List<Integer> gaps = new ArrayList<>();
            List<Boolean> quoted = new ArrayList<>();
            Matcher gap = PLACEHOLDER.matcher(text);
            int end = 0;
            for (; gap.find(); end = gap.end()) {
                // Somebody's own words may hold what follows them; what we say after them does not.
                pattern.append(Pattern.quote(text.substring(end, gap.end(1))))
                        .append(gap.group(1).equals("\"") ? "(.*)" : "(.*?)");
                gaps.add(Integer.valueOf(gap.group(2)));
                quoted.add(!gap.group(1).isEmpty());
            }
            pattern.append(Pattern.quote(text.substring(end)));
            return new MessagePattern(
                    key, Pattern.compile(pattern.toString()), gaps, quoted, text.length() - 3 * gaps.size());
        }

        private String translateMatch(Matcher match) {
            String[] values = new String[groupIndexes.size()];
            for (int i = 0; i < values.length; i++) {
                String value = match.group(i + 1);
                values[groupIndexes.get(i)] = verbatim.get(i) ? value : translate(value);
            }
            return Messages.get(key, values);
        }
    }

    /**
     * A sentence for people.
     *
     * @param said as a floor below says it
     * @return the same in the user's language; one of another wording as it is
     */
    public static String translate(String said) {
        return PATTERNS.stream()
                .flatMap(known -> translateIfMatching(known, said))
                .findFirst()
                .orElse(said);
    }

    private static Stream<String> translateIfMatching(MessagePattern known, String said) {
        Matcher match = known.pattern().matcher(said);
        return match.matches() ? Stream.of(known.translateMatch(match)) : Stream.empty();
    }
}
