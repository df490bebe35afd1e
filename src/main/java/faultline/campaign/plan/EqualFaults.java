package faultline.campaign.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Finds elements of a plan with a level that is there already, without making the levels. Elements are compared one
 * attribute after the other, and only those that share a value are compared further.
 */
final class EqualFaults {

    /** The number of values, besides the first of each attribute, after which no more are compared. */
    private static final int MAX_COMPARED = 500_000;

    private final Set<FaultElement> repeated = new HashSet<>();
    private int compared;

    private EqualFaults() {}

    /** Returns the elements with a level that is one of an earlier element, or is twice in the same one. */
    static List<FaultElement> in(List<FaultElement> elements) {
        EqualFaults search = new EqualFaults();
        elements.forEach(search::compareWithin);
        elements.stream()
                .collect(Collectors.groupingBy(FaultElement::names, LinkedHashMap::new, Collectors.toList()))
                .forEach((names, similar) -> search.compare(fewestFirst(names, similar), similar));
        return elements.stream().filter(search.repeated::contains).toList();
    }

    /** Returns the attributes of some elements, those with the fewest values first. */
    private static List<String> fewestFirst(Set<String> names, List<FaultElement> elements) {
        Map<String, Long> counts = new LinkedHashMap<>();
        names.forEach(name -> counts.put(
                name,
                elements.stream()
                        .mapToLong(element -> element.values(name).size())
                        .sum()));
        return names.stream().sorted(Comparator.comparing(counts::get)).toList();
    }

    /** Evenly spaced values are equal if they are as close to each other as two numbers can be. */
    private void compareWithin(FaultElement element) {
        for (String name : element.names()) {
            List<AttributeValue> values = element.values(name);
            if (values.size() > 1 && canCompare(values) && new HashSet<>(values).size() < values.size()) {
                repeated.add(element);
            }
        }
    }

    /** Compares elements that share the values of all attributes but the given ones. */
    private void compare(List<String> names, List<FaultElement> elements) {
        if (elements.stream().skip(1).allMatch(repeated::contains)) {
            return;
        }
        if (names.isEmpty()) {
            repeated.addAll(elements.subList(1, elements.size()));
            return;
        }
        Map<AttributeValue, List<FaultElement>> sharing = new LinkedHashMap<>();
        for (FaultElement element : elements) {
            List<AttributeValue> values = element.values(names.get(0));
            if (canCompare(values)) {
                values.forEach(value -> sharing.computeIfAbsent(value, first -> new ArrayList<>(1))
                        .add(element));
            }
        }
        sharing.values().forEach(some -> compare(names.subList(1, names.size()), some));
    }

    /** Returns whether values can still be compared, and counts them. */
    private boolean canCompare(List<AttributeValue> values) {
        compared = Math.min(MAX_COMPARED, compared + values.size() - 1);
        return compared < MAX_COMPARED || values.size() == 1;
    }
}
