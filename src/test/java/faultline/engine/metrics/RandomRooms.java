package faultline.engine.metrics;

import faultline.engine.walls.WallReference;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Rooms that were not used to tune the follower; a seed gives the same room in every run.
 *
 * @param offset of the robot's way from the wall, metres
 * @param minStraight of that way between two corners, metres
 * @param minInnerAngle the most acute inner corner, degrees
 * @param maxInnerAngle the most obtuse inner corner, degrees
 * @param minOuterTurn the least that the way turns at an outer corner, degrees
 * @param maxOuterTurn the most that the way turns at an outer corner, degrees
 */
record RandomRooms(
        double offset,
        double minStraight,
        double minInnerAngle,
        double maxInnerAngle,
        double minOuterTurn,
        double maxOuterTurn) {

    /**
     * What a follower at 0.25 m from its side must manage: inner corners of 45 to 150 degrees, outer corners with turns
     * of 30 to 150.
     */
    static final RandomRooms FEASIBLE = new RandomRooms(0.35, 0.5, 45, 150, 30, 150);

    private static final Vector2 MIDDLE = new Vector2(5, 5);
    private static final double START_CLEARANCE = 0.5;

    RandomRooms withMinStraight(double metres) {
        return new RandomRooms(offset, metres, minInnerAngle, maxInnerAngle, minOuterTurn, maxOuterTurn);
    }

    /** A star-shaped room with 4 to 9 corners. */
    PolygonRoom star(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PolygonRoom room;
        do {
            room = new PolygonRoom("star " + seed, starRing(random), Pose.ORIGIN);
        } while (!isFeasible(room));
        return room.withStart(randomStart(room, random));
    }

    private static List<Vector2> starRing(SplittableRandom random) {
        double[] shares = random.doubles(random.nextInt(4, 10), 0.5, 1.5).toArray();
        double all = 0;
        for (double share : shares) {
            all += share;
        }
        List<Vector2> ring = new ArrayList<>();
        double bearing = 0;
        for (double share : shares) {
            bearing += 2 * Math.PI * share / all;
            ring.add(MIDDLE.plus(Vector2.direction(bearing).times(random.nextDouble(1.2, 4))));
        }
        return ring;
    }

    /** A room of right angles: 5 m x 4 m with an alcove or a bump in the middle of each side. */
    PolygonRoom rectilinear(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PolygonRoom room;
        do {
            List<Vector2> ring = new ArrayList<>();
            for (int side = 0; side < 4; side++) {
                addSide(ring, side, random);
            }
            room = new PolygonRoom("rectilinear " + seed, ring, Pose.ORIGIN);
        } while (!isFeasible(room));
        return room.withStart(randomStart(room, random));
    }

    private static void addSide(List<Vector2> ring, int side, SplittableRandom random) {
        double half = side % 2 == 0 ? 2.5 : 2;
        double out = side % 2 == 0 ? 2 : 2.5;
        double from = random.nextDouble(-half + 0.9, 0);
        double to = random.nextDouble(0, half - 0.9);
        double step = random.nextDouble(0.6, 0.9) * (random.nextBoolean() ? 1 : -1);
        for (Vector2 point : List.of(
                new Vector2(-half, -out),
                new Vector2(from, -out),
                new Vector2(from, -out + step),
                new Vector2(to, -out + step),
                new Vector2(to, -out))) {
            ring.add(MIDDLE.plus(quarterTurns(point, side)));
        }
    }

    private static Vector2 quarterTurns(Vector2 point, int count) {
        Vector2 turned = point;
        for (int i = 0; i < count; i++) {
            turned = turned.perpendicular();
        }
        return turned;
    }

    /** A room of 7 m x 4 m whose lower wall goes in zig-zag, with three teeth. */
    PolygonRoom zigzag(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PolygonRoom room;
        do {
            List<Vector2> ring = new ArrayList<>(List.of(new Vector2(1.5, 3), new Vector2(2.2, 3)));
            for (int tooth = 0; tooth < 3; tooth++) {
                double x = 2.2 + 1.8 * tooth;
                ring.add(new Vector2(x + random.nextDouble(0.4, 1), 3 + random.nextDouble(0.3, 1.2)));
                ring.add(new Vector2(x + 1.4, 3));
            }
            ring.addAll(List.of(new Vector2(8.5, 3), new Vector2(8.5, 7), new Vector2(1.5, 7)));
            room = new PolygonRoom("zigzag " + seed, ring, Pose.ORIGIN);
        } while (!isFeasible(room));
        return room.withStart(randomStart(room, random));
    }

    /**
     * A free-standing convex polygon with 3 to 8 corners, to be walked round from outside; the robot starts heading for
     * it.
     */
    PolygonRoom island(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PolygonRoom room;
        do {
            room = new PolygonRoom("island " + seed, islandRing(random), new Pose(1, 5, 0));
        } while (!isFeasible(room));
        Vector2 at =
                MIDDLE.plus(Vector2.direction(random.nextDouble(2 * Math.PI)).times(4));
        Vector2 goal = room.centroid();
        return room.withStart(new Pose(at.x(), at.y(), goal.minus(at).angle()));
    }

    private static List<Vector2> islandRing(SplittableRandom random) {
        double rx = random.nextDouble(0.4, 2);
        double ry = random.nextDouble(0.4, 2);
        double[] bearings =
                random.doubles(random.nextInt(3, 9), -2 * Math.PI, 0).sorted().toArray();
        List<Vector2> ring = new ArrayList<>();
        for (double bearing : bearings) {
            Vector2 unit = Vector2.direction(-bearing);
            ring.add(MIDDLE.plus(new Vector2(rx * unit.x(), ry * unit.y())));
        }
        return ring;
    }

    /** Returns whether its corners are as requested, and the path along its wall is one ring. */
    private boolean isFeasible(PolygonRoom room) {
        double straights = 0;
        for (int i = 0; i < room.ring().size(); i++) {
            if (room.straightLength(i, offset) < minStraight || !isFeasible(Math.toDegrees(room.turn(i)))) {
                return false;
            }
            straights += room.straightLength(i, offset);
        }
        boolean inside = room.start().equals(Pose.ORIGIN);
        double places = new WallReference(room.world())
                .samples(offset, 0.02, 0).stream()
                        .filter(place -> room.surrounds(place.position()) == inside)
                        .mapToDouble(WallReference.WallSample::wallLength)
                        .sum();
        return Math.abs(places - straights) < 0.12 && cornersAreFree(room);
    }

    /** Whether the way leads round all outer corners, so that it is one ring and not several. */
    private boolean cornersAreFree(PolygonRoom room) {
        for (int i = 0; i < room.ring().size(); i++) {
            double out = room.corner(i).minus(room.corner(i - 1)).angle() + Math.PI / 2;
            for (double share = 0; share <= 1; share += 0.05) {
                Vector2 place = room.corner(i)
                        .plus(Vector2.direction(out + share * room.turn(i)).times(offset));
                if (room.turn(i) < 0 && room.distance(place) < offset - 1e-6) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isFeasible(double turn) {
        return turn > 0
                ? turn >= 180 - maxInnerAngle && turn <= 180 - minInnerAngle
                : turn <= -minOuterTurn && turn >= -maxOuterTurn;
    }

    /** Anywhere in the room where nothing is near. */
    private static Pose randomStart(PolygonRoom room, SplittableRandom random) {
        Vector2 at;
        do {
            at = new Vector2(random.nextDouble(1, 9), random.nextDouble(1, 9));
        } while (!room.surrounds(at) || room.distance(at) < START_CLEARANCE);
        return new Pose(at.x(), at.y(), random.nextDouble(2 * Math.PI));
    }
}
