package faultline.scenario.xml;

import faultline.io.DecimalText;
import faultline.io.XmlText;
import faultline.scenario.xml.XmlComments.XmlComment;
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
 * Writes indented XML: one element to a line, attributes in the given order, and a person's comments at their places. A
 * start tag is buffered until it is complete, because the comments before it depend on its id.
 */
public final class XmlWriter {

    private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private final StringBuilder startTag = new StringBuilder();
    private final Deque<String> openElements = new ArrayDeque<>();
    private final ElementPath path = new ElementPath();
    /** The comments by anchor. */
    private final NavigableMap<String, List<XmlComment>> unwrittenComments;

    private String id = "";

    /**
     * Creates a writer of one file.
     *
     * @param comments the comments that a person has put into it
     */
    public XmlWriter(XmlComments comments) {
        unwrittenComments = comments.comments().stream()
                .collect(Collectors.groupingBy(XmlComment::anchor, TreeMap::new, Collectors.toList()));
    }

    /**
     * Begins an element.
     *
     * @param name its name
     * @return this writer
     */
    public XmlWriter beginElement(String name) {
        finishStartTag(">\n");
        startTag.append('<').append(name);
        openElements.push(name);
        return this;
    }

    /**
     * Adds an attribute to the element that was begun last.
     *
     * @param name its name
     * @param value its value
     * @return this writer
     */
    public XmlWriter attribute(String name, String value) {
        if (name.equals("id")) {
            id = value;
        }
        startTag.append(' ')
                .append(name)
                .append("=\"")
                .append(XmlText.escapeAttribute(value))
                .append('"');
        return this;
    }

    /**
     * Adds a number as {@link #attribute(String, String)} does.
     *
     * @param name the name of the attribute
     * @param value its value
     * @return this writer
     */
    public XmlWriter attribute(String name, double value) {
        return attribute(name, DecimalText.format(value));
    }

    /**
     * Adds a truth value as {@link #attribute(String, String)} does.
     *
     * @param name the name of the attribute
     * @param value its value
     * @return this writer
     */
    public XmlWriter attribute(String name, boolean value) {
        return attribute(name, String.valueOf(value));
    }

    /**
     * Adds an angle in degrees as {@link #attribute(String, String)} does.
     *
     * @param name the name of the attribute
     * @param radians the angle, in radians
     * @return this writer
     */
    public XmlWriter angleAttribute(String name, double radians) {
        return attribute(name, DecimalText.formatDegrees(radians));
    }

    /**
     * Ends the innermost element.
     *
     * @return this writer
     */
    public XmlWriter endElement() {
        boolean empty = !startTag.isEmpty();
        if (empty) {
            writeStartTag();
            empty = commentsInside().isEmpty();
            out.append(empty ? "/>\n" : ">\n");
        }
        String name = closeElement();
        if (!empty) {
            indent(openElements.size());
            out.append("</").append(name).append(">\n");
        }
        if (openElements.isEmpty()) {
            writeRemainingComments();
        }
        return this;
    }

    /**
     * Ends the innermost element, which contains only text.
     *
     * @param text the text
     */
    public void endTextElement(String text) {
        String name = openElements.peek();
        finishStartTag(">");
        out.append(XmlText.escapeText(text)).append("</").append(name).append(">\n");
        openElements.pop();
        path.leave();
    }

    private void finishStartTag(String end) {
        if (!startTag.isEmpty()) {
            writeStartTag();
            out.append(end);
        }
    }

    /** Writes the buffered start tag without its closing bracket. */
    private void writeStartTag() {
        path.enter(openElements.peek(), id);
        id = "";
        Optional.ofNullable(unwrittenComments.remove(path.current()))
                .ifPresent(before -> writeComments(before, openElements.size() - 1));
        indent(openElements.size() - 1);
        out.append(startTag);
        startTag.setLength(0);
    }

    private String closeElement() {
        writeRemainingComments();
        path.leave();
        return openElements.pop();
    }

    /** Writes the comments that are left in the open element. */
    private void writeRemainingComments() {
        writeComments(
                commentsInside().values().stream()
                        .flatMap(List::stream)
                        .sorted(Comparator.comparingInt(XmlComment::index))
                        .toList(),
                openElements.size());
        commentsInside().clear();
    }

    /** Returns the comments whose anchors begin with the path of the open element and a slash. */
    private Map<String, List<XmlComment>> commentsInside() {
        return unwrittenComments.subMap(path.current() + "/", path.current() + (char) ('/' + 1));
    }

    private void writeComments(List<XmlComment> some, int depth) {
        for (XmlComment comment : some) {
            indent(depth);
            out.append("<!--").append(comment.text()).append("-->\n");
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
