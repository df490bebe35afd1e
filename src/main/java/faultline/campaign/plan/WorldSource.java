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
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A source of worlds of a plan. */
sealed interface WorldSource {

    /** Returns the number of worlds. */
    int count();

    /** Returns the name of a world in {@code runs.csv}, from 0. */
    String label(int index);

    /** Returns the scenario of a world as a tree of elements. */
    XmlElement root(int index);

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
    }

    /** Generated rooms with consecutive seeds, and the rules for their corners and visitors. */
    record Rooms(long first, int count, RoomRules rules) implements WorldSource {

        private static final Pattern NAME = Pattern.compile("room-(0|[1-9]\\d{0,17})(.*)");

        @Override
        public String label(int index) {
            return "room-" + (first + index) + suffix();
        }

        @Override
        public XmlElement root(int index) {
            RandomRoom room = RandomRoom.ofSeed(first + index, rules);
            SimulationSetup setup = SimulationSetup.of(room.world(), room.start());
            return toTree(new Scenario(label(index), "", false, setup, Expectation.NONE));
        }

        /** Returns whether one of these rooms has a name. */
        boolean contains(String label) {
            Matcher name = NAME.matcher(label);
            if (!name.matches() || !name.group(2).equals(suffix())) {
                return false;
            }
            long number = Long.parseLong(name.group(1));
            return number >= first && number < first + count;
        }

        /** Rooms with rules other than the default have different names. */
        private String suffix() {
            String corners = rules.minCorner() == RoomRules.DEFAULT.minCorner() ? "" : "-corners-" + rules.minCorner();
            return corners + (rules.visitors() == 0 ? "" : "-visitors-" + rules.visitors());
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
