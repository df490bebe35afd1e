package faultline.scenario;

import faultline.scenario.Remarks.Remark;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Writes indented XML: one element a line, attributes in the order in which they are given, and a person's comments where they were. A start
 * tag is held back until it is whole, because the id in it says which comments come before it.
 */
final class XmlOut {

    private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private final StringBuilder startTag = new StringBuilder();
    private final Deque<String> open = new ArrayDeque<>();
    private final ElementPath path = new ElementPath();
    /** By the path that each stands before. */
    private final NavigableMap<String, List<Remark>> unwritten;
    private String id = "";

    XmlOut() {
        this(Remarks.NONE);
    }

    XmlOut(Remarks remarks) {
        unwritten = remarks.all().stream().collect(Collectors.groupingBy(Remark::before, TreeMap::new, Collectors.toList()));
    }

    /** Begins an element. */
    XmlOut begin(String name) {
        endStartTag(">\n");
        startTag.append('<').append(name);
        open.push(name);
        return this;
    }

    XmlOut set(String name, String value) {
        if (name.equals("id")) {
            id = value;
        }
        startTag.append(' ').append(name).append("=\"").append(XmlText.attribute(value)).append('"');
        return this;
    }

    XmlOut set(String name, double value) {
        return set(name, Numbers.toText(value));
    }

    XmlOut set(String name, boolean value) {
        return set(name, String.valueOf(value));
    }

    /** An angle in radians, written in degrees. */
    XmlOut setAngle(String name, double radians) {
        return set(name, Numbers.toDegreesText(radians));
    }

    /** Ends the innermost element. */
    XmlOut end() {
        boolean empty = !startTag.isEmpty();
        if (empty) {
            enter();
            empty = inside().isEmpty();
            out.append(empty ? "/>\n" : ">\n");
        }
        String name = leave();
        if (!empty) {
            indent(open.size());
            out.append("</").append(name).append(">\n");
        }
        if (open.isEmpty()) {
            remarksInside();
        }
        return this;
    }

    /** A whole element that holds text only. */
    void text(String name, String text) {
        begin(name).endStartTag(">");
        out.append(XmlText.element(text)).append("</").append(name).append(">\n");
        open.pop();
        path.leave();
    }

    private void endStartTag(String end) {
        if (!startTag.isEmpty()) {
            enter();
            out.append(end);
        }
    }

    /** Writes what is held back, but for its end. */
    private void enter() {
        path.enter(open.peek(), id);
        id = "";
        Optional.ofNullable(unwritten.remove(path.now())).ifPresent(before -> remarks(before, open.size() - 1));
        indent(open.size() - 1);
        out.append(startTag);
        startTag.setLength(0);
    }

    private String leave() {
        remarksInside();
        path.leave();
        return open.pop();
    }

    /** What is left to be said inside the element that is open. */
    private void remarksInside() {
        remarks(inside().values().stream().flatMap(List::stream).sorted(Comparator.comparingInt(Remark::number)).toList(), open.size());
        inside().clear();
    }

    /** All whose paths begin with that of the open element and a slash. */
    private Map<String, List<Remark>> inside() {
        return unwritten.subMap(path.now() + "/", path.now() + (char) ('/' + 1));
    }

    private void remarks(List<Remark> some, int depth) {
        for (Remark remark : some) {
            indent(depth);
            out.append("<!--").append(remark.text()).append("-->\n");
        }
    }

    private void indent(int depth) {
        out.append("  ".repeat(depth));
    }

    @Override
    public String toString() {
        return out.toString();
    }
}
