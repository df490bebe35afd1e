package faultline.scenario.xml;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;

/**
 * Where in a document one is, as a text by which an element is found again in an edited copy:
 * {@code /scenario#1/world#1/circle=pillar}. An element goes by its id, or without one by its number among those of its
 * name in the same parent.
 */
final class ElementPath {

    /** An element that is open, with how many children of each name it has had. */
    private record OpenElement(String path, Map<String, Integer> children) {
        static OpenElement of(String path) {
            return new OpenElement(path, new HashMap<>());
        }
    }

    /** No document can hold it. */
    private static final char SLASH_SUBSTITUTE = 0;

    private final Deque<OpenElement> openElements = new ArrayDeque<>();

    ElementPath() {
        openElements.push(OpenElement.of(""));
    }

    /** The path of the element that is open: empty outside of the root element. */
    String current() {
        return openElements.peek().path;
    }

    /** Goes into the next child of a name; an empty id stands for none. */
    void enter(String name, String id) {
        int number = openElements.peek().children.merge(name, 1, Integer::sum);
        openElements.push(OpenElement.of(
                current() + "/" + name + (id.isEmpty() ? "#" + number : "=" + id.replace('/', SLASH_SUBSTITUTE))));
    }

    void leave() {
        openElements.pop();
    }
}
