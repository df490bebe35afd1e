package faultline.campaign;

import faultline.geometry.Angles;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Random rings of walls, counter-clockwise: star-shaped ones of 4 to 9 walls, and rectangles. Rings of right angles
 * with an alcove or a bump are drawn and refused: their outer corners are less than a passage away from another wall.
 * They are still drawn so that the numbers of rooms keep their rooms.
 */
final class RandomRing {

    private static final Vector2 MIDDLE = new Vector2(6, 6);

    /** The most obtuse inner corner, radians. */
    private static final double MAX_INNER = StrictMath.toRadians(150);

    /** The minimum and the maximum turn of the wall at an outer corner, radians. */
    private static final double MIN_OUTER = StrictMath.toRadians(30);

    private static final double MAX_OUTER = StrictMath.toRadians(120);

    /**
     * The length of the shortest wall, and the length by which an inner corner shortens the straight path along it,
     * metres.
     */
    private static final double MIN_STRAIGHT = 0.5;

    private static final double OFFSET = 0.35;

    private RandomRing() {}

    /** Makes a ring without inner corners sharper than an angle, radians. */
    static List<Vector2> next(SplittableRandom random, double minInner) {
        List<Vector2> ring;
        do {
            ring = random.nextInt(3) == 0 ? rectilinear(random) : star(random);
        } while (!isFair(ring, minInner));
        return ring;
    }

    private static List<Vector2> star(SplittableRandom random) {
        double[] shares = random.doubles(random.nextInt(4, 10), 0.5, 1.5).toArray();
        double all = 0;
        for (double share : shares) {
            all += share;
        }
        List<Vector2> ring = new ArrayList<>();
        double bearing = 0;
        for (double share : shares) {
            bearing += 2 * StrictMath.PI * share / all;
            ring.add(MIDDLE.plus(Vector2.direction(bearing).times(random.nextDouble(1.2, 4))));
        }
        return ring;
    }

    /** Returns a ring of right angles, of which only a rectangle is accepted. */
    private static List<Vector2> rectilinear(SplittableRandom random) {
        double halfWidth = random.nextDouble(2, 3.2);
        double halfHeight = random.nextDouble(2, 3.2);
        List<Vector2> ring = new ArrayList<>();
        for (int side = 0; side < 4; side++) {
            double half = side % 2 == 0 ? halfWidth : halfHeight;
            double out = side % 2 == 0 ? halfHeight : halfWidth;
            add(ring, -half, -out, side);
            if (random.nextBoolean()) {
                double from = random.nextDouble(-half + 0.9, -0.45);
                double to = random.nextDouble(0.45, half - 0.9);
                // The depth of an alcove or a bump is always less than the width of a passage.
                double step = random.nextDouble(0.5, 0.9) * (random.nextBoolean() ? 1 : -1);
                add(ring, from, -out, side);
                add(ring, from, -out + step, side);
                add(ring, to, -out + step, side);
                add(ring, to, -out, side);
            }
        }
        return ring;
    }

    private static void add(List<Vector2> ring, double x, double y, int quarterTurns) {
        Vector2 point = new Vector2(x, y);
        for (int i = 0; i < quarterTurns; i++) {
            point = point.perpendicular();
        }
        ring.add(MIDDLE.plus(point));
    }

    private static boolean isFair(List<Vector2> ring, double minInner) {
        int n = ring.size();
        for (int i = 0; i < n; i++) {
            if (!isFairTurn(turn(ring, i), minInner) || straight(ring, i) < MIN_STRAIGHT) {
                return false;
            }
        }
        return narrowest(ring) >= RandomRoom.PASSAGE;
    }

    private static boolean isFairTurn(double turn, double minInner) {
        return turn > 0
                ? turn >= StrictMath.PI - MAX_INNER - 1e-9 && turn <= StrictMath.PI - minInner
                : turn <= -MIN_OUTER && turn >= -MAX_OUTER;
    }

    /** Returns the turn of the wall at a corner, radians, positive at an inner corner. */
    private static double turn(List<Vector2> ring, int i) {
        Vector2 in = at(ring, i).minus(at(ring, i - 1));
        return Angles.difference(in.angle(), at(ring, i + 1).minus(at(ring, i)).angle());
    }

    private static double straight(List<Vector2> ring, int i) {
        return at(ring, i).distanceTo(at(ring, i + 1)) - cutOff(turn(ring, i)) - cutOff(turn(ring, i + 1));
    }

    private static double cutOff(double turn) {
        return Math.max(0, OFFSET * StrictMath.tan(turn / 2));
    }

    /** Returns the minimum distance between an outer corner and a wall that does not end there. */
    private static double narrowest(List<Vector2> ring) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            for (int k = 0; k < ring.size(); k++) {
                boolean touches = k == i || (k + 1) % ring.size() == i;
                if (!touches && turn(ring, i) < 0) {
                    least = Math.min(least, RoomPlan.distance(at(ring, i), at(ring, k), at(ring, k + 1)));
                }
            }
        }
        return least;
    }

    private static Vector2 at(List<Vector2> ring, int i) {
        return ring.get(Math.floorMod(i, ring.size()));
    }
}
