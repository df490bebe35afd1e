package faultline.campaign.plan;

import faultline.campaign.RandomRoom;
import faultline.campaign.RoomRules;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.scenario.Scenario;
import faultline.scenario.xml.Problems;
import faultline.scenario.xml.XmlElement;
import faultline.scenario.xml.XmlFormat;
import java.io.IOException;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** A source of worlds of a plan. */
sealed interface WorldSource {

    /** Returns the number of worlds. */
    int count();

    /** Returns the name of a world in {@code runs.csv}, from 0. */
    String label(int index);

    /** Returns the scenario of a world as a tree of elements. */
    XmlElement root(int index);

    /** Returns all scenario files of some sources, and the first source of rooms with each set of rules. */
    static List<WorldSource> kinds(Collection<WorldSource> sources) {
        Set<RoomRules> rules = new HashSet<>();
        return sources.stream()
                .filter(source -> !(source instanceof Rooms rooms) || rules.add(rooms.rules))
                .toList();
    }

    /** A scenario file: its name in {@code runs.csv}, its name in the plan, and its content. */
    record ScenarioFile(String label, String file, XmlElement tree) implements WorldSource {
        @Override
        public int count() {
            return 1;
        }

        @Override
        public String label(int index) {
            return label;
        }

        @Override
        public XmlElement root(int index) {
            return tree;
        }

        /** Returns whether its timeline has faults. */
        boolean hasFaults() {
            return timelineElements("fault").findAny().isPresent();
        }

        /** Returns the names of the attributes in the changes of the controller in its timeline. */
        Set<String> timelineControllerAttributes() {
            return timelineElements("controller")
                    .flatMap(change -> change.attributes().keySet().stream())
                    .collect(Collectors.toSet());
        }

        private Stream<XmlElement> timelineElements(String name) {
            return tree.childrenNamed("timeline").flatMap(timeline -> timeline.childrenNamed(name));
        }
    }

    /** Generated rooms with consecutive seeds, and the rules for their corners and visitors. */
    record Rooms(long first, int count, RoomRules rules) implements WorldSource {

        @Override
        public String label(int index) {
            return label(first + index, suffix());
        }

        @Override
        public XmlElement root(int index) {
            RandomRoom room = RandomRoom.ofSeed(first + index, rules);
            SimulationSetup setup = SimulationSetup.of(room.world(), room.start());
            return toTree(new Scenario(label(index), "", false, setup, Expectation.NONE));
        }

        /** Returns the end of their names, which is not empty if their rules are not the default ones. */
        String suffix() {
            String corners = rules.minCorner() == RoomRules.DEFAULT.minCorner() ? "" : "-corners-" + rules.minCorner();
            return corners + (rules.visitors() == 0 ? "" : "-visitors-" + rules.visitors());
        }

        /** Returns the name of a room with a number and an end. */
        static String label(long number, String suffix) {
            return "room-" + number + suffix;
        }

        /** Omits the default controller, whose attributes another one does not have. */
        private static XmlElement toTree(Scenario room) {
            try {
                XmlElement tree = XmlElement.parse(room.toBytes(), new Problems(room.name()), XmlFormat.SCENARIO)
                        .orElseThrow();
                List<XmlElement> children = tree.children().stream()
                        .filter(child -> !child.name().equals("controller"))
                        .toList();
                return new XmlElement(tree.name(), tree.location(), tree.attributes(), children, tree.text());
            } catch (IOException e) {
                throw new IllegalStateException(room.name() + " cannot be a scenario", e);
            }
        }
    }
}
