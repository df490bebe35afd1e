package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests ids, places and directions of new sensors. */
class NewSensorsTest {

    private static RobotSpec robot(double... bearings) {
        return RobotSpec.DEFAULT.withSensors(IntStream.range(0, bearings.length)
                .mapToObj(i -> new SensorSpec(
                        "s" + i, Vector2.ZERO, Degrees.toRadians(bearings[i]), 0.1 * (i + 1), 0.5, false, 0.01 * i))
                .toList());
    }

    private static double bearing(SensorSpec sensor) {
        return Math.toDegrees(sensor.bearing());
    }

    @Test
    void itFacesTheMiddleOfTheWidestGap() {
        assertEquals(0, bearing(new NewSensors(robot()).inWidestGap()));
        assertEquals(-150, bearing(new NewSensors(robot(30)).inWidestGap()), 1e-9);
        assertEquals(-157.5, bearing(new NewSensors(robot(-90, 0, 45, 135)).inWidestGap()), 1e-9);
        assertEquals(180, Math.abs(bearing(new NewSensors(robot(90, -90, 1)).inWidestGap())), 1e-9);
        assertEquals(22.5, bearing(new NewSensors(RobotSpec.DEFAULT).inWidestGap()), 1e-9, "the first of eight");
        assertEquals(60, bearing(new NewSensors(robot(720, 360 + 120, -480)).inWidestGap()), 1e-9);
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 0", "90, 0, 1", "180, -1, 0", "-90, 0, -1", "44.9, 1, 0.99651", "-135, -1, -1"})
    void itIsMountedAtTheEdgeOfThePlatform(double degrees, double x, double y) {
        RobotSpec square = robot().withPlatform(0.4, 0.4, 0.5);
        Vector2 at = new NewSensors(square).facing(Degrees.toRadians(degrees)).mountPosition();
        assertEquals(0.2 * x, at.x(), 1e-4);
        assertEquals(0.2 * y, at.y(), 1e-3);
    }

    @Test
    void itIsLikeTheSensorThatIsNearestInDirectionButOn() {
        SensorSpec added = new NewSensors(robot(0, 90, 180)).facing(Degrees.toRadians(-170));
        assertEquals(0.3, added.range(), 1e-12);
        assertEquals(0.02, added.noise());
        assertEquals(0.5, added.cone());
        assertTrue(added.on());
    }

    @Test
    void directionsAreMultiplesOfHalfADegree() {
        assertEquals(12.5, bearing(new NewSensors(robot()).facing(Degrees.toRadians(12.4))), 1e-12);
        assertEquals(-90, bearing(new NewSensors(robot()).facing(Degrees.toRadians(270.1))), 1e-12);
    }

    @Test
    void copiesLieSideBySide() {
        RobotSpec robot = RobotSpec.DEFAULT;
        for (int i = 0; i < 3; i++) {
            List<SensorSpec> sensors = new ArrayList<>(robot.sensors());
            sensors.add(new NewSensors(robot).copyOf(robot.sensor("left").orElseThrow()));
            robot = robot.withSensors(sensors);
        }
        List<SensorSpec> copies = robot.sensors().subList(8, 11);
        assertEquals(
                List.of("left-2", "left-3", "left-4"),
                copies.stream().map(SensorSpec::id).toList());
        assertEquals(
                List.of(110L, 130L, 150L),
                copies.stream().map(copy -> Math.round(bearing(copy))).toList());
    }

    @Test
    void anyRobotCanHaveAnotherSensorOfAnotherId() {
        SplittableRandom random = new SplittableRandom(31);
        for (int trial = 0; trial < 300; trial++) {
            double[] bearings = random.doubles(random.nextInt(40), -1000, 1000).toArray();
            RobotSpec robot = robot(bearings).withPlatform(random.nextDouble(0.05, 2), random.nextDouble(0.05, 2), 0.3);
            SensorSpec added = new NewSensors(robot).inWidestGap();
            Vector2 at = added.mountPosition();
            assertEquals(-1, robot.indexOf(added.id()));
            assertEquals(
                    1,
                    Math.max(Math.abs(at.x()) / robot.length() * 2, Math.abs(at.y()) / robot.width() * 2),
                    1e-3,
                    "at the edge");
            assertEquals(widestGap(bearings) / 2, distanceToNearest(bearing(added), bearings), 0.251);
        }
    }

    /** Returns the widest gap, degrees, by trying all pairs of directions. */
    private static double widestGap(double... bearings) {
        double widest = bearings.length == 0 ? 360 : 0;
        for (int i = 0; i < bearings.length; i++) {
            double narrowest = 360;
            for (int j = 0; j < bearings.length; j++) {
                double turn = ((bearings[j] - bearings[i]) % 360 + 360) % 360;
                narrowest = i == j ? narrowest : Math.min(narrowest, turn);
            }
            widest = Math.max(widest, narrowest);
        }
        return widest;
    }

    private static double distanceToNearest(double bearing, double... bearings) {
        double nearest = 180;
        for (double other : bearings) {
            nearest = Math.min(nearest, Math.abs(Math.IEEEremainder(other - bearing, 360)));
        }
        return nearest;
    }
}
