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

    /** Longest literal text first, because the text of a longer message may match an argument of a shorter one. */
    private static final List<MessagePattern> PATTERNS = Messages.keys(Language.ENGLISH)
            .filter(key -> KEY_PREFIXES.stream().anyMatch(key::startsWith))
            .map(MessagePattern::of)
            .sorted(Comparator.comparing(MessagePattern::literalLength)
                    .reversed()
                    .thenComparing(MessagePattern::key))
            .toList();

    private MessageTranslator() {}

    /**
     * A message that is recognised by its text.
     *
     * @param key the key of the message
     * @param pattern the text, with a group for each placeholder
     * @param groupIndexes the placeholder index of each group
     * @param verbatim whether each group is quoted or a name, and therefore not translated
     * @param literalLength the number of characters outside placeholders
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
                // A quoted value may contain the text that follows it; other values do not.
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
     * Translates a sentence.
     *
     * @param sentence the English sentence
     * @return the sentence in the user's language, or unchanged if it is not known
     */
    public static String translate(String sentence) {
        return PATTERNS.stream()
                .flatMap(known -> translateIfMatching(known, sentence))
                .findFirst()
                .orElse(sentence);
    }

    private static Stream<String> translateIfMatching(MessagePattern known, String sentence) {
        Matcher match = known.pattern().matcher(sentence);
        return match.matches() ? Stream.of(known.translateMatch(match)) : Stream.empty();
    }
}
