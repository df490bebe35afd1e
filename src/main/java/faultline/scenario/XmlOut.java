package faultline.scenario;

import java.util.ArrayDeque;
import java.util.Deque;

/** Writes indented XML: one element a line, attributes in the order in which they are given. */
final class XmlOut {

    private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private final Deque<String> open = new ArrayDeque<>();
    private boolean inStartTag;

    /** Begins an element. */
    XmlOut begin(String name) {
        endStartTag();
        indent();
        out.append('<').append(name);
        open.push(name);
        inStartTag = true;
        return this;
    }

    XmlOut set(String name, String value) {
        out.append(' ').append(name).append("=\"").append(XmlText.attribute(value)).append('"');
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
        String name = open.pop();
        if (inStartTag) {
            out.append("/>\n");
            inStartTag = false;
        } else {
            indent();
            out.append("</").append(name).append(">\n");
        }
        return this;
    }

    /** A whole element that holds text only. */
    void text(String name, String text) {
        endStartTag();
        indent();
        out.append('<').append(name).append('>').append(XmlText.element(text)).append("</").append(name).append(">\n");
    }

    private void endStartTag() {
        if (inStartTag) {
            out.append(">\n");
            inStartTag = false;
        }
    }

    private void indent() {
        out.append("  ".repeat(open.size()));
    }

    @Override
    public String toString() {
        return out.toString();
    }
}
