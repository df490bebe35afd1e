package faultline.scenario.xml;

import faultline.io.XmlText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** An element that is written, with its attributes and children in their order. */
final class WrittenElement {

    private final String name;
    private final Map<String, String> attributes = new LinkedHashMap<>();
    private final List<WrittenElement> children = new ArrayList<>();
    /** Null for an element that may have children. */
    private String text;

    WrittenElement(String name) {
        this.name = name;
    }

    void addAttribute(String attribute, String value) {
        attributes.put(attribute, value);
    }

    void addChild(WrittenElement child) {
        children.add(child);
    }

    void setText(String content) {
        text = content;
    }

    String name() {
        return name;
    }

    /** Returns what the element is known by; all its attributes and children have been added. */
    ElementKey key() {
        return ElementKey.of(
                name,
                attributes,
                children.stream().map(child -> ElementKey.id(child.attributes)).filter(id -> !id.isEmpty()));
    }

    List<WrittenElement> children() {
        return children;
    }

    /** Returns whether the element contains only text. */
    boolean isText() {
        return text != null;
    }

    /** Returns the escaped text. */
    String escapedText() {
        return XmlText.escapeText(text);
    }

    /** Returns the start tag without its closing bracket. */
    String startTag() {
        StringBuilder tag = new StringBuilder("<").append(name);
        attributes.forEach((attribute, value) -> tag.append(' ')
                .append(attribute)
                .append("=\"")
                .append(XmlText.escapeAttribute(value))
                .append('"'));
        return tag.toString();
    }
}
