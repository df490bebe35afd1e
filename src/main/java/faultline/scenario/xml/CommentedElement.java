package faultline.scenario.xml;

import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * An element of a file with the comments before it and in it. Elements without comments are kept as far as they are
 * needed to find the others in an edited copy of the file.
 */
final class CommentedElement {

    /** A character that no document can contain. */
    private static final char SEPARATOR = 0;

    private final String name;
    private final String key;
    private final String timeKey;
    private final boolean named;
    private final List<String> before;
    private List<CommentedElement> children = new ArrayList<>();
    private List<String> atEnd = List.of();
    private boolean commented;

    /** Creates an open element. */
    CommentedElement(String name, Map<String, String> attributes, List<String> before) {
        this.name = name;
        this.key = keyOf(name, attributes);
        this.timeKey = timeKeyOf(name, attributes);
        this.named = hasId(attributes);
        this.before = List.copyOf(before);
    }

    /** Creates the open root of a document: its children are the root element. */
    static CommentedElement document() {
        return new CommentedElement("", Map.of(), List.of());
    }

    void addChild(CommentedElement child) {
        children.add(child);
    }

    /** Ends the element, given the comments after its last child. */
    void end(List<String> last) {
        atEnd = List.copyOf(last);
        boolean inside = !atEnd.isEmpty() || children.stream().anyMatch(child -> child.commented);
        commented = inside || !before.isEmpty();
        children = inside ? List.copyOf(children) : List.of();
    }

    /** Returns whether elements with some attributes are known by their id. */
    static boolean hasId(Map<String, String> attributes) {
        return !attributes.getOrDefault("id", "").isEmpty();
    }

    /** Returns a text that equals that of another element if both have the same id or, without one, attributes. */
    static String keyOf(String name, Map<String, String> attributes) {
        if (hasId(attributes)) {
            return name + SEPARATOR + attributes.get("id");
        }
        StringBuilder key = new StringBuilder(name);
        new TreeMap<>(attributes)
                .forEach((attribute, value) ->
                        key.append(SEPARATOR).append(attribute).append('=').append(canonical(value)));
        return key.toString();
    }

    /** Returns a text that equals that of another element if both have the same name and, if they are events, time. */
    static String timeKeyOf(String name, Map<String, String> attributes) {
        return name + SEPARATOR + canonical(attributes.getOrDefault("at", ""));
    }

    private static String canonical(String value) {
        return DecimalText.parse(value)
                .map(number -> number.stripTrailingZeros().toString())
                .orElse(value);
    }

    String name() {
        return name;
    }

    /** Returns the text by which {@link #keyOf} compares elements. */
    String key() {
        return key;
    }

    /** Returns the text by which {@link #timeKeyOf} compares elements. */
    String timeKey() {
        return timeKey;
    }

    boolean hasId() {
        return named;
    }

    List<CommentedElement> children() {
        return children;
    }

    /** Returns the comments before the element. */
    List<String> before() {
        return before;
    }

    /** Returns the comments after the last child. */
    List<String> atEnd() {
        return atEnd;
    }

    /** Returns the comments in the element, also those in its children, in the order of the file. */
    List<String> inside() {
        List<String> all = new ArrayList<>();
        children.forEach(child -> {
            all.addAll(child.before);
            all.addAll(child.inside());
        });
        all.addAll(atEnd);
        return all;
    }
}
