package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RoomRules;
import faultline.scenario.xml.SourceLocation;
import faultline.scenario.xml.XmlElement;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class RoomNamesTest {

    private final RoomNames names = new RoomNames();

    private static WorldSource rooms(long first, int count, int visitors) {
        return new WorldSource.Rooms(first, count, new RoomRules(60, visitors));
    }

    private static WorldSource scenario(String name) {
        XmlElement tree = new XmlElement("scenario", SourceLocation.NONE, Map.of(), List.of(), "");
        return new WorldSource.ScenarioFile(name, name + ".xml", tree);
    }

    @Test
    void roomsWithOtherRulesHaveOtherNames() {
        assertEquals(Optional.empty(), names.add(rooms(1, 10, 0)));
        assertEquals(Optional.empty(), names.add(rooms(1, 10, 2)));
        assertEquals(Optional.of("room-10-visitors-2"), names.add(rooms(10, 1, 2)));
    }

    @Test
    void aScenarioCanHaveTheNameOfARoom() {
        assertEquals(Optional.empty(), names.add(scenario("room-7-visitors-2")));
        assertEquals(Optional.empty(), names.add(scenario("room-07")));
        assertEquals(Optional.empty(), names.add(scenario("my room-7")));
        assertEquals(Optional.empty(), names.add(rooms(0, 20, 0)));
        assertEquals(Optional.of("room-7-visitors-2"), names.add(rooms(0, 20, 2)));
        assertEquals(Optional.of("room-19"), names.add(scenario("room-19")));
    }

    @Test
    void namesAreFoundAsByComparisonWithEachEarlierRoom() {
        Random random = new Random(5);
        for (int trial = 0; trial < 300; trial++) {
            RoomNames found = new RoomNames();
            Set<String> earlier = new HashSet<>();
            for (int i = 0; i < 12; i++) {
                WorldSource source = random.nextInt(4) == 0
                        ? scenario("room-" + random.nextInt(100))
                        : rooms(random.nextInt(100), 1 + random.nextInt(1 + random.nextInt(30)), 0);
                Set<String> common = new HashSet<>();
                for (int room = 0; room < source.count(); room++) {
                    if (!earlier.add(source.label(room))) {
                        common.add(source.label(room));
                    }
                }
                Optional<String> name = found.add(source);
                assertEquals(!common.isEmpty(), name.isPresent());
                name.ifPresent(one -> assertTrue(common.contains(one), one + " of " + common));
            }
        }
    }
}
