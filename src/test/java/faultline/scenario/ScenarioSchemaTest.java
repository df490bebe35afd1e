package faultline.scenario;

import static java.util.Map.entry;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Threshold;
import faultline.robot.MotorFaultKind;
import faultline.scenario.xml.NumberRange;
import faultline.scenario.xml.SchemaCheck;
import faultline.sensor.FaultKind;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/** The schema, the reader and the documents agree. */
class ScenarioSchemaTest {

    private static final Path SCHEMA = Path.of("src/main/resources/faultline/scenario/xml/scenario-1.xsd");

    @Test
    void theCopyInTheDocumentsIsTheSchemaOfTheProgram() throws Exception {
        assertEquals(Files.readString(SCHEMA), Files.readString(Path.of("docs/scenario-1.xsd")));
    }

    @Test
    void theSchemaKnowsTheKindsOfFaultThatTheProgramKnows() throws Exception {
        Element type = elements("simpleType")
                .filter(element -> element.getAttribute("name").equals("faultKind"))
                .findFirst()
                .orElseThrow();
        NodeList kinds = type.getElementsByTagName("xs:enumeration");
        assertEquals(
                Stream.concat(
                                Arrays.stream(FaultKind.values()).map(FaultKind::fileName),
                                Arrays.stream(MotorFaultKind.values()).map(MotorFaultKind::fileName))
                        .toList(),
                IntStream.range(0, kinds.getLength())
                        .mapToObj(i -> ((Element) kinds.item(i)).getAttribute("value"))
                        .toList());
    }

    private static Map<String, NumberRange> ranges() {
        return Map.ofEntries(
                entry("size", NumberRange.SIZE),
                entry("coordinate", NumberRange.COORDINATE),
                entry("noise", NumberRange.NOISE),
                entry("incidence", NumberRange.INCIDENCE_ANGLE),
                entry("angle", NumberRange.ANGLE),
                entry("cone", NumberRange.CONE),
                entry("turnRate", NumberRange.TURN_RATE),
                entry("speed", NumberRange.SPEED),
                entry("positiveSpeed", NumberRange.POSITIVE_SPEED),
                entry("time", NumberRange.TIME),
                entry("tick", NumberRange.TICK),
                entry("timeConstant", NumberRange.TIME_CONSTANT),
                entry("voltage", NumberRange.VOLTAGE),
                entry("positiveVoltage", NumberRange.POSITIVE_VOLTAGE),
                entry("share", NumberRange.FRACTION),
                entry("driveScale", NumberRange.DRIVE_SCALE),
                entry("gain", NumberRange.GAIN),
                entry("margin", NumberRange.of(Threshold.Quantity.MARGIN)),
                entry("signedMargin", NumberRange.of(Threshold.Quantity.SIGNED_MARGIN)),
                entry("levelShare", NumberRange.of(Threshold.Quantity.SHARE)),
                entry("settledRate", NumberRange.of(Threshold.Quantity.TURN_RATE)),
                entry("turnedAngle", NumberRange.of(Threshold.Quantity.ANGLE)));
    }

    @Test
    void theRangesOfTheReaderAreThoseOfTheSchema() throws Exception {
        Map<String, NumberRange> ranges = ranges();
        List<Element> types = elements("simpleType")
                .filter(type -> type.getElementsByTagName("xs:restriction").item(0) instanceof Element base
                        && List.of("xs:double", "xs:decimal").contains(base.getAttribute("base")))
                .toList();
        assertEquals(
                ranges.keySet(),
                types.stream().map(type -> type.getAttribute("name")).collect(Collectors.toSet()));
        for (Element type : types) {
            NumberRange range = ranges.get(type.getAttribute("name"));
            assertEquals(
                    range.min(),
                    facet(type, range.minInclusive() ? "minInclusive" : "minExclusive"),
                    type.getAttribute("name"));
            assertEquals(
                    range.max(),
                    facet(type, range.maxInclusive() ? "maxInclusive" : "maxExclusive"),
                    type.getAttribute("name"));
        }
    }

    /** The bounds of these depend on the kind of fault. */
    private static final Set<String> BOUNDED_BY_KIND =
            Set.of("fault value", "fault length", "mend value", "mend length");

    @Test
    void theReaderHoldsEveryAttributeToTheBoundsOfItsTypeInTheSchema() throws Exception {
        Map<String, Element> types = elements("simpleType")
                .filter(type -> type.hasAttribute("name"))
                .collect(Collectors.toMap(type -> type.getAttribute("name"), type -> type));
        int checked = 0;
        for (Element attribute : elements("attribute").toList()) {
            Element type = types.get(attribute.getAttribute("type"));
            String element = ((Element) attribute.getParentNode()).getAttribute("name");
            String name = attribute.getAttribute("name");
            if (type != null && !BOUNDED_BY_KIND.contains(element + " " + name)) {
                for (String facet : List.of("minInclusive", "minExclusive", "maxInclusive", "maxExclusive")) {
                    checked += checkBound(elementOf(attribute), name, type, facet);
                }
            }
        }
        assertTrue(checked >= 100, "only " + checked + " bounds were checked");
    }

    /** Elements of the plain file that have the attributes of types without an element in it. */
    private static final Map<String, String> SAMPLE_ELEMENTS = Map.of(
            "placed", "circle", "outline", "polygon", "controllerSettings", "controller", "controllerChange", "tune");

    /** Returns the name of an element of the plain file that has an attribute. */
    private static String elementOf(Element attribute) {
        for (Node node = attribute.getParentNode(); ; node = node.getParentNode()) {
            String type = ((Element) node).getAttribute("name");
            if (!type.isEmpty()) {
                return SAMPLE_ELEMENTS.getOrDefault(type, type);
            }
        }
    }

    private static int checkBound(String element, String name, Element type, String facet) {
        if (type.getElementsByTagName("xs:" + facet).getLength() == 0) {
            return 0;
        }
        BigDecimal bound = facet(type, facet);
        BigDecimal outwards = new BigDecimal(facet.startsWith("min") ? "-1e-9" : "1e-9");
        boolean whole = type.getElementsByTagName("xs:restriction").item(0) instanceof Element restriction
                && restriction.getAttribute("base").equals("xs:int");
        BigDecimal beyond = whole ? bound.add(BigDecimal.valueOf(outwards.signum())) : bound.add(outwards);
        String at = element + " " + name + " " + facet;
        assertEquals(facet.endsWith("Inclusive"), isAccepted(element, name, bound), at);
        assertFalse(isAccepted(element, name, beyond), at);
        assertTrue(whole || isAccepted(element, name, bound.subtract(outwards)), at);
        return 1;
    }

    /** Returns whether the reader accepts a value by itself; it may report other problems. */
    private static boolean isAccepted(String element, String name, BigDecimal value) {
        String text = value.toPlainString();
        String problem = name + " of <" + element + "> is \"" + text + "\"; expected ";
        return SampleScenario.problems(withValue(element, name, text)).stream()
                .noneMatch(line -> line.contains(problem));
    }

    /** The plain file in which the first element of a name, the probe among the sensors, has a value. */
    private static String withValue(String element, String name, String value) {
        String start = element.equals("sensor") ? "<sensor id=\"probe\"" : "<" + element + " ";
        String plain = element.equals("controller")
                ? SampleScenario.withReplacement("type=\"wall-follower\" distance=\"0.25\"", controllerWith(name))
                : SampleScenario.PLAIN;
        int from = plain.indexOf(start);
        int to = plain.indexOf('>', from);
        String tag = plain.substring(from, to).replaceFirst(" " + name + "=\"[^\"]*\"", "");
        String changed = tag.replaceFirst("<" + element, "<" + element + " " + name + "=\"" + value + "\"");
        return plain.substring(0, from) + changed + plain.substring(to);
    }

    /** Returns the attributes without which a controller has not the named one. */
    private static String controllerWith(String attribute) {
        return switch (attribute) {
            case "left", "right" -> "type=\"drive\"";
            case "length" -> "gains=\"length\"";
            case "kp", "kd" -> "gains=\"fixed\"";
            default -> "type=\"wall-follower\" distance=\"0.25\"";
        };
    }

    private static BigDecimal facet(Element type, String name) {
        return new BigDecimal(((Element) type.getElementsByTagName("xs:" + name).item(0)).getAttribute("value"));
    }

    @Test
    void givingADefaultValueOfTheSchemaChangesNothing() throws Exception {
        Scenario plain = SampleScenario.read(SampleScenario.PLAIN);
        int given = 0;
        for (Element attribute : elements("attribute")
                .filter(element -> element.hasAttribute("default"))
                .toList()) {
            String type = ((Element) attribute.getParentNode()).getAttribute("name");
            String element = type.equals("placed") ? "circle" : type;
            String changed = withAttribute(element, attribute.getAttribute("name"), attribute.getAttribute("default"));
            if (!changed.equals(SampleScenario.PLAIN)) {
                assertEquals(plain, SampleScenario.read(changed), element + " " + attribute.getAttribute("name"));
                given++;
            }
        }
        assertTrue(given >= 18, "only " + given + " defaults were given");
    }

    /**
     * The plain file with an attribute put into every element of a name that has it not; only the probe among the
     * sensors.
     */
    private static String withAttribute(String element, String name, String value) {
        String start = element.equals("sensor") ? "<sensor id=\"probe\"" : "<" + element + " ";
        return SampleScenario.PLAIN
                .lines()
                .map(line -> line.contains(start) && !line.contains(" " + name + "=\"")
                        ? line.replace(start, start.stripTrailing() + " " + name + "=\"" + value + "\" ")
                        : line)
                .collect(Collectors.joining("\n", "", "\n"));
    }

    @Test
    void everySchemaErrorIsReportedInTheProgramsOwnWords() {
        List<String> values = List.of(
                "", "x", "-1", "0", "1e3", "1e9", "-1e9", "NaN", "INF", "true", "1,1 2,2", "none", "180", "1e-9", "0.5",
                "left");
        SchemaCheck schema = SchemaCheck.ofScenarios();
        int refused = 0;
        for (String text : mutations(values)) {
            boolean valid = schema.isValid(text);
            List<String> problems = SampleScenario.problems(text);
            assertFalse(!valid && problems.isEmpty(), "only the schema refuses: " + text);
            refused += valid ? 0 : 1;
        }
        assertTrue(refused > 500, "only " + refused + " were refused");
    }

    /** Returns the plain file with each of its attributes in turn set to each of the values, omitted, and misspelt. */
    private static List<String> mutations(List<String> values) {
        List<String> all = new ArrayList<>();
        Matcher attribute = Pattern.compile(" (\\w+)=\"([^\"]*)\"").matcher(SampleScenario.PLAIN);
        while (attribute.find()) {
            if (!attribute.group(1).equals("xmlns")) {
                String before = SampleScenario.PLAIN.substring(0, attribute.start());
                String after = SampleScenario.PLAIN.substring(attribute.end());
                values.forEach(value -> all.add(before + " " + attribute.group(1) + "=\"" + value + "\"" + after));
                all.add(before + after);
                all.add(before + " " + attribute.group(1) + "x=\"" + attribute.group(2) + "\"" + after);
            }
        }
        return all;
    }

    private static Stream<Element> elements(String name) throws Exception {
        Document document =
                DocumentBuilderFactory.newDefaultInstance().newDocumentBuilder().parse(SCHEMA.toFile());
        NodeList found = document.getElementsByTagName("xs:" + name);
        return IntStream.range(0, found.getLength()).mapToObj(i -> (Element) found.item(i));
    }
}
