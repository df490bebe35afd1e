package faultline.scenario.xml;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Finds the elements of a file in an edited copy of their parent. An element is known by its id, or else by its
 * attributes. Those without an id whose attributes have changed, or are written with more defaults, are known by their
 * order, if there are as many of their name and time as before, or else of their name.
 */
final class ElementMatch {

    private final Map<WrittenElement, CommentedElement> found = new HashMap<>();

    /** Compares the children of an element before and after the edit. */
    ElementMatch(List<CommentedElement> before, List<WrittenElement> now) {
        if (!before.isEmpty()) {
            matchKeys(before, now);
            matchRest(before, now, CommentedElement::timeKey, CommentedElement::timeKeyOf);
            matchRest(before, now, CommentedElement::name, (name, attributes) -> name);
        }
    }

    private void matchKeys(List<CommentedElement> before, List<WrittenElement> now) {
        Map<String, Deque<CommentedElement>> byKey = new HashMap<>();
        before.forEach(element ->
                byKey.computeIfAbsent(element.key(), key -> new ArrayDeque<>(1)).add(element));
        for (WrittenElement element : now) {
            Deque<CommentedElement> equal = byKey.get(CommentedElement.keyOf(element.name(), element.attributes()));
            if (equal != null && !equal.isEmpty()) {
                found.put(element, equal.remove());
            }
        }
    }

    /** Matches the elements that are left by their order where as many have some text as before. */
    private void matchRest(
            List<CommentedElement> before,
            List<WrittenElement> now,
            Function<CommentedElement, String> textBefore,
            BiFunction<String, Map<String, String>, String> textNow) {
        Set<CommentedElement> matched = matched();
        Map<String, List<CommentedElement>> changed = before.stream()
                .filter(element -> !element.hasId() && !matched.contains(element))
                .collect(Collectors.groupingBy(textBefore));
        Map<String, List<WrittenElement>> unknown = now.stream()
                .filter(element -> !CommentedElement.hasId(element.attributes()) && !found.containsKey(element))
                .collect(Collectors.groupingBy(element -> textNow.apply(element.name(), element.attributes())));
        changed.forEach((text, old) -> {
            List<WrittenElement> others = unknown.getOrDefault(text, List.of());
            for (int i = 0; i < old.size() && others.size() == old.size(); i++) {
                found.put(others.get(i), old.get(i));
            }
        });
    }

    /** Returns what an element was in the file, or an element without comments if it was not there. */
    CommentedElement before(WrittenElement element) {
        return found.getOrDefault(element, XmlComments.NONE.document());
    }

    /** Returns the elements of the file that are still there. */
    Set<CommentedElement> matched() {
        return new HashSet<>(found.values());
    }
}
