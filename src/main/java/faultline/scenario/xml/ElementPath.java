package faultline.scenario.xml;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;

/**
 * A path that identifies an element in an edited copy of a document: {@code /scenario#1/world#1/circle=pillar}. It
 * holds an element's id, or, if it has none, its number among the elements of its name in the same parent.
 */
final class ElementPath {

    /** An open element, with the number of children of each name so far. */
    private record OpenElement(String path, Map<String, Integer> children) {
        static OpenElement of(String path) {
            return new OpenElement(path, new HashMap<>());
        }
    }

    /** A character that no document can contain. */
    private static final char SLASH_SUBSTITUTE = 0;

    private final Deque<OpenElement> openElements = new ArrayDeque<>();

    ElementPath() {
        openElements.push(OpenElement.of(""));
    }

    /** Returns the path of the open element, empty outside the root element. */
    String current() {
        return openElements.peek().path;
    }

    /** Enters the next child of a name, whose id is empty if it has none. */
    void enter(String name, String id) {
        int number = openElements.peek().children.merge(name, 1, Integer::sum);
        openElements.push(OpenElement.of(
                current() + "/" + name + (id.isEmpty() ? "#" + number : "=" + id.replace('/', SLASH_SUBSTITUTE))));
    }

    void leave() {
        openElements.pop();
    }
}
