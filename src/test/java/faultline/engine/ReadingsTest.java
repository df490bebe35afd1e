package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistanceOracle;
import faultline.geometry.Vector2;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * What whole simulated scenes give every sensor, against the {@link SectorDistanceOracle} over every piece of every
 * outline. The oracle knows where movers are only until one of them has to wait for the robot, so that a yard is left
 * at the first contact.
 */
class ReadingsTest {

    private static final int WORLDS = 400;
    private static final double TOLERANCE = 1e-9;

    @Test
    void everyTrueReadingIsTheOracles() {
        SplittableRandom random = new SplittableRandom(81);
        int seen = 0;
        int loose = 0;
        for (int i = 0; i < WORLDS; i++) {
            SimulationSetup setup =
                    new RandomWorlds(random.nextLong(), randomRobot(random), 0.5).nextSetup(random.nextInt(4));
            try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
                for (int tick = 0; tick < 3 && simulation.collision().isEmpty(); tick++) {
                    for (int sensor = 0; sensor < setup.robot().sensors().size(); sensor++) {
                        SectorDistanceOracle.Bounds bounds = bounds(setup, simulation, sensor);
                        double reading = simulation.trueReading(sensor);
                        int which = sensor;
                        assertTrue(
                                bounds.contains(reading, TOLERANCE),
                                () -> "sensor " + which + ": " + reading + ", not " + bounds + " at "
                                        + simulation.pose() + " in " + setup);
                        assertEquals(
                                reading,
                                simulation.reportedReading(sensor),
                                "without noise and faults the report is the truth");
                        seen += reading < Double.POSITIVE_INFINITY ? 1 : 0;
                        loose += bounds.isTight(TOLERANCE) ? 0 : 1;
                    }
                    simulation.tick();
                }
            }
        }
        assertTrue(
                seen > 5 * WORLDS && loose < WORLDS / 4,
                seen + " readings, " + loose + " in doubt, in " + WORLDS + " yards");
    }

    private static SectorDistanceOracle.Bounds bounds(SimulationSetup setup, Simulation simulation, int index) {
        SensorSpec sensor = setup.robot().sensors().get(index);
        Pose pose = simulation.pose();
        Sector sector = Sector.of(
                pose.toParent(sensor.mountPosition()),
                pose.heading() + sensor.bearing(),
                sensor.cone(),
                sensor.range());
        for (Obstacle obstacle : simulation.snapshot().obstacles()) {
            if (ObstacleGeometry.of(obstacle).contains(sector.apex())) {
                return new SectorDistanceOracle.Bounds(0, 0);
            }
        }
        double least = Double.POSITIVE_INFINITY;
        double most = Double.POSITIVE_INFINITY;
        for (ConvexShape figure : RandomWorlds.shapesAt(setup, simulation.time())) {
            SectorDistanceOracle.Bounds one = SectorDistanceOracle.bounds(sector, figure);
            least = Math.min(least, one.min());
            most = Math.min(most, one.max());
        }
        return new SectorDistanceOracle.Bounds(least, most);
    }

    /**
     * The default robot with sensors of any cone and range, some mounted well outside its body, where an obstacle may
     * contain them.
     */
    private static RobotSpec randomRobot(SplittableRandom random) {
        RobotSpec standard = RobotSpec.DEFAULT;
        List<SensorSpec> sensors = new ArrayList<>();
        for (SensorSpec sensor : standard.sensors()) {
            Vector2 mountPosition = sensor.mountPosition().times(random.nextInt(4) == 0 ? 3 : 1);
            sensors.add(new SensorSpec(
                    sensor.id(),
                    mountPosition,
                    random.nextDouble(-7, 7),
                    random.nextDouble(0.1, 2),
                    Math.toRadians(random.nextDouble(1, 150)),
                    true,
                    0));
        }
        return new RobotSpec(
                standard.length(),
                standard.width(),
                standard.track(),
                standard.speed(),
                standard.turnRate(),
                standard.motor(),
                DriveScale.NONE,
                sensors);
    }
}
