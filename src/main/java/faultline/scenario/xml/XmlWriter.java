package faultline.scenario.xml;

import faultline.io.DecimalText;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Writes indented XML: one element to a line, attributes in the given order, and a person's comments at their places.
 * The elements are collected first, because the places of comments depend on all elements beside them.
 */
public final class XmlWriter {

    private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private final Deque<WrittenElement> openElements = new ArrayDeque<>();
    private final XmlComments comments;

    /**
     * Creates a writer of one file.
     *
     * @param comments the comments that a person has put into it
     */
    public XmlWriter(XmlComments comments) {
        this.comments = comments;
    }

    /**
     * Begins an element.
     *
     * @param name its name
     * @return this writer
     */
    public XmlWriter beginElement(String name) {
        WrittenElement element = new WrittenElement(name);
        if (!openElements.isEmpty()) {
            openElements.element().addChild(element);
        }
        openElements.push(element);
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
        openElements.element().addAttribute(name, value);
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
        WrittenElement element = openElements.pop();
        if (openElements.isEmpty()) {
            writeChildren(List.of(element), comments.document(), 0);
        }
        return this;
    }

    /**
     * Ends the innermost element, which contains only text.
     *
     * @param text the text
     */
    public void endTextElement(String text) {
        openElements.pop().setText(text);
    }

    /** Writes elements that have replaced the children of an element, and the comments that are left at the end. */
    private void writeChildren(List<WrittenElement> children, CommentedElement parent, int depth) {
        ElementMatch match = new ElementMatch(parent.children(), children);
        for (WrittenElement child : children) {
            writeComments(match.before(child).before(), depth);
            write(child, match.before(child), depth);
        }
        Set<CommentedElement> containers = children.stream()
                .filter(child -> !child.isText())
                .map(match::before)
                .collect(Collectors.toSet());
        for (CommentedElement old : parent.children()) {
            writeComments(match.isMatched(old) ? List.of() : old.before(), depth);
            writeComments(containers.contains(old) ? List.of() : old.inside(), depth);
        }
        writeComments(parent.atEnd(), depth);
    }

    private void write(WrittenElement element, CommentedElement before, int depth) {
        indent(depth);
        out.append(element.startTag());
        if (element.isText()) {
            out.append('>').append(element.escapedText());
        } else if (element.children().isEmpty() && before.inside().isEmpty()) {
            out.append("/>\n");
            return;
        } else {
            out.append(">\n");
            writeChildren(element.children(), before, depth + 1);
            indent(depth);
        }
        out.append("</").append(element.name()).append(">\n");
    }

    private void writeComments(List<String> texts, int depth) {
        for (String text : texts) {
            indent(depth);
            out.append("<!--").append(text).append("-->\n");
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
