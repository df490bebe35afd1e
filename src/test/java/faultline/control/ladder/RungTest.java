package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.geometry.Degrees;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RungTest {

    private static SensorDiagnosis diagnosis(RobotSpec robot, WallSide side, String on) {
        List<String> trusted = List.of(on.split(" "));
        double[] readings = robot.sensors().stream()
                .map(SensorSpec::id)
                .mapToDouble(id -> trusted.contains(id) ? Reading.NOTHING : Reading.OFF)
                .toArray();
        SensorDiagnosis diagnosis = new SensorDiagnosis(side);
        diagnosis.update(new Observation(0, 0.01, robot, readings), 0, 0, 1);
        return diagnosis;
    }

    private static SensorDiagnosis turned(String id, double degrees, String on) {
        RobotSpec robot = RobotSpec.DEFAULT;
        SensorSpec sensor = robot.sensor(id).orElseThrow();
        return diagnosis(robot.withSensor(sensor.withBearing(Degrees.toRadians(degrees))), WallSide.LEFT, on);
    }

    @ParameterizedTest
    @CsvSource({
        "LEFT, front front-left left rear-left rear rear-right right front-right, ALL, SIX_STATES",
        "LEFT, front front-left left rear-left rear rear-right right, REDUCED, SIX_STATES",
        "LEFT, front left, REDUCED, SIX_STATES",
        "LEFT, left rear right, THREE, MAP",
        "LEFT, front front-left rear, THREE, MAP",
        "LEFT, front rear-left, TWO, MAP",
        "LEFT, left right, TWO, MAP",
        "LEFT, left, ONE, MAP",
        "LEFT, front-left, ONE, MAP",
        "LEFT, rear-left, ONE, MAP",
        "LEFT, front, STOP, STOP",
        "LEFT, front rear rear-right right front-right, STOP, STOP",
        "LEFT, none, STOP, STOP",
        "RIGHT, front right, REDUCED, SIX_STATES",
        "RIGHT, front-right, ONE, MAP",
        "RIGHT, left front, STOP, STOP"
    })
    void theHighestRungWhoseNeedsAreMetDrives(WallSide side, String on, Rung rung, Rung.Strategy strategy) {
        assertEquals(rung, Rung.of(diagnosis(RobotSpec.DEFAULT, side, on)));
        assertEquals(strategy, rung.strategy());
    }

    @ParameterizedTest
    @CsvSource({
        "left, 71, REDUCED",
        "left, 69, TWO",
        "left, 109, REDUCED",
        "left, 111, TWO",
        "left, 41, TWO",
        "left, 39, STOP",
        "left, 139, TWO",
        "left, 141, STOP",
        "front, 19, REDUCED",
        "front, 21, TWO",
        "front, -19, REDUCED",
        "front, -21, TWO"
    })
    void bearingsWithin20DegreesFaceAndWithin50LookSideways(String id, double degrees, Rung expected) {
        assertEquals(expected, Rung.of(turned(id, degrees, "front left")));
    }

    @Test
    void theTrustedSensorClosestToThePerpendicularFacesTheWall() {
        assertEquals(
                OptionalInt.of(2),
                Rung.facingWall(diagnosis(RobotSpec.DEFAULT, WallSide.LEFT, "front-left left rear-left")));
        assertEquals(
                OptionalInt.empty(),
                Rung.facingWall(diagnosis(RobotSpec.DEFAULT, WallSide.LEFT, "front-left rear-left")));
        assertEquals(OptionalInt.of(1), Rung.facingWall(turned("front-left", 88, "front-left rear-left")));
        assertEquals(OptionalInt.of(2), Rung.facingWall(turned("front-left", 75, "front-left left")));
        assertEquals(OptionalInt.of(3), Rung.facingWall(turned("rear-left", 95, "front-left rear-left")));
    }

    @Test
    void losingASensorNeverLeadsToAHigherRung() {
        List<String> ids = RobotSpec.DEFAULT.sensorIds();
        Rung[] rungs = new Rung[1 << ids.size()];
        for (int on = 0; on < rungs.length; on++) {
            int mask = on;
            String trusted = IntStream.range(0, ids.size())
                    .filter(i -> (mask >> i & 1) == 1)
                    .mapToObj(ids::get)
                    .collect(Collectors.joining(" "));
            rungs[on] = Rung.of(diagnosis(RobotSpec.DEFAULT, WallSide.LEFT, trusted));
        }
        for (int on = 0; on < rungs.length; on++) {
            for (int lost = 1; lost < rungs.length; lost <<= 1) {
                assertTrue(
                        Rung.LADDER.indexOf(rungs[on & ~lost]) >= Rung.LADDER.indexOf(rungs[on]),
                        Integer.toBinaryString(on) + " without " + Integer.toBinaryString(lost));
            }
        }
        assertEquals(Rung.LADDER.size(), Stream.of(rungs).distinct().count());
    }
}
