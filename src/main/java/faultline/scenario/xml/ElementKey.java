package faultline.scenario.xml;

import faultline.io.DecimalText;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * What an element is known by: its id or, without one, its attributes and the ids of its children.
 *
 * @param name its name
 * @param hasId whether it has an id
 * @param text its id, or its attributes and the ids of its children, in a form that does not depend on how they are
 *     written
 */
record ElementKey(String name, boolean hasId, String text) {

    /** A character that no document can contain. */
    private static final String SEPARATOR = "\0";

    /** Returns the key of an element, given the ids of its children that have one. */
    static ElementKey of(String name, Map<String, String> attributes, Stream<String> childIds) {
        String id = id(attributes);
        if (!id.isEmpty()) {
            return new ElementKey(name, true, id);
        }
        StringBuilder text = new StringBuilder();
        new TreeMap<>(attributes).forEach((attribute, value) -> text.append(attribute)
                .append('=')
                .append(canonical(value))
                .append(SEPARATOR));
        // No attribute has such a name.
        childIds.forEach(child -> text.append('<').append(child).append(SEPARATOR));
        return new ElementKey(name, false, text.toString());
    }

    /** Returns the id among some attributes, or an empty text. */
    static String id(Map<String, String> attributes) {
        return attributes.getOrDefault("id", "");
    }

    private static String canonical(String value) {
        return DecimalText.parse(value)
                .map(number -> number.stripTrailingZeros().toString())
                .orElse(value);
    }

    /** Returns the name with the time of an event. */
    String nameAndTime() {
        return parts().filter(part -> part.startsWith("at=")).findFirst().orElse("") + SEPARATOR + name;
    }

    /** Returns the attributes and the ids of the children, each as a text. */
    Set<String> partSet() {
        return parts().collect(HashSet::new, Set::add, Set::addAll);
    }

    private Stream<String> parts() {
        return Arrays.stream(text.split(SEPARATOR));
    }
}
