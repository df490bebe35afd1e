package faultline.campaign;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What a random room promises, tried on many seeds by brute force. */
class RandomRoomTest {

    private static final RoomRules SHARP_AND_VISITED = new RoomRules(45, 3);
    private static final double SPACING = 0.05;

    /** The promised distances hold to this, metres. */
    private static final double TOLERANCE = 1e-3;

    /** So many that the sides are within 0.1 mm of a pole. */
    private static final int CIRCLE_CORNERS = 64;

    /** A point on the outline of something that stands in the room, with the number of the side that it is on. */
    private record Point(Vector2 position, int thing, int side) {}

    private static Stream<RandomRoom> rooms() {
        return Stream.concat(
                LongStream.range(700_001, 700_061).mapToObj(RandomRoom::ofSeed),
                LongStream.range(710_001, 710_061).mapToObj(seed -> RandomRoom.ofSeed(seed, SHARP_AND_VISITED)));
    }

    private static List<Vector2> ring(RandomRoom room) {
        List<Vector2> points =
                ((ObstacleShape.WallShape) room.world().obstacles().get(0).shape()).points();
        return points.subList(0, points.size() - 1);
    }

    private static Vector2 corner(List<Vector2> ring, int i) {
        return ring.get(Math.floorMod(i, ring.size()));
    }

    /** The angle inside the room, degrees. */
    private static double innerAngle(List<Vector2> ring, int i) {
        Vector2 in = corner(ring, i).minus(corner(ring, i - 1));
        Vector2 out = corner(ring, i + 1).minus(corner(ring, i));
        double cross = in.x() * out.y() - in.y() * out.x();
        return 180 - Math.toDegrees(Math.atan2(cross, in.dot(out)));
    }

    private static boolean isInside(Vector2 point, List<Vector2> ring) {
        double turns = 0;
        for (int i = 0; i < ring.size(); i++) {
            Vector2 a = ring.get(i).minus(point);
            Vector2 b = corner(ring, i + 1).minus(point);
            turns += Math.atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        }
        return Math.abs(turns) > Math.PI;
    }

    private static boolean cross(Vector2 a, Vector2 b, Vector2 c, Vector2 d) {
        return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
    }

    private static double side(Vector2 a, Vector2 b, Vector2 point) {
        return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("rooms")
    void wallsAreASimplePolygonWithFairCorners(RandomRoom room) {
        List<Vector2> ring = ring(room);
        for (int i = 0; i < ring.size(); i++) {
            double angle = innerAngle(ring, i);
            assertTrue(
                    angle < 180 ? angle >= 45 - 1e-6 && angle <= 150 + 1e-6 : angle >= 210 && angle <= 300,
                    () -> "" + angle);
            for (int k = i + 2; k < ring.size() && (i > 0 || k < ring.size() - 1); k++) {
                assertFalse(
                        cross(ring.get(i), corner(ring, i + 1), ring.get(k), corner(ring, k + 1)),
                        "walls " + i + " and " + k + " cross");
            }
        }
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("rooms")
    void theStartIsFree(RandomRoom room) {
        Vector2 start = room.start().position();
        assertTrue(isInside(start, ring(room)));
        double distance = distanceToEverything(room, start);
        assertTrue(distance >= RandomRoom.START_CLEARANCE - TOLERANCE, () -> distance + " m");
        assertTrue(new World(room.world(), RobotSpec.DEFAULT, room.start(), 0.01, 1)
                .collision()
                .isEmpty());
    }

    /** The program measures to points of an outline. */
    @Test
    void theStartMayBeLessThanAMillimetreTooNear() {
        RandomRoom room = RandomRoom.ofSeed(8924);
        assertEquals(0.44974, distanceToEverything(room, room.start().position()), 1e-5);
    }

    private static double distanceToEverything(RandomRoom room, Vector2 point) {
        return IntStream.range(0, room.world().obstacles().size())
                .mapToObj(thing -> nearestPoints(room, thing, point))
                .flatMap(List::stream)
                .mapToDouble(near -> near.position.distanceTo(point))
                .min()
                .orElseThrow();
    }

    /** The nearest point of each side of something that stands; exact but for the circles. */
    private static List<Point> nearestPoints(RandomRoom room, int thing, Vector2 point) {
        Obstacle obstacle = room.world().obstacles().get(thing);
        if (!obstacle.motion().waypoints().isEmpty()) {
            return List.of();
        }
        List<Vector2> corners = corners(obstacle);
        return IntStream.range(0, corners.size())
                .mapToObj(side -> new Point(nearest(corners, side, point), thing, side))
                .toList();
    }

    /**
     * A passage is where two things, or two walls that do not meet, face each other: the disc between two points of
     * them contains no third. It is 0.9 m wide everywhere, to 1 mm.
     */
    @ParameterizedTest(name = "{index}")
    @MethodSource("rooms")
    void passagesAreWideEnough(RandomRoom room) {
        List<Point> points = outline(room);
        List<Vector2> ring = ring(room);
        int things = room.world().obstacles().size();
        for (Point one : points) {
            for (Point other : IntStream.range(0, things)
                    .mapToObj(thing -> nearestPoints(room, thing, one.position))
                    .flatMap(List::stream)
                    .toList()) {
                double width = one.position.distanceTo(other.position);
                if (width < RandomRoom.PASSAGE - TOLERANCE && !belongTogether(room, one, other)) {
                    Vector2 middle = one.position.plus(other.position).times(0.5);
                    assertFalse(
                            isInside(middle, ring) && isEmpty(points, middle, width / 2 - 1e-3),
                            () -> "a passage of " + width + " m between " + one + " and " + other);
                }
            }
        }
    }

    private static boolean isEmpty(List<Point> points, Vector2 middle, double radius) {
        return points.stream().noneMatch(point -> point.position.distanceTo(middle) < radius);
    }

    /** Whether two points are on one thing, on walls that meet, or on a wall and something that stands at it. */
    private static boolean belongTogether(RandomRoom room, Point one, Point other) {
        if (one.thing == other.thing) {
            int walls = ring(room).size();
            int apart = Math.floorMod(one.side - other.side, walls);
            return one.thing > 0 || apart <= 1 || apart == walls - 1;
        }
        if (other.thing == 0) {
            return belongTogether(room, other, one);
        }
        if (one.thing > 0) {
            return false;
        }
        return outlineOf(room, other.thing).stream()
                .anyMatch(point -> nearest(ring(room), one.side, point.position).distanceTo(point.position) < 2e-3);
    }

    private static Vector2 nearest(List<Vector2> ring, int side, Vector2 point) {
        Vector2 along = corner(ring, side + 1).minus(corner(ring, side));
        double share = Math.max(0, Math.min(1, point.minus(corner(ring, side)).dot(along) / along.dot(along)));
        return corner(ring, side).plus(along.times(share));
    }

    /** Points of everything that stands. */
    private static List<Point> outline(RandomRoom room) {
        List<Point> points = new ArrayList<>();
        for (int thing = 0; thing < room.world().obstacles().size(); thing++) {
            points.addAll(outlineOf(room, thing));
        }
        return points;
    }

    private static List<Point> outlineOf(RandomRoom room, int thing) {
        Obstacle obstacle = room.world().obstacles().get(thing);
        List<Point> points = new ArrayList<>();
        if (!obstacle.motion().waypoints().isEmpty()) {
            return points;
        }
        List<Vector2> corners = corners(obstacle);
        for (int side = 0; side < corners.size(); side++) {
            Vector2 from = corners.get(side);
            Vector2 along = corner(corners, side + 1).minus(from);
            int pieces = Math.max(1, (int) Math.ceil(along.length() / SPACING));
            for (int i = 0; i < pieces; i++) {
                points.add(new Point(from.plus(along.times((double) i / pieces)), thing, side));
            }
        }
        return points;
    }

    private static List<Vector2> corners(Obstacle obstacle) {
        List<Vector2> corners = new ArrayList<>();
        if (obstacle.shape() instanceof ObstacleShape.WallShape wall) {
            corners.addAll(wall.points().subList(0, wall.points().size() - 1));
        } else if (obstacle.shape() instanceof ObstacleShape.RectangleShape box) {
            for (int[] sign : new int[][] {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
                corners.add(new Vector2(sign[0] * box.width() / 2, sign[1] * box.height() / 2));
            }
        } else {
            double radius = ((ObstacleShape.CircleShape) obstacle.shape()).radius();
            for (int i = 0; i < CIRCLE_CORNERS; i++) {
                corners.add(Vector2.direction(i * 2 * Math.PI / CIRCLE_CORNERS).times(radius));
            }
        }
        double cos = Math.cos(obstacle.pose().heading());
        double sin = Math.sin(obstacle.pose().heading());
        corners.replaceAll(point -> point.rotated(cos, sin).plus(obstacle.pose().position()));
        return corners;
    }

    @Test
    void visitorsLeaveAPassageAllTheTime() {
        int visitors = 0;
        for (long seed = 720_001; seed < 720_021; seed++) {
            RandomRoom room = RandomRoom.ofSeed(seed, SHARP_AND_VISITED);
            List<Point> standing = outline(room);
            World world = new World(room.world(), RobotSpec.DEFAULT, room.start(), 0.1, 1);
            for (int tick = 0; tick < 600; tick++) {
                visitors += check(world.snapshot().obstacles(), standing);
                world.move(0, 0);
            }
            assertTrue(world.collision().isEmpty(), "a visitor ran over the robot at its start in room " + seed);
        }
        assertTrue(visitors > 600 * 10, "a visitor in every other room at least");
    }

    private static int check(List<Obstacle> obstacles, List<Point> standing) {
        List<Obstacle> moving = obstacles.stream()
                .filter(each -> !each.motion().waypoints().isEmpty())
                .toList();
        for (Obstacle visitor : moving) {
            Vector2 at = visitor.pose().position();
            double radius = visitor.shape().boundingRadius();
            standing.forEach(point -> assertTrue(point.position.distanceTo(at) >= RandomRoom.PASSAGE + radius));
            moving.stream()
                    .filter(other -> other != visitor)
                    .forEach(other -> assertTrue(other.pose().position().distanceTo(at)
                            >= RandomRoom.PASSAGE + radius + other.shape().boundingRadius()));
        }
        return moving.size();
    }

    @Test
    void cornersOf45To60DegreesAreMadeWhereTheyAreAllowed() {
        long sharp = LongStream.range(730_001, 730_201)
                .mapToObj(seed -> ring(RandomRoom.ofSeed(seed, SHARP_AND_VISITED)))
                .filter(ring -> IntStream.range(0, ring.size()).anyMatch(i -> innerAngle(ring, i) < 60))
                .count();
        assertTrue(sharp >= 20, sharp + " of 200 rooms");
        LongStream.range(730_001, 730_201)
                .mapToObj(seed -> ring(RandomRoom.ofSeed(seed)))
                .forEach(ring -> {
                    for (int i = 0; i < ring.size(); i++) {
                        assertTrue(innerAngle(ring, i) >= 60 - 1e-6);
                    }
                });
    }

    @Test
    void visitorsChangeNothingElseInARoom() {
        RandomRoom without = RandomRoom.ofSeed(740_001, new RoomRules(45, 0));
        RandomRoom with = RandomRoom.ofSeed(740_001, SHARP_AND_VISITED);
        int things = without.world().obstacles().size();
        assertEquals(without.start(), with.start());
        assertEquals(without.world().obstacles(), with.world().obstacles().subList(0, things));
        assertEquals(with, RandomRoom.ofSeed(740_001, SHARP_AND_VISITED));
        assertNotEquals(with, RandomRoom.ofSeed(740_002, SHARP_AND_VISITED));
    }

    /** The rooms of campaigns that were made before there were rules, when the shapes had shorter names. */
    @Test
    void roomsByTheDefaultRulesStayTheSame() {
        RandomRoom room = RandomRoom.ofSeed(7);
        assertEquals(HASH_OF_ROOM_7, room.toString().replace("Shape[", "[").hashCode());
    }

    private static final int HASH_OF_ROOM_7 = -1_247_155_165;
}
