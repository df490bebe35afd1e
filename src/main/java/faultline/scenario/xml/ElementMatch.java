package faultline.scenario.xml;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Finds the elements of a file in an edited copy of their parent. An element is known by its {@link ElementKey}. One
 * without an id whose key has changed is the most similar one of its name and time, or else of its name, with at least
 * half of its attributes. Those that are similar to none are known by their order, if as many of their name and time,
 * or of their name, are left as before.
 */
final class ElementMatch {

    /** How many pairs of elements are compared at most, so that large files need neither much time nor memory. */
    private static final int MAX_PAIRS = 20_000;

    private final Map<WrittenElement, ElementKey> keys;
    private final Map<WrittenElement, CommentedElement> found = new HashMap<>();
    private final Set<CommentedElement> matched = new HashSet<>();

    /** Compares the children of an element before and after the edit. */
    ElementMatch(List<CommentedElement> before, List<WrittenElement> now) {
        keys = before.isEmpty()
                ? Map.of()
                : now.stream().collect(Collectors.toMap(Function.identity(), WrittenElement::key));
        if (!before.isEmpty()) {
            matchEqual(before, now);
            matchGroups(before, now, ElementKey::nameAndTime, this::matchSimilar);
            matchGroups(before, now, ElementKey::name, this::matchSimilar);
            matchGroups(before, now, ElementKey::nameAndTime, this::matchInOrder);
            matchGroups(before, now, ElementKey::name, this::matchInOrder);
        }
    }

    private void matchEqual(List<CommentedElement> before, List<WrittenElement> now) {
        Map<ElementKey, Deque<CommentedElement>> byKey = new HashMap<>();
        before.forEach(element ->
                byKey.computeIfAbsent(element.key(), key -> new ArrayDeque<>(1)).add(element));
        for (WrittenElement element : now) {
            Deque<CommentedElement> equal = byKey.get(keys.get(element));
            if (equal != null && !equal.isEmpty()) {
                match(equal.remove(), element);
            }
        }
    }

    /** Matches those of the elements that are left that have some text in common. */
    private void matchGroups(
            List<CommentedElement> before,
            List<WrittenElement> now,
            Function<ElementKey, String> text,
            BiConsumer<List<CommentedElement>, List<WrittenElement>> matching) {
        Map<String, List<CommentedElement>> changed = before.stream()
                .filter(element -> !element.key().hasId() && !matched.contains(element))
                .collect(Collectors.groupingBy(element -> text.apply(element.key())));
        Map<String, List<WrittenElement>> unknown = now.stream()
                .filter(element ->
                        !found.containsKey(element) && !keys.get(element).hasId())
                .collect(Collectors.groupingBy(element -> text.apply(keys.get(element))));
        unknown.forEach((same, others) -> matching.accept(changed.getOrDefault(same, List.of()), others));
    }

    /** Matches pairs with at least half of the attributes of the old element, those with the most equal ones first. */
    private void matchSimilar(List<CommentedElement> before, List<WrittenElement> now) {
        if ((long) before.size() * now.size() > MAX_PAIRS) {
            return;
        }
        List<Set<String>> partsNow =
                now.stream().map(element -> keys.get(element).partSet()).toList();
        List<Similarity> similar = new ArrayList<>();
        for (CommentedElement element : before) {
            Set<String> parts = element.key().partSet();
            for (int i = 0; i < now.size(); i++) {
                int equal =
                        (int) parts.stream().filter(partsNow.get(i)::contains).count();
                if (2 * equal >= parts.size()) {
                    similar.add(new Similarity(element, now.get(i), equal));
                }
            }
        }
        similar.sort(Comparator.comparingInt(Similarity::equal).reversed());
        for (Similarity pair : similar) {
            if (!matched.contains(pair.before()) && !found.containsKey(pair.now())) {
                match(pair.before(), pair.now());
            }
        }
    }

    private record Similarity(CommentedElement before, WrittenElement now, int equal) {}

    private void matchInOrder(List<CommentedElement> before, List<WrittenElement> now) {
        for (int i = 0; i < before.size() && before.size() == now.size(); i++) {
            match(before.get(i), now.get(i));
        }
    }

    private void match(CommentedElement before, WrittenElement now) {
        matched.add(before);
        found.put(now, before);
    }

    /** Returns what an element was in the file, or an element without comments if it was not there. */
    CommentedElement before(WrittenElement element) {
        return found.getOrDefault(element, XmlComments.NONE.document());
    }

    /** Returns whether an element of the file is still there. */
    boolean isMatched(CommentedElement element) {
        return matched.contains(element);
    }
}
