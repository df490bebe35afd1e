package faultline.engine.walls;

import faultline.geometry.Angles;
import faultline.geometry.ConvexShape;
import faultline.geometry.Disc;
import faultline.geometry.Ellipse;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Places at a distance from one wall, in a row along it. Whether they are nearer to another wall is not considered.
 * Places are computed on demand, because a wall may be very long.
 */
sealed interface PlaceRow {

    /** A bound of the rounding error of a distance. */
    double ROUNDED_UP = 1 + 1e-9;

    /** Returns the number of places. */
    int size();

    Vector2 place(int index);

    /** Returns the way from the nearest point of the wall to a place, metres. */
    Vector2 offset(int index);

    /** Returns the length of the piece of wall that belongs to a place, metres; 0 at a corner, which only joins two. */
    double wallLength(int index);

    /**
     * Returns the position of a place in the order of all places of the wall, in which those of two sides alternate.
     */
    long rank(int index);

    /** Returns a distance that neighbours among some places do not exceed, metres. */
    double step(int from, int end);

    /** Returns an upper bound of the distance of some places from the middle one, metres. */
    default double radius(int from, int end) {
        return step(from, end) * ((end - from) / 2);
    }

    /** Returns how many places at either end may be near to those of another row of the same wall. */
    int shared(double joinDistance);

    /**
     * Returns a row of the same places and, if neighbours are farther from each other than a distance, others between
     * them. Only those around a thin or pointed ellipse can be: their spacing is that of its edge.
     */
    default PlaceRow joined(double joinDistance) {
        return this;
    }

    /**
     * Returns the rows of a wall: both sides of a segment and the arcs around its ends, or the path around an ellipse.
     *
     * @param wall the wall
     * @param distance the distance of the places, metres
     * @param spacing the spacing of the places, metres
     * @param reach the distance outside of an ellipse at which the places have that spacing, metres
     * @param circle the places around the origin, see {@link #circle}
     */
    static List<PlaceRow> of(ConvexShape wall, double distance, double spacing, double reach, List<Vector2> circle) {
        if (wall instanceof Segment segment) {
            int along = Math.max(1, (int) Math.ceil(segment.length() / spacing));
            PlaceRow start = new Arc(segment.a(), circle, 2L * along, 0, circle.size());
            PlaceRow end = new Arc(segment.b(), circle, 2L * along + circle.size(), 0, circle.size());
            return segment.length() > 0
                    ? List.of(Side.of(segment, 1, distance, along), Side.of(segment, -1, distance, along), start, end)
                    : List.of(start, end);
        }
        Ellipse oval = wall instanceof Disc disc ? disc.toEllipse() : (Ellipse) wall;
        double around = 2 * StrictMath.PI * (oval.boundingRadius() + reach);
        return List.of(new Ring(oval, distance, Math.max(8, (int) Math.ceil(around / spacing))));
    }

    /** Returns the places around the origin, computed once for all ends of segments. */
    static List<Vector2> circle(double distance, double spacing) {
        int size = (int) Math.ceil(2 * StrictMath.PI * distance / spacing);
        return IntStream.range(0, size)
                .mapToObj(i -> Vector2.direction(2 * StrictMath.PI * i / size).times(distance))
                .toList();
    }

    /** The places on one side of a segment. */
    record Side(Segment segment, Vector2 offset, int size, boolean left, double wallLength) implements PlaceRow {

        private static Side of(Segment segment, int side, double distance, int size) {
            Vector2 along = segment.b().minus(segment.a()).times(1 / segment.length());
            Vector2 offset = along.perpendicular().times(side).times(distance);
            return new Side(segment, offset, size, side > 0, segment.length() / size);
        }

        @Override
        public long rank(int index) {
            return 2L * index + (left ? 0 : 1);
        }

        @Override
        public Vector2 place(int index) {
            return segment.pointAt((index + 0.5) / size).plus(offset);
        }

        @Override
        public Vector2 offset(int index) {
            return offset;
        }

        @Override
        public double wallLength(int index) {
            return wallLength;
        }

        @Override
        public double step(int from, int end) {
            return wallLength * ROUNDED_UP;
        }

        /**
         * Returns a number that includes a small margin, because places of the arcs may count as free slightly beside
         * their corner.
         */
        @Override
        public int shared(double joinDistance) {
            return 2 + (int) Math.min(size, (joinDistance + 0.002 * offset.length()) / wallLength);
        }
    }

    /**
     * The places around an end of a segment, or some of them. They are free only at a convex corner.
     *
     * @param first the number of the first place on the circle
     */
    record Arc(Vector2 corner, List<Vector2> circle, long firstRank, int first, int size) implements PlaceRow {

        /** A bound of the angle between the direction to a free place and the perpendicular of a segment, radians. */
        private static final double MARGIN = 0.01;

        /** With shorter segments that angle may be greater, as a share of the distance. */
        private static final double MIN_LENGTH = 1e-3;

        /** Returns the places of this arc that are not surely nearer to one of two segments that end at the corner. */
        Arc outside(Segment one, Segment other) {
            double shortest = MIN_LENGTH * circle.get(0).length();
            if (one.length() < shortest || other.length() < shortest) {
                return this;
            }
            double angle = direction(one);
            double turn = Angles.difference(angle, direction(other));
            if (Math.abs(turn) > StrictMath.PI - MARGIN) {
                // The segments continue each other, so places on both sides are free.
                return this;
            }
            double middle = angle + turn / 2 + StrictMath.PI;
            double half = (StrictMath.PI - Math.abs(turn)) / 2 + MARGIN;
            double placesPerRadian = circle.size() / (2 * StrictMath.PI);
            int begin = (int) Math.floor((middle - half) * placesPerRadian);
            int count = (int) Math.ceil(2 * half * placesPerRadian) + 2;
            return new Arc(
                    corner, circle, firstRank, Math.floorMod(begin, circle.size()), Math.min(count, circle.size()));
        }

        Arc withFirstRank(long newRank) {
            return new Arc(corner, circle, newRank, first, size);
        }

        /** Returns whether the corner is an end of a segment. */
        boolean isAtEndOf(Segment segment) {
            return segment.ax() == corner.x() && segment.ay() == corner.y()
                    || segment.bx() == corner.x() && segment.by() == corner.y();
        }

        /** Returns the direction in which a segment leaves the corner, radians. */
        private double direction(Segment segment) {
            boolean ends = segment.bx() == corner.x() && segment.by() == corner.y();
            return (ends ? segment.a() : segment.b()).minus(corner).angle();
        }

        private int number(int index) {
            return (first + index) % circle.size();
        }

        @Override
        public long rank(int index) {
            return firstRank + number(index);
        }

        @Override
        public Vector2 place(int index) {
            return corner.plus(offset(index));
        }

        @Override
        public Vector2 offset(int index) {
            return circle.get(number(index));
        }

        @Override
        public double wallLength(int index) {
            return 0;
        }

        @Override
        public double step(int from, int end) {
            return circle.get(0).distanceTo(circle.get(circle.size() - 1)) * ROUNDED_UP;
        }

        @Override
        public int shared(double joinDistance) {
            return circle.size();
        }
    }

    /** The places around an ellipse. */
    record Ring(Ellipse oval, double distance, int size) implements PlaceRow {

        /** A row with more places has none added, although the path around a needle may need them. */
        private static final int MAX_DIVIDED = 1 << 16;

        @Override
        public Ring joined(double joinDistance) {
            Ring ring = this;
            while (ring.size <= MAX_DIVIDED && ring.step(0, ring.size) > joinDistance) {
                ring = new Ring(oval, distance, 2 * ring.size);
            }
            return ring;
        }

        @Override
        public long rank(int index) {
            return index;
        }

        @Override
        public Vector2 place(int index) {
            return foot(unit(index + 1)).plus(offset(index));
        }

        @Override
        public Vector2 offset(int index) {
            Vector2 unit = unit(index + 1);
            Vector2 across = new Vector2(unit.x() / oval.rx(), unit.y() / oval.ry());
            Vector2 normal = across.times(1 / across.length())
                    .rotated(oval.frame().cos(), oval.frame().sin());
            return normal.times(distance);
        }

        private Vector2 unit(int index) {
            return Vector2.direction(2 * StrictMath.PI * index / size);
        }

        private Vector2 foot(Vector2 unit) {
            return oval.frame().toParent(new Vector2(oval.rx() * unit.x(), oval.ry() * unit.y()));
        }

        @Override
        public double wallLength(int index) {
            Vector2 before = index == 0 ? oval.frame().toParent(new Vector2(oval.rx(), 0)) : foot(unit(index));
            return foot(unit(index + 1)).distanceTo(before);
        }

        @Override
        public double step(int from, int end) {
            double widest = 0;
            for (int i = from + 1; i < end; i++) {
                widest = Math.max(widest, place(i).distanceTo(place(i - 1)));
            }
            return widest * ROUNDED_UP;
        }

        @Override
        public double radius(int from, int end) {
            Vector2 middle = place(from + (end - from) / 2);
            double most = 0;
            for (int i = from; i < end; i++) {
                most = Math.max(most, place(i).distanceTo(middle));
            }
            return most;
        }

        @Override
        public int shared(double joinDistance) {
            return 0;
        }
    }
}
