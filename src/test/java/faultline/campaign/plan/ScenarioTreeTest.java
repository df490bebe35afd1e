package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ScenarioTreeTest {

    private static XmlElement element(String name, Map<String, String> attributes, XmlElement... children) {
        return new XmlElement(name, SourceLocation.NONE, attributes, List.of(children), "");
    }

    private final XmlElement room = element(
            "scenario",
            Map.of("name", "Room"),
            element(
                    "world",
                    Map.of("width", "3"),
                    element("circle", Map.of("id", "a", "x", "1")),
                    element("rectangle", Map.of("x", "2")),
                    element("circle", Map.of("id", "2", "x", "3")),
                    element("circle", Map.of("x", "4"))),
            element("robot", Map.of(), element("sensor", Map.of("id", "front"))));

    @Test
    void aPathThatNamesNoneOfSeveralElementsHasANote() {
        XmlElement tree = element(
                "scenario",
                Map.of(),
                element(
                        "robot",
                        Map.of(),
                        element("sensor", Map.of("id", "a]/b")),
                        element("sensor", Map.of("id", "c"))),
                element("timeline", Map.of(), element("fault", Map.of()), element("fault", Map.of())));
        assertEquals(
                "\"robot/sensor/@range\" sets only the first of 2 elements <sensor>; \"robot/sensor[1]/@range\" names"
                        + " one of them, by its id or number",
                note(tree, "robot/sensor/@range"));
        assertEquals(
                "\"timeline/fault/@at\" sets only the first of 2 elements <fault>; \"timeline/fault[1]/@at\" names"
                        + " one of them, by its id or number",
                note(tree, "timeline/fault/@at"));
        for (String path : List.of("robot/sensor[c]/@range", "timeline/fault[2]/@at", "robot/@x", "controller/@side")) {
            assertEquals("", note(tree, path), path);
        }
    }

    private static String note(XmlElement tree, String path) {
        return new ScenarioTree(tree)
                .note(AttributePath.parse(path).orElseThrow())
                .map(Object::toString)
                .orElse("");
    }

    private static void set(ScenarioTree tree, String path, String text) throws ScenarioException {
        tree.set(AttributePath.parse(path).orElseThrow(), text, "plan.xml", new SourceLocation(7, 8));
    }

    @Test
    void partsThatAreNotChangedAreShared() throws ScenarioException {
        ScenarioTree tree = new ScenarioTree(room);
        assertSame(room, tree.toElement());
        set(tree, "world/circle[a]/@x", "9");
        XmlElement changed = tree.toElement();
        XmlElement world = changed.children().get(0);
        assertEquals(SourceLocation.NONE, world.location());
        assertEquals(new SourceLocation(7, 8), world.children().get(0).location());
        assertEquals("9", world.children().get(0).attributes().get("x"));
        assertSame(room.children().get(0).children().get(2), world.children().get(2));
        assertSame(room.children().get(1), changed.children().get(1));
    }

    @Test
    void faultsAreAddedToOneTimeline() {
        ScenarioTree tree = new ScenarioTree(room);
        tree.addFault(Map.of("kind", "off"), SourceLocation.NONE);
        tree.addFault(Map.of("kind", "stuck"), SourceLocation.NONE);
        List<XmlElement> timelines = tree.toElement().childrenNamed("timeline").toList();
        assertEquals(1, timelines.size());
        assertEquals(
                List.of("off", "stuck"),
                timelines.get(0).children().stream()
                        .map(fault -> fault.attributes().get("kind"))
                        .toList());
    }

    @Test
    void aPathWithoutAnElementIsReportedWithTheMostSimilarOne() {
        ScenarioException refusal =
                assertThrows(ScenarioException.class, () -> set(new ScenarioTree(room), "world/rectangel/@x", "1"));
        assertTrue(
                refusal.getMessage().contains("<world> has no rectangel; did you mean \"rectangle\"?"),
                refusal.getMessage());
    }

    @Test
    void manyChangesTakeLinearTime() throws ScenarioException {
        XmlElement[] circles = IntStream.range(0, 50_000)
                .mapToObj(i -> element("circle", Map.of("id", "c" + i, "x", "1")))
                .toArray(XmlElement[]::new);
        CpuTime time = CpuTime.start();
        ScenarioTree tree = new ScenarioTree(
                element("scenario", Map.of(), element("world", Map.of(), circles), element("robot", Map.of())));
        for (int i = 0; i < circles.length; i++) {
            set(tree, "world/circle[c" + i + "]/@x", "2");
            set(tree, "world/circle[c" + i + "]/@id", "d" + i);
            set(tree, "robot/sensor[s" + i + "]/@x", "2");
        }
        XmlElement changed = tree.toElement();
        time.assertBelow(5);
        assertEquals(circles.length, changed.children().get(1).children().size());
    }

    /** Ids are set as well, so that a later path leads to another element than an earlier one. */
    @Test
    void changesInAnyOrderGiveWhatASearchOfAllChildrenGives() throws ScenarioException {
        Random random = new Random(3);
        List<String> elements = List.of("world/circle", "world/rectangle", "robot/sensor", "controller");
        List<String> keys = List.of("", "[a]", "[b]", "[1]", "[2]", "[3]", "[front]");
        for (int trial = 0; trial < 500; trial++) {
            ScenarioTree tree = new ScenarioTree(room);
            XmlElement slow = room;
            for (int i = 0; i < 12; i++) {
                String element = elements.get(random.nextInt(elements.size()));
                boolean id = random.nextInt(3) == 0;
                String text = id ? List.of("a", "b", "2").get(random.nextInt(3)) : String.valueOf(i);
                String key = element.equals("controller") ? "" : keys.get(random.nextInt(keys.size()));
                String path = element + key + (id ? "/@id" : "/@x");
                XmlElement changed =
                        setSlowly(slow, AttributePath.parse(path).orElseThrow().steps(), id ? "id" : "x", text);
                if (changed == null) {
                    ScenarioTree copy = new ScenarioTree(tree.toElement());
                    assertThrows(ScenarioException.class, () -> set(copy, path, text), path);
                } else {
                    set(tree, path, text);
                    slow = changed;
                }
            }
            assertEquals(slow, tree.toElement());
        }
    }

    /** Returns a copy of an element with a set attribute; null if the path leads nowhere. */
    private static XmlElement setSlowly(
            XmlElement node, List<AttributePath.PathStep> steps, String attribute, String text) {
        SourceLocation change = new SourceLocation(7, 8);
        if (steps.isEmpty()) {
            Map<String, String> attributes = new LinkedHashMap<>(node.attributes());
            attributes.put(attribute, text);
            return new XmlElement(node.name(), change, attributes, node.children(), node.text());
        }
        AttributePath.PathStep step = steps.get(0);
        List<XmlElement> children = new ArrayList<>(node.children());
        int index = indexOf(children, step);
        if (index < 0 && !step.element().matches("sensor|controller")) {
            return null;
        }
        if (index < 0) {
            if (step.element().equals("sensor") && step.key().isEmpty()) {
                return null;
            }
            Map<String, String> attributes = step.key().isEmpty() ? Map.of() : Map.of("id", step.key());
            children.add(new XmlElement(step.element(), change, attributes, List.of(), ""));
            index = children.size() - 1;
        }
        XmlElement child = setSlowly(children.get(index), steps.subList(1, steps.size()), attribute, text);
        if (child == null) {
            return null;
        }
        children.set(index, child);
        return new XmlElement(node.name(), node.location(), node.attributes(), children, node.text());
    }

    /** Returns the index of the first child with an id, else of the one with a number, else -1. */
    private static int indexOf(List<XmlElement> children, AttributePath.PathStep step) {
        List<Integer> named = IntStream.range(0, children.size())
                .filter(i -> children.get(i).name().equals(step.element()))
                .boxed()
                .toList();
        for (int i : named) {
            if (children.get(i).attributes().getOrDefault("id", "").equals(step.key())) {
                return i;
            }
        }
        int number = step.key().matches("\\d")
                ? Integer.parseInt(step.key())
                : step.key().isEmpty() ? 1 : 0;
        return number >= 1 && number <= named.size() ? named.get(number - 1) : -1;
    }
}
