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
        return content.startsWith("{") || value.startsWith("[");
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

    /** Returns the index of the next character outside of quotes. A quote begins only where a scalar may begin. */
    static int next(String text, int index) {
        char c = text.charAt(index);
        boolean isQuote = (c == '"' || c == '\'') && (index == 0 || " \t\n,:[{".indexOf(text.charAt(index - 1)) >= 0);
        return isQuote ? Math.min(text.length(), MapYamlScalar.closing(text, index) + 1) : index + 1;
    }
}
