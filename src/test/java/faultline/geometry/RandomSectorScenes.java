package faultline.geometry;

import java.util.SplittableRandom;

/**
 * Random sectors and figures for the oracles, the same on every run: the ordinary and, more often than chance would
 * have it, the awkward.
 */
final class RandomSectorScenes {

    private final SplittableRandom random;
    private final double size;

    /** Scenes from a seed, all lengths times {@code size}. */
    RandomSectorScenes(long seed, double size) {
        this.random = new SplittableRandom(seed);
        this.size = size;
    }

    /** Returns a sector of 1 to 150 degrees, sometimes of less or of nearly 180. */
    Sector sector() {
        double[] cones = {0.01, 1, 90, 150, 179, 179.9};
        double cone = random.nextInt(10) == 0 ? cones[random.nextInt(cones.length)] : random.nextDouble(1, 150);
        double bearing = random.nextInt(10) == 0 ? Math.PI / 2 * random.nextInt(4) : random.nextDouble(-10, 10);
        Vector2 apex = new Vector2(size * random.nextDouble(6), size * random.nextDouble(4));
        return Sector.of(apex, bearing, Math.toRadians(cone), size * random.nextDouble(0.05, 2));
    }

    /** Returns a figure near a sector. */
    ConvexShape figure(Sector sector) {
        Vector2 place = randomPointNear(sector);
        return switch (random.nextInt(4)) {
            case 0 -> new Disc(place.x(), place.y(), randomLength());
            case 1 ->
                new Ellipse(
                        RigidMotion.of(new Pose(place.x(), place.y(), random.nextDouble(7))),
                        randomLength(),
                        randomLength());
            default -> segment(place, randomPointNear(sector));
        };
    }

    /** A figure that touches an edge, the arc or the apex as nearly as numbers allow. */
    ConvexShape touching(Sector sector) {
        boolean atLeft = random.nextBoolean();
        Vector2 edge = atLeft ? sector.leftEdge() : sector.rightEdge();
        Vector2 out = edge.perpendicular().times(atLeft ? 1 : -1);
        Vector2 onEdge = sector.apex().plus(edge.times(sector.range() * random.nextDouble(1.1)));
        Vector2 onArc = sector.apex().plus(randomDirection(sector, 1).times(sector.range()));
        double radius = randomLength();
        return switch (random.nextInt(8)) {
            case 0 -> disc(onEdge.plus(out.times(radius)), radius);
            case 1 -> disc(onArc.plus(onArc.minus(sector.apex()).times(radius / sector.range())), radius);
            case 2 -> segment(onEdge, onEdge.plus(out.times(radius)));
            case 3 -> segment(onEdge, onEdge.plus(edge.times(radius)));
            case 4 -> segment(sector.apex(), randomPointNear(sector));
            case 5 -> segment(sector.apex().minus(edge.times(radius)), onEdge);
            case 6 ->
                disc(sector.apex().plus(Vector2.direction(random.nextDouble(7)).times(radius)), radius);
            default ->
                segment(
                        onArc.plus(onArc.minus(sector.apex()).perpendicular()),
                        onArc.minus(onArc.minus(sector.apex()).perpendicular()));
        };
    }

    /** A point in or about a sector, up to a fifth beyond its range. */
    private Vector2 randomPointNear(Sector sector) {
        Vector2 towards = randomDirection(sector, random.nextInt(3) == 0 ? 4 : 1.2);
        return sector.apex().plus(towards.times(1.2 * sector.range() * Math.sqrt(random.nextDouble())));
    }

    /** A direction within a share of the half cone from the axis. */
    private Vector2 randomDirection(Sector sector, double share) {
        double half = Math.atan2(sector.sinHalf(), sector.cosHalf());
        return Vector2.direction(sector.axis().angle() + share * half * random.nextDouble(-1, 1));
    }

    /** From half a millimetre to a metre, each decade as often as the next. */
    private double randomLength() {
        return size * Math.pow(10, random.nextDouble(-3.3, 0));
    }

    private Disc disc(Vector2 centre, double radius) {
        return new Disc(centre.x(), centre.y(), radius);
    }

    /** Returns the segment, sometimes shortened to a very short one or to a point. */
    private Segment segment(Vector2 from, Vector2 to) {
        return switch (random.nextInt(10)) {
            case 0 -> new Segment(from, from);
            case 1 -> new Segment(from, from.plus(to.minus(from).times(1e-4)));
            default -> new Segment(from, to);
        };
    }
}
