package faultline.gui.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What the floors below say, in the user's language: why the world refused something, and what is wrong with a file. They say it in English,
 * as journals, reports and the command line keep it; here each sentence, and each phrase within one, is known by its English text.
 */
public final class Wordings {

    /** The keys of all texts that are known by their wording begin like one of these. */
    private static final List<String> KINDS = List.of("refused.", "complaint.", "allowed.");
    private static final Pattern GAP = Pattern.compile("([\"<]?)\\{(\\d)}");
    /** What fills the gaps of these are names. */
    private static final String OF_NAMES = "refused.";

    /** Those that say most come first, because others would take their words for what fills a gap. */
    private static final List<Wording> KNOWN = Texts.keys(Language.ENGLISH).filter(key -> KINDS.stream().anyMatch(key::startsWith))
            .map(Wording::of).sorted(Comparator.comparing(Wording::said).reversed().thenComparing(Wording::key)).toList();

    private Wordings() {
    }

    /**
     * A text that is known by its wording.
     *
     * @param key of the text
     * @param wording with a group for each gap
     * @param gaps which gap each group is
     * @param quoted whether each group is somebody's own words or a name, as those in quotes and angle brackets are: never translated
     * @param said how many letters are not in gaps
     */
    private record Wording(String key, Pattern wording, List<Integer> gaps, List<Boolean> quoted, int said) {

        static Wording of(String key) {
            String text = Texts.text(Language.ENGLISH, key).replace("''", "'");
            StringBuilder pattern = new StringBuilder();
            List<Integer> gaps = new ArrayList<>();
            List<Boolean> quoted = new ArrayList<>();
            Matcher gap = GAP.matcher(text);
            int end = 0;
            for (; gap.find(); end = gap.end()) {
                // Somebody's own words may hold what follows them; what we say after them does not.
                pattern.append(Pattern.quote(text.substring(end, gap.end(1)))).append(gap.group(1).equals("\"") ? "(.*)" : "(.*?)");
                gaps.add(Integer.valueOf(gap.group(2)));
                quoted.add(!gap.group(1).isEmpty() || key.startsWith(OF_NAMES));
            }
            pattern.append(Pattern.quote(text.substring(end)));
            return new Wording(key, Pattern.compile(pattern.toString()), gaps, quoted, text.length() - 3 * gaps.size());
        }

        private String translated(Matcher match) {
            String[] values = new String[gaps.size()];
            for (int i = 0; i < values.length; i++) {
                String value = match.group(i + 1);
                values[gaps.get(i)] = quoted.get(i) ? value : text(value);
            }
            return Texts.text(key, values);
        }
    }

    /**
     * A sentence for people.
     *
     * @param said as a floor below says it
     * @return the same in the user's language; one of another wording as it is
     */
    public static String text(String said) {
        return KNOWN.stream().flatMap(known -> translated(known, said)).findFirst().orElse(said);
    }

    private static Stream<String> translated(Wording known, String said) {
        Matcher match = known.wording().matcher(said);
        return match.matches() ? Stream.of(known.translated(match)) : Stream.empty();
    }
}
