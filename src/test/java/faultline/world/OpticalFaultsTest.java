package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.OpticalFault;
import faultline.sensor.SensorSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A sensor with faults of its optics reports what a sensor that is built so reports, and no other sensor changes. */
class OpticalFaultsTest {

    private static final int WORLDS = 8;
    private static final int TICKS = 300;
    private static final int FRONT_LEFT = 1;
    private static final Pose START = new Pose(3, 3, 0);

    private final SplittableRandom random = new SplittableRandom(2718);
    private int differences;

    private List<Obstacle> obstacles(long seed, double specularAngle) {
        SplittableRandom places = new SplittableRandom(seed);
        List<Obstacle> obstacles = new ArrayList<>();
        for (int i = 0; i < 14; i++) {
            double way = places.nextDouble(0.6, 2);
            double bearing = places.nextDouble(7);
            Pose pose = new Pose(
                    START.x() + way * Math.cos(bearing), START.y() + way * Math.sin(bearing), places.nextDouble(7));
            Obstacle round = new Obstacle("o" + i, new ObstacleShape.CircleShape(0.1), pose);
            Obstacle flat = new Obstacle(
                    "o" + i, new ObstacleShape.RectangleShape(0.3, 0.5), pose, WaypointPath.NONE, specularAngle);
            obstacles.add(i % 3 == 0 ? round : flat);
        }
        return obstacles;
    }

    private static World world(List<Obstacle> obstacles) {
        return new World(new WorldSpec(6, 6, false, 0, obstacles), RobotSpec.DEFAULT, START, 0.02, 1);
    }

    /** Runs three worlds alike and compares their readings: the faults act from tick 50 to tick 250. */
    private void compare(List<Fault> faults, SensorSpec builtSo, double specularAngle) {
        long seed = random.nextLong();
        World faulty = world(obstacles(seed, Obstacle.MATT));
        World sound = world(obstacles(seed, Obstacle.MATT));
        World built = world(obstacles(seed, specularAngle));
        built.execute(new Command.ConfigureSensor(builtSo));
        double left = random.nextDouble(-2, 2);
        double right = random.nextDouble(-2, 2);
        for (int tick = 0; tick < TICKS; tick++) {
            if (tick == 50) {
                faults.forEach(fault -> faulty.execute(new Command.InjectFault(builtSo.id(), fault)));
            } else if (tick == 250) {
                faulty.execute(new Command.ClearFaults(builtSo.id()));
            }
            for (World each : List.of(faulty, sound, built)) {
                each.move(left, right);
                each.sense();
            }
            assertEquals(sound.pose(), faulty.pose());
            boolean acts = tick >= 50 && tick < 250;
            for (int i = 0; i < RobotSpec.DEFAULT.sensors().size(); i++) {
                assertEquals(sound.trueReading(i), faulty.trueReading(i));
                World like = acts && i == FRONT_LEFT ? built : sound;
                assertEquals(like.reportedReading(i), faulty.reportedReading(i), faults + " at tick " + tick);
            }
            differences += built.trueReading(FRONT_LEFT) == sound.trueReading(FRONT_LEFT) ? 0 : 1;
        }
    }

    @Test
    void theReadingsAreThoseOfASensorThatIsBuiltSo() {
        SensorSpec sensor = RobotSpec.DEFAULT.sensors().get(FRONT_LEFT);
        for (int i = 0; i < WORLDS; i++) {
            double degrees = random.nextDouble(5, 80);
            double radians = StrictMath.toRadians(degrees);
            OpticalFault.Cone wide = new OpticalFault.Cone(degrees);
            OpticalFault.Misaligned turned = new OpticalFault.Misaligned(degrees);
            compare(List.of(wide), sensor.withCone(radians), Obstacle.MATT);
            compare(List.of(turned), sensor.withBearing(sensor.bearing() + radians), Obstacle.MATT);
            compare(
                    List.of(turned, wide),
                    sensor.withCone(radians).withBearing(sensor.bearing() + radians),
                    Obstacle.MATT);
            compare(List.of(new OpticalFault.SpecularLoss(degrees)), sensor, radians);
        }
        assertTrue(differences > TICKS, differences + " readings changed");
    }

    @Test
    void ofTwoSpecularLossesTheStrongerActs() {
        SensorSpec sensor = RobotSpec.DEFAULT.sensors().get(FRONT_LEFT);
        for (int i = 0; i < WORLDS; i++) {
            compare(
                    List.of(new OpticalFault.SpecularLoss(40), new OpticalFault.SpecularLoss(15)),
                    sensor,
                    StrictMath.toRadians(15));
        }
        assertTrue(differences > TICKS / 4, differences + " readings changed");
    }
}
