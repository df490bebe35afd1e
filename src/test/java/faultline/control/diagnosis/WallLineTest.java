package faultline.control.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.WallSide;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WallLineTest {

    private static final InspectedSensor[] SENSORS = IntStream.range(0, 8)
            .mapToObj(i -> new InspectedSensor(
                    i, MountedCone.of(RobotSpec.DEFAULT.sensors().get(i), WallSide.LEFT)))
            .toArray(InspectedSensor[]::new);

    /** The bits of all sensors. */
    private static final int ALL = (1 << SENSORS.length) - 1;

    /** Returns what the sensors read beside a disc, by looking along many rays in each cone. */
    private static double[] besideDisc(double heading, double radius) {
        Pose robot = new Pose(0, 0, heading);
        Vector2 centre = new Vector2(0, 0.35 + radius);
        double[] readings = new double[SENSORS.length];
        for (int i = 0; i < readings.length; i++) {
            MountedCone cone = SENSORS[i].cone();
            Vector2 apex = robot.toParent(new Vector2(cone.x(), cone.y()));
            double least = Reading.NOTHING;
            for (double off = -cone.half(); off <= cone.half(); off += cone.half() / 400) {
                least = Math.min(least, ray(apex, heading + cone.bearing() + off, centre, radius));
            }
            readings[i] = least > cone.range() ? Reading.NOTHING : least;
        }
        return readings;
    }

    private static double ray(Vector2 from, double direction, Vector2 centre, double radius) {
        double dx = centre.x() - from.x();
        double dy = centre.y() - from.y();
        double along = dx * Math.cos(direction) + dy * Math.sin(direction);
        double square = radius * radius - (dx * dx + dy * dy - along * along);
        return square < 0 || along < 0 ? Reading.NOTHING : along - Math.sqrt(square);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-5, 0, 3, 7})
    void beforeAWallThatIsAlmostStraightThereIsNoSag(double degrees) {
        double sag = new WallLine(SENSORS).sag(besideDisc(Math.toRadians(degrees), 500), ALL);
        assertEquals(0, sag, 0.012);
    }

    @Test
    void beforeARoundWallTheMiddleIsNearer() {
        double sag = new WallLine(SENSORS).sag(besideDisc(0, 1), ALL);
        assertTrue(sag < -0.03, "sag " + sag);
    }

    @Test
    void withoutOneOfTheThreeThereIsNoLine() {
        double[] readings = besideDisc(0, 500);
        readings[1] = Reading.NOTHING;
        assertTrue(Double.isNaN(new WallLine(SENSORS).sag(readings, ALL)));
        assertTrue(Double.isNaN(new WallLine(SENSORS).sag(besideDisc(0, 500), ALL & ~SENSORS[2].bit())));
    }

    @Test
    void allThreeMustSeeSomething() {
        WallLine line = new WallLine(SENSORS);
        double[] seen = besideDisc(0, 500);
        assertTrue(line.isSeen(seen));
        for (int place = 0; place < 3; place++) {
            int sensor = line.sensor(place).index();
            for (double unseen : new double[] {Reading.NOTHING, Reading.OFF, 0.81}) {
                double[] readings = seen.clone();
                readings[sensor] = unseen;
                assertFalse(line.isSeen(readings), "sensor " + sensor + ": " + unseen);
            }
        }
        assertEquals(seen[2], line.distance(seen));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void withoutOneOfTheThreeSensorsNothingIsSeen(int missing) {
        double[] seen = besideDisc(0, 500);
        WallLine line = new WallLine(IntStream.range(0, 8)
                .filter(i -> i != missing)
                .mapToObj(i -> SENSORS[i])
                .toArray(InspectedSensor[]::new));
        assertFalse(line.isSeen(seen));
        assertEquals(missing == 2 ? Reading.OFF : seen[2], line.distance(seen));
    }

    @Test
    void eachMeasuresTheDistanceFromTheCentreLine() {
        double[] readings = besideDisc(0, 500);
        WallLine line = new WallLine(SENSORS);
        for (int place = 0; place < 3; place++) {
            assertEquals(0.35, line.aside(place, readings), 0.001, "place " + place);
        }
    }

    @Test
    void itContainsTheThreeSensorsOnTheWallsSide() {
        WallLine line = new WallLine(SENSORS);
        for (InspectedSensor sensor : SENSORS) {
            boolean onSide = sensor == line.sensor(0) || sensor == line.sensor(1) || sensor == line.sensor(2);
            assertEquals(onSide, line.contains(sensor));
        }
        assertFalse(
                new WallLine(new InspectedSensor[] {SENSORS[0], SENSORS[2]}).contains(SENSORS[2]), "without a line");
    }
}
