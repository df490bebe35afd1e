package faultline.engine;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.world.WallMap;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Rooms that nobody has tuned a follower to; a seed gives the same room on every run.
 *
 * @param offset of the robot's way from the wall, metres
 * @param leastStraight of that way between two corners, metres
 * @param leastInner the most acute inner corner, degrees
 * @param mostInner the most obtuse inner corner, degrees
 * @param leastOuter the least that the way turns at an outer corner, degrees
 * @param mostOuter the most that the way turns at an outer corner, degrees
 */
record RandomRooms(double offset, double leastStraight, double leastInner, double mostInner, double leastOuter, double mostOuter) {

    /** What a follower at 0.25 m from its side must manage: inner corners of 45 to 150 degrees, outer corners with turns of 30 to 150. */
    static final RandomRooms FAIR = new RandomRooms(0.35, 0.5, 45, 150, 30, 150);

    private static final Vec MIDDLE = new Vec(5, 5);
    private static final double CLEAR = 0.5;

    RandomRooms withLeastStraight(double metres) {
        return new RandomRooms(offset, metres, leastInner, mostInner, leastOuter, mostOuter);
    }

    /** A star-shaped room with 4 to 9 corners. */
    Room star(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Room room;
        do {
            room = new Room("star " + seed, starRing(random), Pose.ORIGIN);
        } while (!isFair(room));
        return room.from(start(room, random));
    }

    private static List<Vec> starRing(SplittableRandom random) {
        double[] shares = random.doubles(random.nextInt(4, 10), 0.5, 1.5).toArray();
        double all = 0;
        for (double share : shares) {
            all += share;
        }
        List<Vec> ring = new ArrayList<>();
        double bearing = 0;
        for (double share : shares) {
            bearing += 2 * Math.PI * share / all;
            ring.add(MIDDLE.plus(Vec.direction(bearing).times(random.nextDouble(1.2, 4))));
        }
        return ring;
    }

    /** A room of right angles: 5 m x 4 m with an alcove or a bump in the middle of each side. */
    Room rectilinear(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Room room;
        do {
            List<Vec> ring = new ArrayList<>();
            for (int side = 0; side < 4; side++) {
                addSide(ring, side, random);
            }
            room = new Room("rectilinear " + seed, ring, Pose.ORIGIN);
        } while (!isFair(room));
        return room.from(start(room, random));
    }

    private static void addSide(List<Vec> ring, int side, SplittableRandom random) {
        double half = side % 2 == 0 ? 2.5 : 2;
        double out = side % 2 == 0 ? 2 : 2.5;
        double from = random.nextDouble(-half + 0.9, 0);
        double to = random.nextDouble(0, half - 0.9);
        double step = random.nextDouble(0.6, 0.9) * (random.nextBoolean() ? 1 : -1);
        for (Vec point : List.of(new Vec(-half, -out), new Vec(from, -out), new Vec(from, -out + step), new Vec(to, -out + step),
                new Vec(to, -out))) {
            ring.add(MIDDLE.plus(quarterTurns(point, side)));
        }
    }

    private static Vec quarterTurns(Vec point, int count) {
        Vec turned = point;
        for (int i = 0; i < count; i++) {
            turned = turned.perpendicular();
        }
        return turned;
    }

    /** A room of 7 m x 4 m whose lower wall goes in zig-zag, with three teeth. */
    Room zigzag(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Room room;
        do {
            List<Vec> ring = new ArrayList<>(List.of(new Vec(1.5, 3), new Vec(2.2, 3)));
            for (int tooth = 0; tooth < 3; tooth++) {
                double x = 2.2 + 1.8 * tooth;
                ring.add(new Vec(x + random.nextDouble(0.4, 1), 3 + random.nextDouble(0.3, 1.2)));
                ring.add(new Vec(x + 1.4, 3));
            }
            ring.addAll(List.of(new Vec(8.5, 3), new Vec(8.5, 7), new Vec(1.5, 7)));
            room = new Room("zigzag " + seed, ring, Pose.ORIGIN);
        } while (!isFair(room));
        return room.from(start(room, random));
    }

    /** A free-standing convex polygon with 3 to 8 corners, to be walked round from outside; the robot starts heading for it. */
    Room island(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        Room room;
        do {
            room = new Room("island " + seed, islandRing(random), new Pose(1, 5, 0));
        } while (!isFair(room));
        Vec at = MIDDLE.plus(Vec.direction(random.nextDouble(2 * Math.PI)).times(4));
        Vec goal = room.middle();
        return room.from(new Pose(at.x(), at.y(), goal.minus(at).angle()));
    }

    private static List<Vec> islandRing(SplittableRandom random) {
        double rx = random.nextDouble(0.4, 2);
        double ry = random.nextDouble(0.4, 2);
        double[] bearings = random.doubles(random.nextInt(3, 9), -2 * Math.PI, 0).sorted().toArray();
        List<Vec> ring = new ArrayList<>();
        for (double bearing : bearings) {
            Vec unit = Vec.direction(-bearing);
            ring.add(MIDDLE.plus(new Vec(rx * unit.x(), ry * unit.y())));
        }
        return ring;
    }

    /** Whether its corners are as asked, and the way round it is one ring. */
    private boolean isFair(Room room) {
        double straights = 0;
        for (int i = 0; i < room.ring().size(); i++) {
            if (room.straight(i, offset) < leastStraight || !isFair(Math.toDegrees(room.turn(i)))) {
                return false;
            }
            straights += room.straight(i, offset);
        }
        boolean inside = room.start().equals(Pose.ORIGIN);
        double places = new WallMap(room.world()).places(offset, 0.02).stream()
                .filter(place -> room.surrounds(place.at()) == inside).mapToDouble(WallMap.Place::length).sum();
        return Math.abs(places - straights) < 0.12 && cornersAreFree(room);
    }

    /** Whether the way leads round all outer corners, so that it is one ring and not several. */
    private boolean cornersAreFree(Room room) {
        for (int i = 0; i < room.ring().size(); i++) {
            double out = room.corner(i).minus(room.corner(i - 1)).angle() + Math.PI / 2;
            for (double share = 0; share <= 1; share += 0.05) {
                Vec place = room.corner(i).plus(Vec.direction(out + share * room.turn(i)).times(offset));
                if (room.turn(i) < 0 && room.distance(place) < offset - 1e-6) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isFair(double turn) {
        return turn > 0 ? turn >= 180 - mostInner && turn <= 180 - leastInner : turn <= -leastOuter && turn >= -mostOuter;
    }

    /** Anywhere in the room where nothing is near. */
    private static Pose start(Room room, SplittableRandom random) {
        Vec at;
        do {
            at = new Vec(random.nextDouble(1, 9), random.nextDouble(1, 9));
        } while (!room.surrounds(at) || room.distance(at) < CLEAR);
        return new Pose(at.x(), at.y(), random.nextDouble(2 * Math.PI));
    }
}
