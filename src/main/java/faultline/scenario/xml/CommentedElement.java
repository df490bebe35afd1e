package faultline.scenario.xml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * An element of a file with the comments before it and in it. Elements without comments are kept as far as they are
 * needed to find the others in an edited copy of the file.
 */
final class CommentedElement {

    private final String name;
    private final List<String> before;
    /** The attributes until the element ends. */
    private Map<String, String> attributes;

    private ElementKey key;
    private List<CommentedElement> children = new ArrayList<>();
    private List<String> atEnd = List.of();
    private boolean commented;

    /** Creates an open element. */
    CommentedElement(String name, Map<String, String> attributes, List<String> before) {
        this.name = name;
        this.attributes = attributes;
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
        key = ElementKey.of(
                name,
                attributes,
                children.stream()
                        .map(child -> child.key)
                        .filter(ElementKey::hasId)
                        .map(ElementKey::text));
        attributes = Map.of();
        atEnd = List.copyOf(last);
        boolean inside = !atEnd.isEmpty() || children.stream().anyMatch(child -> child.commented);
        commented = inside || !before.isEmpty();
        children = inside ? List.copyOf(children) : List.of();
    }

    /** Returns what the element is known by; it has ended. */
    ElementKey key() {
        return key;
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
