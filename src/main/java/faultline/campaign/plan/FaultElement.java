package faultline.campaign.plan;

import faultline.scenario.xml.XmlElement;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A {@code fault} or {@code healthy} of a plan. Its levels are the combinations of the values of its attributes. */
final class FaultElement {

    private final XmlElement node;
    private final Map<String, List<AttributeValue>> values;

    /** Creates an element with the values of each of its attributes, at least one each. */
    FaultElement(XmlElement node, Map<String, List<AttributeValue>> values) {
        this.node = node;
        this.values = values;
    }

    XmlElement node() {
        return node;
    }

    /** Returns the names of the attributes in the plan. */
    Set<String> names() {
        return values.keySet();
    }

    /** Returns the values of an attribute that it has. */
    List<AttributeValue> values(String name) {
        return values.get(name);
    }

    /** Returns the number of levels. */
    double count() {
        return values.values().stream().mapToDouble(List::size).reduce(1, (a, b) -> a * b);
    }

    /** Returns an element with only the first of its levels. */
    FaultElement first() {
        Map<String, List<AttributeValue>> first = new LinkedHashMap<>(values);
        first.replaceAll((name, all) -> all.subList(0, 1));
        return new FaultElement(node, first);
    }

    /**
     * Returns the attributes of a level, counted from 0, as a scenario has them: with the end of the fault instead of
     * its duration. The values of the last attribute change fastest.
     */
    Map<String, AttributeValue> level(int index) {
        Map<String, AttributeValue> level = new LinkedHashMap<>();
        int rest = index;
        int levels = (int) count();
        for (Map.Entry<String, List<AttributeValue>> attribute : values.entrySet()) {
            levels /= attribute.getValue().size();
            level.put(attribute.getKey(), attribute.getValue().get(rest / levels));
            rest %= levels;
        }
        AttributeValue lasts = level.remove("lasts");
        if (lasts != null) {
            level.put("until", new AttributeValue.Sum(level.getOrDefault("at", AttributeValue.NONE), lasts));
        }
        return level;
    }
}
