package faultline.floorplan;

import java.util.ArrayList;
import java.util.List;

/** Splits YAML text in brackets and braces, which may continue over several lines. */
final class MapYamlFlow {

    private MapYamlFlow() {}

    /**
     * An entry of a mapping in braces.
     *
     * @param text the entry without surrounding blanks
     * @param index the index of its first character in the mapping
     */
    record FlowEntry(String text, int index) {}

    /** Returns whether a line begins a mapping in braces, or a list in brackets after its key. */
    static boolean begins(String line) {
        String content = line.strip();
        String value = content.substring(content.indexOf(':') + 1).strip();
        return content.startsWith("{") || MapYamlScalar.withoutProperties(value).startsWith("[");
    }

    /** Returns how many more brackets and braces a line opens than it closes. */
    static int depth(String line) {
        int depth = 0;
        for (int i = 0; i < line.length(); i = next(line, i)) {
            depth += depthChange(line.charAt(i));
        }
        return depth;
    }

    /** Returns the entries of a text that begins and ends with a brace. */
    static List<FlowEntry> parts(String text) {
        List<FlowEntry> parts = new ArrayList<>();
        int end = text.lastIndexOf('}');
        int begin = text.indexOf('{') + 1;
        int depth = 0;
        for (int i = begin; i < end; i = next(text, i)) {
            depth += depthChange(text.charAt(i));
            if (depth == 0 && text.charAt(i) == ',') {
                addPart(text, begin, i, parts);
                begin = i + 1;
            }
        }
        addPart(text, begin, end, parts);
        return parts;
    }

    private static void addPart(String text, int from, int end, List<FlowEntry> parts) {
        int begin = from;
        while (begin < end && Character.isWhitespace(text.charAt(begin))) {
            begin++;
        }
        if (begin < end) {
            parts.add(new FlowEntry(text.substring(begin, end).strip(), begin));
        }
    }

    private static int depthChange(char c) {
        return c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
    }

    /** Returns the index of the quotation mark that no other one closes, given where to begin; -1 if there is none. */
    static int openQuote(CharSequence line, int from) {
        for (int i = from; i < line.length() && !isComment(line, i); i = next(line, i)) {
            if (isQuote(line, i) && MapYamlScalar.closing(line, line.charAt(i), i + 1) == line.length()) {
                return i;
            }
        }
        return -1;
    }

    /**
     * Returns whether a character outside of quotes begins a comment: a number sign at the beginning or after a blank.
     */
    static boolean isComment(CharSequence text, int index) {
        return text.charAt(index) == '#' && (index == 0 || Character.isWhitespace(text.charAt(index - 1)));
    }

    /** Returns the index of the next character outside of quotes. */
    static int next(CharSequence text, int index) {
        return isQuote(text, index)
                ? Math.min(text.length(), MapYamlScalar.closing(text, text.charAt(index), index + 1) + 1)
                : index + 1;
    }

    /** Returns whether a character begins a text in quotes. It does so only where a scalar may begin. */
    private static boolean isQuote(CharSequence text, int index) {
        if (text.charAt(index) != '"' && text.charAt(index) != '\'') {
            return false;
        }
        int before = index - 1;
        while (before >= 0 && Character.isWhitespace(text.charAt(before))) {
            before--;
        }
        if (before < 0 || ",:[{".indexOf(text.charAt(before)) >= 0) {
            return true;
        }
        return before < index - 1 && isBeforeScalar(text, before);
    }

    /** Returns whether the word that ends at an index may be before a scalar: a mark, a tag or an anchor. */
    private static boolean isBeforeScalar(CharSequence text, int end) {
        int begin = end;
        while (begin > 0 && !Character.isWhitespace(text.charAt(begin - 1))) {
            begin--;
        }
        return "!&".indexOf(text.charAt(begin)) >= 0 || begin == end && "-?".indexOf(text.charAt(end)) >= 0;
    }
}
