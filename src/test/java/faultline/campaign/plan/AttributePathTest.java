package faultline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AttributePathTest {

    @ParameterizedTest
    @CsvSource({
        "robot/sensor[front]/@cone, front_cone_deg",
        "robot/sensor[rear-left]/@on, rear_left_on",
        "robot/@speed, robot_speed_m_s",
        "controller/@lostMargin, controller_lost_margin_m",
        "robot/@turnRate, robot_turn_rate_deg_s",
        "robot/motor/@timeConstant, motor_time_constant_s",
        "controller/@distance, controller_distance_m",
        "@duration, duration_s",
        "scenario/@duration, duration_s",
        "timeline/fault[2]/@at, fault_2_at_s"
    })
    void aColumnIsNamedAfterItsAttributeAndUnit(String path, String column) {
        assertEquals(column, AttributePath.parse(path).orElseThrow().columnName());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "robot",
                "robot/speed",
                "robot//@speed",
                "robot/sensor[]/@on",
                "@",
                "robot/@speed/@x",
                "robot/sensor[a/@on",
                "robot/sensor[a]b/@on",
                "robot/sensor[]/x[y]/@on"
            })
    void aTextThatIsNoPathIsRefused(String path) {
        assertEquals(Optional.empty(), AttributePath.parse(path));
    }

    /** Ids and settings are texts: 1 and 01 are two of them. */
    @ParameterizedTest
    @CsvSource({
        "robot/sensor[front]/@id, true",
        "@name, true",
        "timeline/fault[1]/@sensor, true",
        "timeline/move[1]/@obstacle, true",
        "controller/setting[gain]/@value, true",
        "timeline/fault[1]/@value, false",
        "robot/@speed, false"
    })
    void theValuesOfSomeAttributesAreTexts(String path, boolean text) {
        assertEquals(text, AttributePath.parse(path).orElseThrow().isText());
    }

    @Test
    void aPathIsWrittenAsItIsRead() {
        String path = "robot/sensor[front]/@cone";
        assertEquals(path, AttributePath.parse(path).orElseThrow().toString());
    }

    /** Only a bracket before a slash ends an id. */
    @ParameterizedTest
    @ValueSource(strings = {"front", "a/b", "a[b]", "[1]", "a]", "[", "/@on", "front nose", "a\u2028b"})
    void anIdMayHaveSlashesAndBrackets(String id) {
        AttributePath path =
                AttributePath.parse("robot/sensor[" + id + "]/motor[2]/@on").orElseThrow();
        assertEquals(
                List.of(
                        new AttributePath.PathStep("robot", ""),
                        new AttributePath.PathStep("sensor", id),
                        new AttributePath.PathStep("motor", "2")),
                path.steps());
        assertEquals("on", path.attribute());
    }
}
