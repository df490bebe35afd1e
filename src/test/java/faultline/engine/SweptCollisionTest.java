package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.geometry.BoxDistanceOracle;
import faultline.geometry.ConvexShape;
import faultline.geometry.OrientedBox;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.DifferentialDrive;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.world.Collision;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleGeometry;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Collisions of whole simulated ticks against an oracle that looks at every moment: the exact arc is bisected for as
 * long as the speeds allow that body and obstacles could have met in between.
 */
class SweptCollisionTest {

    private static final RobotSpec SENSORLESS =
            new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of());
    private static final double CONTACT_TOLERANCE = 1e-10;
    private static final double PENETRATION_TOLERANCE = 1e-9;
    private static final int TICKS = 30;

    @ParameterizedTest
    @CsvSource({"41, 0, 50", "42, 0, 10", "43, 3, 50", "44, 3, 5", "45, 1, 0.5"})
    void theRobotStopsWhereTheOracleSaysAndOverlapsNothing(long seed, int movers, double topSpeed) {
        RandomWorlds yards = new RandomWorlds(seed, SENSORLESS, topSpeed);
        int collisions = 0;
        for (int i = 0; i < 40; i++) {
            collisions += runAndCompare(yards.nextSetup(movers)) ? 1 : 0;
        }
        assertTrue(topSpeed < 1 || collisions > 4, "too few collisions for this test: " + collisions);
    }

    /** Runs a yard, compares every tick with the oracle's, and says whether there was a collision. */
    private static boolean runAndCompare(SimulationSetup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            for (int tick = 1; tick <= TICKS; tick++) {
                Arc arc = Arc.next(setup, simulation);
                boolean already = simulation.collision().isPresent();
                simulation.tick();
                assertNoOverlap(setup, simulation);
                if (already) {
                    assertEquals(arc.start, simulation.pose(), "a robot that has collided stays where it is");
                } else {
                    arc.compare(setup, simulation);
                }
            }
            return simulation.collision().isPresent();
        }
    }

    private static void assertNoOverlap(SimulationSetup setup, Simulation simulation) {
        OrientedBox core = new OrientedBox(
                simulation.pose(),
                simulation.robot().length() - 2 * PENETRATION_TOLERANCE,
                simulation.robot().width() - 2 * PENETRATION_TOLERANCE);
        for (Obstacle obstacle : simulation.snapshot().obstacles()) {
            ObstacleGeometry outline = ObstacleGeometry.of(obstacle);
            assertTrue(!outline.contains(simulation.pose().position()), () -> "inside " + obstacle + " in " + setup);
            for (ConvexShape part : outline.parts()) {
                assertTrue(
                        BoxDistanceOracle.distance(core, part) > 0,
                        () -> simulation.pose() + " overlaps " + part + " at " + simulation.ticks() + " after "
                                + simulation.collision() + " in " + setup);
            }
        }
    }

    /** One tick's motion of the robot if nothing were in its way. */
    private record Arc(Pose start, double startTime, Velocity velocity, double dt) {

        static Arc next(SimulationSetup setup, Simulation before) {
            ControllerSpec.Drive drive = (ControllerSpec.Drive) setup.controller();
            double decay = setup.robot().motor().decay(setup.dt());
            double left = setup.robot().motor().step(before.wheelSpeeds().left(), drive.leftVolts(), decay);
            double right = setup.robot().motor().step(before.wheelSpeeds().right(), drive.rightVolts(), decay);
            return new Arc(
                    before.pose(),
                    before.time(),
                    new WheelSpeeds(left, right).toVelocity(SENSORLESS.track()),
                    setup.dt());
        }

        void compare(SimulationSetup setup, Simulation after) {
            OptionalDouble contact = firstContact(setup);
            assertEquals(
                    contact.isPresent(),
                    after.collision().isPresent(),
                    () -> contact + " " + after.collision() + " in " + setup);
            Pose expected = poseAt(contact.orElse(dt));
            assertEquals(
                    0, expected.position().distanceTo(after.pose().position()), 1e-7, () -> contact + " in " + setup);
            assertEquals(expected.heading(), after.pose().heading(), 1e-6, () -> contact + " in " + setup);
            if (contact.isPresent()) {
                Collision collision = after.collision().orElseThrow();
                Vector2 point = contactPoint(setup, contact.getAsDouble());
                assertEquals(
                        startTime + contact.getAsDouble(), collision.time(), 1e-7, () -> collision + " in " + setup);
                assertEquals(
                        0,
                        point.distanceTo(collision.point()),
                        1e-6,
                        () -> collision + " at " + point + " in " + setup);
            }
        }

        private Pose poseAt(double time) {
            return DifferentialDrive.advance(start, velocity, time);
        }

        private OrientedBox boxAt(double time) {
            return new OrientedBox(poseAt(time), SENSORLESS.length(), SENSORLESS.width());
        }

        private OptionalDouble firstContact(SimulationSetup setup) {
            double first = Double.POSITIVE_INFINITY;
            int figures = RandomWorlds.shapesAt(setup, startTime).size();
            for (int which = 0; which < figures; which++) {
                first = Math.min(first, firstContact(setup, which, 0, Math.min(first, dt)));
            }
            return first < Double.POSITIVE_INFINITY ? OptionalDouble.of(first) : OptionalDouble.empty();
        }

        /** No point of the body or an obstacle is faster than this, so that a distance cannot fall faster. */
        private double maxApproachSpeed(SimulationSetup setup) {
            double mover = setup.world().obstacles().stream()
                    .mapToDouble(o -> o.motion().speed())
                    .max()
                    .orElse(0);
            return Math.abs(velocity.linear()) + Math.abs(velocity.angular()) * SENSORLESS.boundingRadius() + mover;
        }

        private double firstContact(SimulationSetup setup, int which, double from, double to) {
            double least = distanceAt(setup, which, from);
            if (least <= CONTACT_TOLERANCE) {
                return from;
            }
            if (least - maxApproachSpeed(setup) * (to - from) > CONTACT_TOLERANCE || to - from < 1e-14) {
                return Double.POSITIVE_INFINITY;
            }
            double middle = (from + to) / 2;
            double early = firstContact(setup, which, from, middle);
            return early < Double.POSITIVE_INFINITY ? early : firstContact(setup, which, middle, to);
        }

        private double distanceAt(SimulationSetup setup, int which, double time) {
            return BoxDistanceOracle.distance(
                    boxAt(time), RandomWorlds.shapesAt(setup, startTime + time).get(which));
        }

        private Vector2 contactPoint(SimulationSetup setup, double time) {
            ConvexShape touched = RandomWorlds.shapesAt(setup, startTime + time).stream()
                    .min(Comparator.comparingDouble(figure -> BoxDistanceOracle.distance(boxAt(time), figure)))
                    .orElseThrow();
            return BoxDistanceOracle.nearest(boxAt(time), touched);
        }
    }

    @Test
    void noCommandMakesTheRobotOverlapAnything() {
        SplittableRandom random = new SplittableRandom(47);
        int refused = 0;
        int collisions = 0;
        for (int i = 0; i < 100; i++) {
            RandomWorlds yards = new RandomWorlds(random.nextLong(), SENSORLESS, 0.6);
            SimulationSetup setup = yards.nextSetup(2);
            try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
                for (int tick = 0; tick < TICKS; tick++) {
                    refused += simulation
                                    .execute(randomCommand(random, yards, simulation))
                                    .refusal()
                                    .isPresent()
                            ? 1
                            : 0;
                    assertNoOverlap(setup, simulation);
                    simulation.tick();
                    assertNoOverlap(setup, simulation);
                }
                collisions += simulation.collision().isPresent() ? 1 : 0;
            }
        }
        assertTrue(
                refused > 50 && collisions > 50 && collisions < 100,
                refused + " refused, " + collisions + " collisions");
    }

    /** Things put on or near the robot, or taken away, and platforms that grow and shrink. */
    private static Command randomCommand(SplittableRandom random, RandomWorlds yards, Simulation simulation) {
        Vector2 near = simulation
                .pose()
                .position()
                .plus(Vector2.direction(random.nextDouble(7)).times(random.nextDouble(1)));
        String id = "o" + random.nextInt(6);
        Pose pose = new Pose(near.x(), near.y(), random.nextDouble(7));
        return switch (random.nextInt(4)) {
            case 0 -> new Command.PlaceObstacle(new Obstacle(id, yards.randomShape(), pose));
            case 1 -> new Command.RemoveObstacle(id);
            case 2 -> new Command.SetPlatform(random.nextDouble(0.1, 0.4), random.nextDouble(0.1, 0.4), 0.3);
            default -> new Command.MoveObstacle(id, pose);
        };
    }

    @Test
    void aWallWithoutThicknessStopsARobotAtFiftyMetresASecondInOneTick() {
        Obstacle wall = new Obstacle(
                "wall", new ObstacleShape.WallShape(List.of(new Vector2(0, -1), new Vector2(0, 1))), new Pose(3, 2, 0));
        RobotSpec fast = new RobotSpec(0.25, 0.20, 0.18, 0.3, 1, new MotorSpec(0, 1, 50), DriveScale.NONE, List.of());
        SimulationSetup dash = SimulationSetup.of(new WorldSpec(6, 4, true, 0, List.of(wall)), new Pose(1, 2, 0))
                .withRobot(fast)
                .withController(new ControllerSpec.Drive(50, 50))
                .withTick(0.1)
                .withDuration(1);
        try (Simulation simulation = new Simulation(dash, ControllerMode.DIRECT)) {
            simulation.tick();
            // Flush against the front, which is 0.125 ahead of the centre: 1.875 m at 50 m/s, and the middle of the
            // front is the contact
            // point.
            Collision collision = simulation.collision().orElseThrow();
            assertEquals(2.875, simulation.pose().x(), PENETRATION_TOLERANCE);
            assertEquals(1.875 / 50, collision.time(), 1e-10);
            assertEquals(0, collision.point().distanceTo(new Vector2(3, 2)), 1e-6);
        }
    }
}
