package faultline.scenario.xml;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Damages texts of XML at random: characters, values of attributes, whole elements, the end of the file, bytes. */
public final class FileMutator {

    private static final Pattern ATTRIBUTE = Pattern.compile("[\\w:]+=\"([^\"]*)\"");
    private static final Pattern ELEMENT = Pattern.compile("<\\w+[^<>]*/>");

    private static final Pattern EMPTY_ELEMENT = Pattern.compile("<(\\w+)[^<>]*/>");
    private static final List<String> CONTENTS =
            List.of("", " ", "\n", "&#32;", "<![CDATA[]]>", "<![CDATA[ ]]>", "<!-- -->", " <?x?>", "x", "<x/>");

    private static final List<String> PIECES = List.of(
            "\"",
            "<",
            ">",
            "/",
            "&",
            "&#0;",
            "]]>",
            "<!--",
            "-->",
            "\0",
            "\n",
            "é",
            "-",
            "e9",
            ".",
            "1e308",
            "NaN",
            "id",
            " x=\"1\"",
            " xml:lang=\"en\"",
            " xmlns:xsi=\"a\" xsi:schemaLocation=\"a b\"",
            "<robot x=\"1\" y=\"1\"/>",
            "<world/>",
            "<?x?>",
            "xmlns=\"a\"",
            "'",
            " ");

    private static final List<String> VALUES = List.of(
            "",
            " ",
            "0",
            "-0",
            "-1",
            "1e-320",
            "0." + "0".repeat(330) + "1",
            "9".repeat(400),
            "1e308",
            "-1e308",
            "1e15",
            "9007199254740993",
            "NaN",
            "INF",
            "0x1p3",
            "1d",
            "\u0661",
            "\u202e1",
            "&#9;1&#10;",
            "1,1",
            "0,0 1,1",
            "0,0 0,0 0,0",
            "true",
            "?",
            "none",
            "SEARCH ".repeat(200),
            "x".repeat(5000));

    /** The system property {@code faultline.fuzz.seed} sets another seed, which does other damage. */
    private final SplittableRandom random = new SplittableRandom(Long.getLong("faultline.fuzz.seed", 7));

    /** Returns a text with one to three small changes of any kind. */
    public byte[] damaged(String original) {
        String text = original;
        for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
            text = change(text);
        }
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        if (bytes.length > 0 && random.nextInt(20) == 0) {
            bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
        }
        return bytes;
    }

    /** Returns one of some elements. */
    public <T> T pick(List<T> elements) {
        return elements.get(random.nextInt(elements.size()));
    }

    private String change(String text) {
        return switch (random.nextInt(9)) {
            case 0 -> text.substring(0, random.nextInt(text.length() + 1));
            case 1 -> withAnother(text, ELEMENT, 0);
            case 2 -> without(text, ELEMENT);
            case 3 -> without(text, ATTRIBUTE);
            case 4 -> withAnother(text, ATTRIBUTE, 1);
            case 5 -> replaced(text, ATTRIBUTE, 1, pick(VALUES));
            case 6 -> withContent(text, pick(CONTENTS));
            default -> withPiece(text, pick(PIECES));
        };
    }

    private String withPiece(String text, String piece) {
        int at = random.nextInt(text.length() + 1);
        int end = Math.min(text.length(), at + random.nextInt(4));
        return text.substring(0, at) + (random.nextInt(4) == 0 ? "" : piece) + text.substring(end);
    }

    /** Gives an empty element a content. */
    private String withContent(String text, String content) {
        List<MatchResult> all = EMPTY_ELEMENT.matcher(text).results().toList();
        if (all.isEmpty()) {
            return text;
        }
        MatchResult match = pick(all);
        return text.substring(0, match.end() - 2) + ">" + content + "</" + match.group(1) + ">"
                + text.substring(match.end());
    }

    private String without(String text, Pattern pattern) {
        return replaced(text, pattern, 0, "");
    }

    /** Puts one match in the place of another. */
    private String withAnother(String text, Pattern pattern, int group) {
        List<MatchResult> all = pattern.matcher(text).results().toList();
        return all.isEmpty() ? text : replaced(text, pattern, group, pick(all).group(group));
    }

    private String replaced(String text, Pattern pattern, int group, String by) {
        List<MatchResult> all = pattern.matcher(text).results().toList();
        if (all.isEmpty()) {
            return text;
        }
        MatchResult match = pick(all);
        return text.substring(0, match.start(group)) + by + text.substring(match.end(group));
    }
}
