package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Convex;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorOracle;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.Outline;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * What whole simulated scenes give every sensor, against the {@link SectorOracle} over every piece of every outline. The oracle knows where
 * movers are only until one of them has to wait for the robot, so that a yard is left at the first contact.
 */
class ReadingsTest {

    private static final int YARDS = 400;
    private static final double TOLERANCE = 1e-9;

    @Test
    void everyTrueReadingIsTheOracles() {
        SplittableRandom random = new SplittableRandom(81);
        int seen = 0;
        int loose = 0;
        for (int i = 0; i < YARDS; i++) {
            Setup setup = new RandomYards(random.nextLong(), robot(random), 0.5).next(random.nextInt(4));
            try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
                for (int tick = 0; tick < 3 && simulation.collision().isEmpty(); tick++) {
                    for (int sensor = 0; sensor < setup.robot().sensors().size(); sensor++) {
                        SectorOracle.Bounds bounds = bounds(setup, simulation, sensor);
                        double reading = simulation.trueReading(sensor);
                        int which = sensor;
                        assertTrue(bounds.allow(reading, TOLERANCE), () -> "sensor " + which + ": " + reading + ", not " + bounds + " at "
                                + simulation.pose() + " in " + setup);
                        assertEquals(reading, simulation.reportedReading(sensor), "without noise and faults the report is the truth");
                        seen += reading < Double.POSITIVE_INFINITY ? 1 : 0;
                        loose += bounds.tight(TOLERANCE) ? 0 : 1;
                    }
                    simulation.tick();
                }
            }
        }
        assertTrue(seen > 5 * YARDS && loose < YARDS / 4, seen + " readings, " + loose + " in doubt, in " + YARDS + " yards");
    }

    private static SectorOracle.Bounds bounds(Setup setup, Simulation simulation, int index) {
        SensorSpec sensor = setup.robot().sensors().get(index);
        Pose pose = simulation.pose();
        Sector sector = Sector.of(pose.toOuter(sensor.seat()), pose.heading() + sensor.bearing(), sensor.cone(), sensor.range());
        for (Obstacle obstacle : simulation.snapshot().obstacles()) {
            if (Outline.of(obstacle).contains(sector.apex())) {
                return new SectorOracle.Bounds(0, 0);
            }
        }
        double least = Double.POSITIVE_INFINITY;
        double most = Double.POSITIVE_INFINITY;
        for (Convex figure : RandomYards.figures(setup, simulation.time())) {
            SectorOracle.Bounds one = SectorOracle.reading(sector, figure);
            least = Math.min(least, one.least());
            most = Math.min(most, one.most());
        }
        return new SectorOracle.Bounds(least, most);
    }

    /** The usual robot with sensors of any cone and range, some seated well outside its body, where an obstacle may contain them. */
    private static RobotSpec robot(SplittableRandom random) {
        RobotSpec usual = RobotSpec.DEFAULT;
        List<SensorSpec> sensors = new ArrayList<>();
        for (SensorSpec sensor : usual.sensors()) {
            Vec seat = sensor.seat().times(random.nextInt(4) == 0 ? 3 : 1);
            sensors.add(new SensorSpec(sensor.id(), seat, random.nextDouble(-7, 7), random.nextDouble(0.1, 2),
                    Math.toRadians(random.nextDouble(1, 150)),
                    true, 0));
        }
        return new RobotSpec(usual.length(), usual.width(), usual.track(), usual.speed(), usual.turnRate(), usual.motor(), sensors);
    }
}
