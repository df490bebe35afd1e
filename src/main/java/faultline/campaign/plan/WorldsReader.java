package faultline.campaign.plan;

import faultline.campaign.RoomRules;
import faultline.io.Message;
import faultline.io.MessageText;
import faultline.scenario.Scenario;
import faultline.scenario.xml.AttributeReader;
import faultline.scenario.xml.ElementRules;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.scenario.xml.XmlElement;
import faultline.scenario.xml.XmlFormat;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Makes the worlds of a plan from its {@code worlds} element. */
final class WorldsReader {

    private final Problems problems;
    private final PlanFiles.Resolver resolver;
    private final Map<String, byte[]> scenarios;
    private final Set<String> labels = new HashSet<>();
    private final RoomNames rooms = new RoomNames();

    /** Creates a reader that puts the bytes of the scenarios into a map, by their names. */
    WorldsReader(Problems problems, PlanFiles.Resolver resolver, Map<String, byte[]> scenarios) {
        this.problems = problems;
        this.resolver = resolver;
        this.scenarios = scenarios;
    }

    List<WorldSource> read(XmlElement root) {
        List<WorldSource> sources = new ArrayList<>();
        Optional<XmlElement> worlds = root.firstChild("worlds");
        worlds.ifPresent(node -> {
            ElementRules.checkChildren(node, List.of("scenario", "rooms"), problems);
            new AttributeReader(node, problems).reportUnknownAndMissing();
            for (XmlElement child : node.children()) {
                readSource(child).ifPresent(source -> {
                    checkRooms(child, source);
                    sources.add(source);
                });
            }
        });
        if (worlds.isEmpty() || worlds.get().children().isEmpty()) {
            problems.add(worlds.orElse(root), PlanProblem.NO_WORLDS.with());
        }
        return sources;
    }

    /** Reports rooms that are worlds already, and a scenario with the name of a room. */
    private void checkRooms(XmlElement node, WorldSource source) {
        PlanProblem problem =
                source instanceof WorldSource.Rooms ? PlanProblem.DUPLICATE_ROOM : PlanProblem.DUPLICATE_SCENARIO;
        rooms.add(source).ifPresent(name -> problems.add(node, problem.with(MessageText.excerpt(name))));
    }

    private Optional<WorldSource> readSource(XmlElement node) {
        return switch (node.name()) {
            case "scenario" -> readScenario(node);
            case "rooms" -> Optional.of(readRooms(node));
            default -> Optional.empty();
        };
    }

    private WorldSource readRooms(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        long first = fields.integer("first", 0, CampaignPlan.MAX_SEED, 1);
        int count = (int) fields.integer("count", 1, CampaignPlan.MAX_RUNS, 1);
        int minCorner = (int)
                fields.integer("minCorner", RoomRules.MIN_CORNER, RoomRules.MAX_CORNER, RoomRules.DEFAULT.minCorner());
        int visitors = (int) fields.integer("visitors", 0, RoomRules.MAX_VISITORS, RoomRules.DEFAULT.visitors());
        fields.reportUnknownAndMissing();
        return new WorldSource.Rooms(first, count, new RoomRules(minCorner, visitors));
    }

    private Optional<WorldSource> readScenario(XmlElement node) {
        ElementRules.checkChildren(node, List.of(), problems);
        AttributeReader fields = new AttributeReader(node, problems);
        String file = fields.id("file");
        String label = fields.text("name", ScenarioLimits.MAX_NAME_LENGTH).orElse(stem(file));
        fields.reportUnknownAndMissing();
        if (!fields.isValid("file", file)) {
            return Optional.empty();
        }
        if (scenarios.containsKey(file)) {
            problems.add(node, PlanProblem.DUPLICATE_FILE.with(MessageText.excerpt(file)));
            return Optional.empty();
        }
        if (!labels.add(label)) {
            problems.add(node, PlanProblem.DUPLICATE_SCENARIO.with(MessageText.excerpt(label)));
            return Optional.empty();
        }
        try {
            byte[] bytes = resolver.read(scenarios.size() + 1, file);
            scenarios.put(file, bytes);
            return Optional.of(new WorldSource.ScenarioFile(label, file, parse(file, bytes)));
        } catch (ScenarioException e) {
            for (Problem problem : e.problems()) {
                String place = MessageText.oneLine(problem.file() + problem.location());
                Message inFile = PlanProblem.IN_FILE.with(place, problem.message());
                problems.add(node, PlanProblem.SCENARIO.with(MessageText.excerpt(file), inFile));
            }
            return Optional.empty();
        }
    }

    /** Returns a valid scenario as a tree. */
    private static XmlElement parse(String file, byte[] bytes) throws ScenarioException {
        Problems problems = new Problems(file);
        Optional<XmlElement> root = XmlElement.parse(bytes, problems, XmlFormat.SCENARIO);
        problems.throwIfAny();
        Scenario.read(file, root.orElseThrow());
        return root.get();
    }

    private static String stem(String file) {
        String name = file.substring(Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')) + 1);
        return name.endsWith(".xml") ? name.substring(0, name.length() - ".xml".length()) : name;
    }
}
