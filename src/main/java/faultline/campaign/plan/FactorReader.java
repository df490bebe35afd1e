package faultline.campaign.plan;

import faultline.robot.RobotSpec;
import faultline.scenario.xml.Allowed;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Makes factors of {@code set}, {@code variants} and {@code masks}. */
final class FactorReader {

    private static final String NAME_RULE = "lower-case letters, digits and underscores, beginning with a letter";

    /** The maximum number of sensors of which all combinations are tried. */
    private static final int MAX_MASKED = 16;

    /** The column of a plan that set the seed would show values that no run had. */
    private static final String NOT_SEED = "another attribute; <seeds> gives the runs their seeds";

    private final Problems problems;

    FactorReader(Problems problems) {
        this.problems = problems;
    }

    /** Returns the name of a factor's columns. */
    static String columnName(AttributeReader fields, String fallback) {
        String name = fields.text("name").orElse(fallback);
        if (!name.matches("[a-z][a-z0-9_]{0,60}")) {
            fields.report("name", name, Allowed.UNTRANSLATED.with(NAME_RULE));
        }
        return name;
    }

    /** Reads a factor that sets one attribute to several values. */
    Optional<Factor> readSet(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        Optional<AttributePath> path = readPath(fields);
        String name = columnName(fields, path.map(AttributePath::columnName).orElse("unnamed"));
        boolean isText = path.map(AttributePath::isText).orElse(true);
        Optional<List<AttributeValue>> values = readValues(fields, name, isText);
        fields.reportUnknownAndMissing();
        if (path.isEmpty() || values.isEmpty()) {
            return Optional.empty();
        }
        List<Factor.Level> levels = new ListOnDemand<>(values.get().size(), index -> {
            AttributeValue value = values.get().get(index);
            return new Factor.Level(
                    List.of(value), List.of(new ScenarioChange.SetAttribute(path.get(), value, node.location())));
        });
        String meaning = path.get() + " of the scenario" + (isDrawn(values.get()) ? ", drawn for each block" : "");
        return Optional.of(
                new Factor(FactorKind.SET, List.of(new Column(name, path.get().unit(), meaning)), levels));
    }

    private static boolean isDrawn(List<AttributeValue> values) {
        return values.get(0) instanceof AttributeValue.DrawnValue;
    }

    private static Optional<AttributePath> readPath(AttributeReader fields) {
        String text = fields.id("attribute");
        Optional<AttributePath> path = AttributePath.parse(text);
        if (path.isEmpty() && fields.isValid("attribute", text)) {
            fields.report("attribute", text, Allowed.UNTRANSLATED.with(AttributePath.RULE));
        }
        if (path.filter(AttributePath.SEED::equals).isPresent()) {
            fields.report("attribute", text, Allowed.UNTRANSLATED.with(NOT_SEED));
        }
        return path;
    }

    private static Optional<List<AttributeValue>> readValues(AttributeReader fields, String stream, boolean isText) {
        String text = fields.requiredText("value", Allowed.UNTRANSLATED.with(ValueSyntax.RULE))
                .orElse("");
        Optional<List<AttributeValue>> values = ValueSyntax.parse(text, stream, isText);
        if (values.isEmpty() && fields.isPresent("value")) {
            fields.report("value", text, Allowed.UNTRANSLATED.with(ValueSyntax.RULE));
        }
        return values;
    }

    /** Reads a factor of named sets of attributes, each with one fixed value. */
    Optional<Factor> readVariants(XmlElement node) {
        ElementRules.checkChildren(node, List.of("variant"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String name = columnName(fields, "variant");
        fields.reportUnknownAndMissing();
        Set<String> names = new HashSet<>();
        List<Factor.Level> levels = new ArrayList<>();
        node.childrenNamed("variant").forEach(child -> levels.add(readVariant(child, names)));
        if (levels.isEmpty()) {
            problems.add(node, PlanProblem.NO_VARIANT.with());
            return Optional.empty();
        }
        return Optional.of(
                new Factor(FactorKind.VARIANTS, List.of(new Column(name, "", "which of the plan's variants")), levels));
    }

    private Factor.Level readVariant(XmlElement node, Set<String> names) {
        ElementRules.checkChildren(node, List.of("set"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String name = fields.id("name");
        if (!names.add(name)) {
            fields.report("name", name, Allowed.UNTRANSLATED.with("a unique name"));
        }
        fields.reportUnknownAndMissing();
        List<ScenarioChange> edits = new ArrayList<>();
        node.childrenNamed("set").forEach(child -> readLiteral(child).ifPresent(edits::add));
        return new Factor.Level(List.of(new AttributeValue.FixedValue(name)), edits);
    }

    private Optional<ScenarioChange> readLiteral(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        Optional<AttributePath> path = readPath(fields);
        String value = fields.requiredText(
                        "value", Allowed.UNTRANSLATED.with("what the attribute of the scenario may be"))
                .orElse("");
        fields.reportUnknownAndMissing();
        return path.map(
                found -> new ScenarioChange.SetAttribute(found, new AttributeValue.FixedValue(value), node.location()));
    }

    /** Reads a factor of sensors that are on: every combination of the given ones, or the listed ones. */
    Optional<Factor> readMasks(XmlElement node) {
        ElementRules.checkChildren(node, List.of("mask"), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String name = columnName(fields, "sensors_on");
        Set<String> sensors = new LinkedHashSet<>(fields.text("sensors")
                .map(text -> idList(fields, "sensors", text))
                .orElse(standardSensors()));
        fields.reportUnknownAndMissing();
        int max = node.firstChild("mask").isPresent() ? ScenarioLimits.MAX_SENSORS : MAX_MASKED;
        if (sensors.size() > max) {
            fields.report(
                    "sensors",
                    ValueSyntax.formatIdList(List.copyOf(sensors)),
                    Allowed.UNTRANSLATED.with("at most " + max + " of them"));
            return Optional.empty();
        }
        List<List<String>> masks = new ArrayList<>();
        Set<Set<String>> sets = new HashSet<>();
        node.childrenNamed("mask").forEach(child -> masks.add(readMask(child, sensors, sets)));
        if (masks.isEmpty()) {
            masks.addAll(subsets(List.copyOf(sensors)));
        }
        Column column = new Column(name, "", "which of the masked sensors are on, with blanks between them, or none");
        Column count = new Column(name + "_count", "", "how many of the masked sensors are on");
        return Optional.of(new Factor(FactorKind.MASKS, List.of(column, count), maskLevels(masks, sensors, node)));
    }

    /** Reads a mask, given the sensors that may be on and the sets of earlier masks. */
    private List<String> readMask(XmlElement node, Set<String> sensors, Set<Set<String>> earlier) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        List<String> on = idList(
                fields,
                "on",
                fields.requiredText("on", Allowed.UNTRANSLATED.with("the sensors that are on"))
                        .orElse(""));
        if (!sensors.containsAll(on)) {
            fields.reportValue(
                    "on",
                    ValueSyntax.formatIdList(on),
                    () -> Allowed.UNTRANSLATED.with("some of " + Allowed.names(sensors)));
        } else if (!earlier.add(Set.copyOf(on))) {
            fields.report(
                    "on",
                    ValueSyntax.formatIdList(on),
                    Allowed.UNTRANSLATED.with("a set of sensors that no other <mask> has"));
        }
        fields.reportUnknownAndMissing();
        return on;
    }

    /** Returns a level for each mask. All levels share the changes that switch a sensor. */
    private static List<Factor.Level> maskLevels(List<List<String>> masks, Set<String> sensors, XmlElement node) {
        Map<String, ScenarioChange> on = switches(sensors, true, node);
        Map<String, ScenarioChange> off = switches(sensors, false, node);
        return new ListOnDemand<>(masks.size(), index -> {
            List<String> mask = masks.get(index);
            Set<String> different = Set.copyOf(mask);
            return new Factor.Level(
                    List.of(
                            new AttributeValue.FixedValue(ValueSyntax.formatSensorSet(mask)),
                            new AttributeValue.FixedValue(String.valueOf(mask.size()))),
                    sensors.stream()
                            .map(sensor -> (different.contains(sensor) ? on : off).get(sensor))
                            .toList());
        });
    }

    /** Returns the changes that switch sensors on or off. */
    private static Map<String, ScenarioChange> switches(Set<String> sensors, boolean isOn, XmlElement node) {
        AttributeValue value = new AttributeValue.FixedValue(String.valueOf(isOn));
        AttributePath.PathStep robot = new AttributePath.PathStep("robot", "");
        return sensors.stream()
                .collect(Collectors.toMap(
                        Function.identity(),
                        sensor -> new ScenarioChange.SetAttribute(
                                new AttributePath(List.of(robot, new AttributePath.PathStep("sensor", sensor)), "on"),
                                value,
                                node.location())));
    }

    private static List<List<String>> subsets(List<String> sensors) {
        List<List<String>> subsets = new ArrayList<>();
        for (int bits = 0; bits < 1 << sensors.size(); bits++) {
            List<String> on = new ArrayList<>();
            for (int i = 0; i < sensors.size(); i++) {
                if ((bits >> i & 1) == 1) {
                    on.add(sensors.get(i));
                }
            }
            subsets.add(on);
        }
        return subsets;
    }

    private static List<String> standardSensors() {
        return RobotSpec.DEFAULT.sensors().stream().map(SensorSpec::id).collect(Collectors.toList());
    }

    private static List<String> idList(AttributeReader fields, String name, String text) {
        Optional<List<String>> ids = ValueSyntax.parseIdList(text);
        if (ids.isEmpty()) {
            fields.report(name, text, Allowed.UNTRANSLATED.with(ValueSyntax.ID_LIST_RULE));
        }
        return ids.orElse(List.of());
    }
}
