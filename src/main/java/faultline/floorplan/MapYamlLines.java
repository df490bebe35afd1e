package faultline.floorplan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/**
 * Divides the text of a YAML file into the lines of its outer mapping. A value that continues over several lines is one
 * line. The content of a key that map_server does not know, such as a mapping or a text, is left out.
 */
final class MapYamlLines {

    static final String LINE_BREAK = "\r\n|[\r\n]";

    /** A key with a colon, as opposed to the continuation of a value. */
    private static final Pattern ENTRY = Pattern.compile("[\\w\"']+\\s*:(\\s.*)?", Pattern.DOTALL);

    private static final int NONE = Integer.MAX_VALUE;
    /** Less than any indentation. */
    private static final int ANY = -1;

    private final String[] source;
    private final List<String> keys;
    private final List<YamlLine> lines = new ArrayList<>();
    /**
     * For each mark, and each line that is in a text which the mark begins: an indentation that did not suffice for
     * such a text to end.
     */
    private final Map<Character, int[]> unclosed;
    /** The index of the next line of the file. */
    private int next;

    /**
     * A line of the outer mapping.
     *
     * @param number its number in the file, or that of its first part
     * @param text the text without comments; the parts of a value over several lines are separated by line breaks
     */
    record YamlLine(int number, String text) {}

    private MapYamlLines(String text, List<String> keys) {
        this.source = text.split(LINE_BREAK, -1);
        this.keys = keys;
        unclosed = Map.of('"', newIndents(), '\'', newIndents());
    }

    private int[] newIndents() {
        int[] indents = new int[source.length];
        Arrays.fill(indents, NONE);
        return indents;
    }

    /** Returns the lines of a text, given the keys that map_server knows. */
    static List<YamlLine> of(String text, List<String> keys) {
        MapYamlLines reader = new MapYamlLines(text, keys);
        reader.read();
        return reader.lines;
    }

    private void read() {
        int ignoredIndent = NONE;
        while (next < source.length) {
            int number = next + 1;
            source[next] = source[next].replaceFirst("^---(?=\\s)", "   ");
            int indent = indent(source[next]);
            if (indent > ignoredIndent || indent == ignoredIndent && isItem(source[next])) {
                next++;
                continue;
            }
            String line = nextLine(MapYamlFlow.begins(source[next]) ? ANY : indent);
            if (line.isBlank()) {
                continue;
            }
            String joined = joinValue(joinFlow(line), indent);
            ignoredIndent = isUnknown(joined) ? indent : NONE;
            lines.add(new YamlLine(number, joined));
        }
    }

    /**
     * Returns the next line without its comment, together with the lines over which a text in quotes continues. They
     * are indented by more than the given number of blanks; otherwise the mark is part of a text without quotes.
     */
    private String nextLine(int indent) {
        int end = next + 1;
        StringBuilder line = new StringBuilder(source[next]);
        StringBuilder marks = new StringBuilder();
        int open = MapYamlFlow.openQuote(line, 0);
        while (open >= 0 && continues(end, indent, line.charAt(open))) {
            marks.append(line.charAt(open));
            int checked = line.length();
            line.append('\n').append(source[end++]);
            int close = MapYamlScalar.closing(line, line.charAt(open), checked);
            open = close < line.length() ? MapYamlFlow.openQuote(line, close + 1) : open;
        }
        if (open >= 0) {
            for (int i = 0; i < marks.length(); i++) {
                unclosed.get(marks.charAt(i))[next + 1 + i] = indent;
            }
            return stripComment(source[next++]);
        }
        next = end;
        return stripComment(line.toString());
    }

    /** Returns whether a text in quotes may continue in a line: if it is indented, and not known to be without end. */
    private boolean continues(int index, int indent, char mark) {
        return index < source.length
                && (source[index].isBlank() || indent(source[index]) > indent)
                && indent < unclosed.get(mark)[index];
    }

    /** Adds the lines up to the one that closes a mapping in braces or a list in brackets. */
    private String joinFlow(String line) {
        if (!MapYamlFlow.begins(line)) {
            return line;
        }
        StringBuilder joined = new StringBuilder(line);
        int open = MapYamlFlow.depth(line);
        while (open > 0 && next < source.length) {
            String more = nextLine(ANY);
            open += MapYamlFlow.depth(more);
            joined.append('\n').append(more);
        }
        return joined.toString();
    }

    /**
     * Adds the following lines that continue the value of a known key, or an item of it. They are indented, and neither
     * a key nor, before a value has begun, an item.
     */
    private String joinValue(String line, int indent) {
        if (!isItem(line) && !keys.contains(key(line))) {
            return line;
        }
        boolean isEmpty = MapYamlScalar.withoutProperties(
                        line.substring(line.indexOf(':') + 1).strip())
                .isEmpty();
        StringBuilder joined = new StringBuilder(line);
        while (next < source.length) {
            int before = next;
            String more = nextLine(indent);
            if (!more.isBlank() && !isContinuation(more, indent, isEmpty)) {
                next = before;
                break;
            }
            if (isEmpty && MapYamlFlow.begins(more)) {
                return joinFlow(line + " " + more.strip());
            }
            if (!more.isBlank()) {
                joined.append('\n').append(more.strip());
            }
        }
        return joined.toString();
    }

    private static boolean isContinuation(String line, int indent, boolean mayBeItem) {
        return indent(line) > indent
                && !(mayBeItem && isItem(line))
                && !ENTRY.matcher(line.strip()).matches();
    }

    private boolean isUnknown(String line) {
        return line.indexOf(':') >= 0 && !line.strip().startsWith("{") && !isItem(line) && !keys.contains(key(line));
    }

    private static String key(String line) {
        return MapYamlScalar.read(
                line.substring(0, Math.max(0, line.indexOf(':'))).strip());
    }

    private static int indent(String line) {
        return line.length() - line.stripLeading().length();
    }

    /** Returns whether a line is an item of a list. */
    static boolean isItem(String line) {
        String content = line.strip();
        return content.startsWith("-") && (content.length() == 1 || Character.isWhitespace(content.charAt(1)));
    }

    /** Removes a comment. */
    private static String stripComment(String line) {
        for (int i = 0; i < line.length(); i = MapYamlFlow.next(line, i)) {
            if (MapYamlFlow.isComment(line, i)) {
                return line.substring(0, i);
            }
        }
        return line;
    }
}
