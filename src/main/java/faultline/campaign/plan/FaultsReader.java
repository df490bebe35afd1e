package faultline.campaign.plan;

import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Makes a factor of {@code faults}. Each {@code fault} in it takes the attributes of a fault in a scenario's timeline;
 * a list of values makes a level for each value.
 */
final class FaultsReader {

    /** The attribute of a plan that names a fault in tables; a scenario's fault does not have it. */
    private static final String LABEL = "label";

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

    /** A level whose columns are not known yet. */
    private record IncompleteLevel(Map<String, AttributeValue> attributes, XmlElement node) {}

    FaultsReader(Problems problems) {
        this.problems = problems;
    }

    Optional<Factor> read(XmlElement node) {
        ElementRules.checkChildren(node, List.of("healthy", "fault"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String name = FactorReader.columnName(fields, "fault");
        fields.reportUnknownAndMissing();
        List<IncompleteLevel> levels = new ArrayList<>();
        for (XmlElement child : node.children()) {
            if (child.name().equals("healthy")) {
                ElementRules.checkChildren(child, List.of(), problems);
                new AttributeReader(child, problems).reportUnknownAndMissing();
                levels.add(new IncompleteLevel(Map.of(), child));
            } else if (child.name().equals("fault")) {
                if (child.attributes().keySet().containsAll(List.of("lasts", "until"))) {
                    problems.add(child, PlanProblem.LASTS_AND_UNTIL.with());
                }
                readFault(child, name).forEach(values -> levels.add(new IncompleteLevel(values, child)));
            }
        }
        if (levels.isEmpty()) {
            problems.add(node, PlanProblem.NO_FAULT.with());
            return Optional.empty();
        }
        Set<Map<String, AttributeValue>> different = new HashSet<>();
        for (IncompleteLevel level : levels) {
            if (!different.add(level.attributes)) {
                problems.add(level.node, PlanProblem.DUPLICATE_FAULT.with(level.node.name()));
            }
        }
        List<Column> columns = attributes.stream().map(key -> column(name, key)).toList();
        return Optional.of(new Factor(
                FactorKind.FAULTS, columns, levels.stream().map(this::level).toList()));
    }

    private static Column column(String factor, String attribute) {
        String name = factor + "_" + COLUMN_NAMES.getOrDefault(attribute, AttributePath.snake(attribute));
        String unit = name.endsWith("_s") ? "s" : "";
        return new Column(name, unit, MEANINGS.getOrDefault(attribute, attribute + " of the fault"));
    }

    /** Returns every combination of the values of one element; those of the last attribute change fastest. */
    private List<Map<String, AttributeValue>> readFault(XmlElement node, String factor) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        Map<String, List<AttributeValue>> values = new LinkedHashMap<>();
        node.attributes().forEach((key, text) -> values.put(key, readValues(fields, key, text, factor)));
        double combinations = values.values().stream().mapToDouble(List::size).reduce(1, (a, b) -> a * b);
        if (PlanReader.reportTooMany(node, combinations, problems)) {
            values.replaceAll((key, all) -> all.subList(0, 1));
        }
        List<Map<String, AttributeValue>> levels = List.of(new LinkedHashMap<>());
        for (Map.Entry<String, List<AttributeValue>> attribute : values.entrySet()) {
            levels = combine(levels, attribute.getKey(), attribute.getValue());
        }
        List<Map<String, AttributeValue>> timed =
                levels.stream().map(FaultsReader::withEnd).toList();
        timed.forEach(level -> attributes.addAll(level.keySet()));
        return timed;
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

    private static List<Map<String, AttributeValue>> combine(
            List<Map<String, AttributeValue>> levels, String key, List<AttributeValue> values) {
        List<Map<String, AttributeValue>> combined = new ArrayList<>();
        for (Map<String, AttributeValue> level : levels) {
            for (AttributeValue value : values) {
                Map<String, AttributeValue> longer = new LinkedHashMap<>(level);
                longer.put(key, value);
                combined.add(longer);
            }
        }
        return combined;
    }

    /** Replaces the duration of a fault by its end. */
    private static Map<String, AttributeValue> withEnd(Map<String, AttributeValue> level) {
        Map<String, AttributeValue> timed = new LinkedHashMap<>(level);
        AttributeValue lasts = timed.remove("lasts");
        if (lasts != null) {
            timed.put("until", new AttributeValue.Sum(timed.getOrDefault("at", AttributeValue.NONE), lasts));
        }
        return timed;
    }

    private Factor.Level level(IncompleteLevel level) {
        List<AttributeValue> cells = new ArrayList<>();
        for (String key : attributes) {
            AttributeValue kind = level.attributes.getOrDefault("kind", new AttributeValue.FixedValue("none"));
            AttributeValue missing = key.equals("kind") || key.equals(LABEL) ? kind : AttributeValue.NONE;
            cells.add(level.attributes.getOrDefault(key, missing));
        }
        Map<String, AttributeValue> fault = new LinkedHashMap<>(level.attributes);
        fault.remove(LABEL);
        List<ScenarioChange> edits =
                fault.isEmpty() ? List.of() : List.of(new ScenarioChange.AddFault(fault, level.node.location()));
        return new Factor.Level(cells, edits);
    }
}
