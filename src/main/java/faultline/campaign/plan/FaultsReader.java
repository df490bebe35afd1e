package faultline.campaign.plan;

import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/**
 * Makes a factor of {@code faults}. Each {@code fault} in it takes the attributes of a fault in a scenario's timeline;
 * a list of values makes a level for each value.
 */
final class FaultsReader {

    /** The attribute of a plan that names a fault in tables; a scenario's fault does not have it. */
    private static final String LABEL = "label";

    /** The attributes of a fault in a timeline, and those that only a plan has. */
    private static final List<String> KNOWN =
            List.of("kind", "sensor", "motor", "value", "length", "at", "until", "lasts", LABEL);

    /** Attributes whose columns have other names. */
    private static final Map<String, String> COLUMN_NAMES =
            Map.of("at", "onset_s", "until", "end_s", "length", "length_s");

    private static final Map<String, String> MEANINGS = Map.of(
            "kind",
            "kind of the fault, none in a healthy run",
            "sensor",
            "the sensor that fails",
            "value",
            "the fault's number, in the unit of its kind: m, m/s, s, 1/s, deg or V, none for a share or a factor",
            "at",
            "when the fault begins",
            "until",
            "when the fault ends, empty if it does not",
            "length",
            "mean length of a burst",
            LABEL,
            "what the plan calls the fault, its kind if the plan gives no label, none in a healthy run");

    private final Problems problems;
    /** The attributes of all faults, in the order of the columns. */
    private final Set<String> attributes = new LinkedHashSet<>(List.of("kind", "sensor", "value", "at", "until"));

    FaultsReader(Problems problems) {
        this.problems = problems;
    }

    Optional<Factor> read(XmlElement node) {
        ElementRules.checkChildren(node, List.of("healthy", "fault"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String name = FactorReader.columnName(fields, "fault");
        fields.reportUnknownAndMissing();
        List<FaultElement> elements = new ArrayList<>();
        for (XmlElement child : node.children()) {
            if (child.name().equals("healthy")) {
                ElementRules.checkChildren(child, List.of(), problems);
                new AttributeReader(child, problems).reportUnknownAndMissing();
                elements.add(new FaultElement(child, Map.of()));
            } else if (child.name().equals("fault")) {
                if (child.attributes().keySet().containsAll(List.of("lasts", "until"))) {
                    problems.add(child, PlanProblem.LASTS_AND_UNTIL.with());
                }
                elements.add(readFault(child, name));
            }
        }
        if (elements.isEmpty()) {
            problems.add(node, PlanProblem.NO_FAULT.with());
            return Optional.empty();
        }
        double count = elements.stream().mapToDouble(FaultElement::count).sum();
        if (PlanReader.reportTooMany(node, count, problems)) {
            return Optional.empty();
        }
        EqualFaults.in(elements)
                .forEach(repeated -> problems.add(
                        repeated.node(),
                        PlanProblem.DUPLICATE_FAULT.with(repeated.node().name())));
        elements.forEach(element -> attributes.addAll(element.level(0).keySet()));
        List<Column> columns = attributes.stream().map(key -> column(name, key)).toList();
        return Optional.of(new Factor(FactorKind.FAULTS, columns, levels(elements)));
    }

    private static Column column(String factor, String attribute) {
        String name = factor + "_" + COLUMN_NAMES.getOrDefault(attribute, AttributePath.snake(attribute));
        String unit = name.endsWith("_s") ? "s" : "";
        return new Column(name, unit, MEANINGS.getOrDefault(attribute, attribute + " of the fault"));
    }

    private FaultElement readFault(XmlElement node, String factor) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        List<String> present = KNOWN.stream().filter(fields::isPresent).toList();
        fields.reportUnknownAndMissing();
        Map<String, List<AttributeValue>> values = new LinkedHashMap<>();
        node.attributes().forEach((key, text) -> {
            if (present.contains(key)) {
                values.put(key, readValues(fields, key, text, factor));
            }
        });
        FaultElement element = new FaultElement(node, values);
        return PlanReader.reportTooMany(node, element.count(), problems) ? element.first() : element;
    }

    private static List<AttributeValue> readValues(AttributeReader fields, String key, String text, String factor) {
        if (key.equals(LABEL)) {
            String label = fields.text(LABEL, ScenarioLimits.MAX_NAME_LENGTH).orElse("");
            return List.of(new AttributeValue.FixedValue(label));
        }
        boolean isIds = key.equals("sensor");
        String stream = factor + "_" + key;
        Optional<List<AttributeValue>> values =
                isIds ? ValueSyntax.parseIds(text, stream) : ValueSyntax.parse(text, stream, false);
        if (values.isEmpty()) {
            String rule = isIds && text.contains("\"") ? ValueSyntax.ID_RULE : ValueSyntax.RULE;
            fields.report(key, text, Allowed.UNTRANSLATED.with(rule));
        }
        return values.orElse(List.of(AttributeValue.NONE));
    }

    /** Returns the levels of all elements, which are made on demand. */
    private List<Factor.Level> levels(List<FaultElement> elements) {
        NavigableMap<Integer, FaultElement> byFirstLevel = new TreeMap<>();
        int count = 0;
        for (FaultElement element : elements) {
            byFirstLevel.put(count, element);
            count += (int) element.count();
        }
        return new ListOnDemand<>(count, index -> {
            Map.Entry<Integer, FaultElement> element = byFirstLevel.floorEntry(index);
            return level(
                    element.getValue().level(index - element.getKey()),
                    element.getValue().node());
        });
    }

    private Factor.Level level(Map<String, AttributeValue> given, XmlElement node) {
        List<AttributeValue> cells = new ArrayList<>();
        for (String key : attributes) {
            AttributeValue kind = given.getOrDefault("kind", new AttributeValue.FixedValue("none"));
            AttributeValue missing = key.equals("kind") || key.equals(LABEL) ? kind : AttributeValue.NONE;
            cells.add(given.getOrDefault(key, missing));
        }
        Map<String, AttributeValue> fault = new LinkedHashMap<>(given);
        fault.remove(LABEL);
        List<ScenarioChange> edits =
                fault.isEmpty() ? List.of() : List.of(new ScenarioChange.AddFault(fault, node.location()));
        return new Factor.Level(cells, edits);
    }
}
