package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Round obstacles that pass several waypoints in a long tick, and a robot on its arc: the reference implementation
 * examines their distances 500 times in the tick, with independent arithmetic.
 */
class MeetingMoversTest {

    private static final int WORLDS = 200;
    private static final double TICK = 0.5;
    private static final double STEP = 1e-3;
    private static final Pose START = new Pose(10, 10, 0.7);

    /** A robot whose wheels have the speed of their voltage at once. */
    private static final RobotSpec ROBOT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 1, 10));

    private final SplittableRandom random = new SplittableRandom(314);

    /** A round obstacle, which stands if it has no speed. */
    private record Round(String id, double radius, Vector2 start, WaypointPath path) {

        Obstacle obstacle() {
            return new Obstacle(id, new ObstacleShape.CircleShape(radius), new Pose(start.x(), start.y(), 0), path);
        }

        Vector2 positionAt(double time) {
            double left = path.speed() * time;
            Vector2 at = start;
            int next = 0;
            while (left > 0 && (path.loop() || next < path.waypoints().size())) {
                Vector2 target = path.waypoints().get(next++ % path.waypoints().size());
                double length = target.distanceTo(at);
                if (length > left) {
                    return at.plus(target.minus(at).times(left / length));
                }
                left -= length;
                at = target;
            }
            return at;
        }
    }

    private Vector2 near(double spread) {
        return new Vector2(
                START.x() + random.nextDouble(-spread, spread), START.y() + random.nextDouble(-spread, spread));
    }

    private Round round(String id, boolean moves) {
        WaypointPath path = moves
                ? new WaypointPath(random.nextDouble(6), random.nextBoolean(), List.of(near(1), near(1), near(1)))
                : WaypointPath.NONE;
        return new Round(id, random.nextDouble(0.02, 0.3), near(1.5), path);
    }

    private static Pose poseAt(double left, double right, double time) {
        double v = (left + right) / 2;
        double omega = (right - left) / ROBOT.track();
        double turned = START.heading() + omega * time;
        return new Pose(
                START.x() + v / omega * (Math.sin(turned) - Math.sin(START.heading())),
                START.y() - v / omega * (Math.cos(turned) - Math.cos(START.heading())),
                turned);
    }

    /** Returns the distance between the body and a disc, negative if the disc overlaps it, metres. */
    private static double gap(Pose robot, Vector2 centre, double radius) {
        double dx = centre.x() - robot.x();
        double dy = centre.y() - robot.y();
        double ahead = Math.abs(Math.cos(robot.heading()) * dx + Math.sin(robot.heading()) * dy);
        double aside = Math.abs(Math.cos(robot.heading()) * dy - Math.sin(robot.heading()) * dx);
        return Math.hypot(Math.max(0, ahead - ROBOT.length() / 2), Math.max(0, aside - ROBOT.width() / 2)) - radius;
    }

    @Test
    void theFirstContactIsThatOfTheReference() {
        int collisions = 0;
        int free = 0;
        for (int i = 0; i < WORLDS; i++) {
            List<Round> rounds = new ArrayList<>();
            for (String id : List.of("a", "b", "c")) {
                Round round = round(id, !id.equals("c"));
                if (gap(START, round.start(), round.radius()) > 1e-3) {
                    rounds.add(round);
                }
            }
            double left = random.nextDouble(-2, 2);
            double right = random.nextDouble(-2, 2);
            List<Obstacle> obstacles = rounds.stream().map(Round::obstacle).toList();
            World world = new World(new WorldSpec(20, 20, false, 3, obstacles), ROBOT, START, TICK, 1);
            world.move(left, right);
            String name = "world " + i;
            if (world.collision().isPresent()) {
                collisions++;
                assertMeeting(name, world, rounds, left, right);
            } else {
                free++;
                assertFree(name, rounds, left, right, TICK);
                assertPose(name, poseAt(left, right, TICK), world.pose());
            }
            assertMoversGoOn(name, world, rounds);
        }
        assertTrue(collisions > WORLDS / 4 && free > WORLDS / 4, collisions + " collisions");
    }

    private static void assertPose(String name, Pose expected, Pose actual) {
        assertEquals(0, expected.position().distanceTo(actual.position()), 1e-9, name);
        assertEquals(expected.heading(), actual.heading(), 1e-9, name);
    }

    private static void assertFree(String name, List<Round> rounds, double left, double right, double end) {
        for (double time = 0; time < end; time += STEP) {
            for (Round round : rounds) {
                double gap = gap(poseAt(left, right, time), round.positionAt(time), round.radius());
                assertTrue(gap > -1e-9, name + ": " + round.id() + " overlaps at " + time + " s");
            }
        }
    }

    private static void assertMeeting(String name, World world, List<Round> rounds, double left, double right) {
        Collision collision = world.collision().orElseThrow();
        double time = collision.time();
        Pose stop = poseAt(left, right, time);
        assertFree(name, rounds, left, right, time);
        assertPose(name, stop, world.pose());
        assertEquals(new WheelSpeeds(0, 0), world.wheelSpeeds(), name);
        Round met = rounds.stream()
                .filter(round -> round.id().equals(collision.obstacle()))
                .findFirst()
                .orElseThrow();
        Vector2 centre = met.positionAt(time);
        assertEquals(0, gap(stop, centre, met.radius()), 1e-8, name);
        assertEquals(met.radius(), collision.point().distanceTo(centre), 1e-8, name);
        assertEquals(0, gap(stop, collision.point(), 0), 1e-8, name);
    }

    /** What meets no standing robot is at the end of its way, and nothing overlaps the robot. */
    private static void assertMoversGoOn(String name, World world, List<Round> rounds) {
        double stopped = world.collision().map(Collision::time).orElse(TICK);
        for (int i = 0; i < rounds.size(); i++) {
            Round round = rounds.get(i);
            Vector2 now = world.obstacles().get(i).pose().position();
            assertTrue(gap(world.pose(), now, round.radius()) > -1e-9, name + ": " + round.id() + " overlaps at last");
            double least = Double.POSITIVE_INFINITY;
            for (double time = stopped; time < TICK; time += STEP) {
                least = Math.min(least, gap(world.pose(), round.positionAt(time), round.radius()));
            }
            if (least > 5e-3) {
                assertEquals(0, now.distanceTo(round.positionAt(TICK)), 1e-9, name + ": " + round.id());
            } else if (least < -1e-3) {
                assertEquals(0, gap(world.pose(), now, round.radius()), 1e-8, name + ": " + round.id() + " is blocked");
            }
        }
    }
}
