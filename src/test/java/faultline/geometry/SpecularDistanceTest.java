package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A glossy surface answers only where light meets it steeply enough. */
class SpecularDistanceTest {

    private static final Segment WALL = new Segment(-10, 1, 10, 1);
    private static final double CONE = Math.toRadians(20);

    private static double nearest(Sector sector, Segment segment, double incidence) {
        return SpecularDistance.nearest(new SectorDistance(sector), segment, StrictMath.tan(incidence));
    }

    private static double reading(double bearing, double incidence) {
        return nearest(Sector.of(Vector2.ZERO, Math.toRadians(bearing), CONE, 5), WALL, Math.toRadians(incidence));
    }

    @Test
    void aPerpendicularViewReadsTheFoot() {
        assertEquals(1, reading(90, 5));
    }

    @Test
    void anObliqueViewReadsTheSteepestRayOfTheCone() {
        // The cone of 20 degrees about a slant of 40 reaches from an incidence of 30 to one of 50.
        assertEquals(1 / Math.cos(Math.toRadians(30)), reading(50, 35), 1e-12);
    }

    @Test
    void beyondItsAngleNothingIsReflected() {
        assertEquals(Double.POSITIVE_INFINITY, reading(50, 29));
    }

    @Test
    void aSurfaceFarFromItsFootIsNotSeen() {
        Segment aside = new Segment(2, 1, 3, 1);
        assertEquals(Double.POSITIVE_INFINITY, nearest(Sector.of(Vector2.ZERO, 0.4, 2, 5), aside, Math.toRadians(60)));
        assertEquals(Math.sqrt(5), nearest(Sector.of(Vector2.ZERO, 0.4, 2, 5), aside, Math.toRadians(64)), 1e-12);
    }

    @Test
    void itIsTheNearestOfManyReflectingPoints() {
        SplittableRandom random = new SplittableRandom(401);
        for (int i = 0; i < 300; i++) {
            Segment segment = new Segment(
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2));
            Sector sector = Sector.of(
                    Vector2.ZERO, random.nextDouble(6.3), random.nextDouble(0.1, 2.5), random.nextDouble(0.5, 3));
            double incidence = random.nextDouble(0.05, 1.5);
            assertEquals(sampled(sector, segment, incidence), nearest(sector, segment, incidence), 2e-3, "case " + i);
        }
    }

    @Test
    void itIsTheSameWhereverSensorAndSurfaceStand() {
        SplittableRandom random = new SplittableRandom(402);
        int seen = 0;
        for (int i = 0; i < 300; i++) {
            double bearing = random.nextDouble(6.3);
            Segment segment = new Segment(
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2),
                    random.nextDouble(-2, 2));
            double incidence = random.nextDouble(0.3, 1.5);
            Vector2 place = new Vector2(random.nextDouble(-9, 9), random.nextDouble(-9, 9));
            double expected = nearest(Sector.of(Vector2.ZERO, bearing, 2, 3), segment, incidence);
            double moved =
                    nearest(Sector.of(place, bearing, 2, 3), segment.translated(place.x(), place.y()), incidence);
            assertEquals(expected, moved, 1e-9, "case " + i);
            seen += expected < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertTrue(seen > 50, seen + " surfaces seen");
    }

    @Test
    void aSpeckReflectsInEveryDirection() {
        Sector sector = Sector.of(Vector2.ZERO, Math.toRadians(90), CONE, 5);
        Segment speck = new Segment(0.1, 1, 0.1, 1);
        assertEquals(Math.sqrt(1.01), nearest(sector, speck, 0.01), 1e-12);
    }

    @Test
    void aSurfaceThatReflectsAsAWholeWithinTheConeHasNoCircles() {
        Sector sector = Sector.of(Vector2.ZERO, Math.toRadians(90), CONE, 5);
        assertEquals(List.of(), SpecularDistance.intersections(sector, new Segment(-0.05, 1, 0.05, 1), 0.2));
    }

    private static List<Vector2> intersections(double bearing, double incidence) {
        return SpecularDistance.intersections(
                Sector.of(Vector2.ZERO, Math.toRadians(bearing), CONE, 5), WALL, Math.toRadians(incidence));
    }

    @Test
    void whereNothingIsReflectedNothingIsCircled() {
        assertEquals(List.of(), intersections(50, 29));
    }

    @Test
    void circlesMarkTheConeEdgesWhereEverythingSeenReflects() {
        assertAcross(10, intersections(90, 11));
    }

    @Test
    void circlesMarkTheEndsOfTheReflectingPartWithinTheCone() {
        assertAcross(5, intersections(90, 5));
    }

    /** Two circles, at an angle to the left and to the right, degrees. */
    private static void assertAcross(double degrees, List<Vector2> hits) {
        assertEquals(2, hits.size());
        assertEquals(
                -Math.tan(Math.toRadians(degrees)),
                hits.stream().mapToDouble(Vector2::x).min().orElseThrow(),
                1e-12);
        assertEquals(
                Math.tan(Math.toRadians(degrees)),
                hits.stream().mapToDouble(Vector2::x).max().orElseThrow(),
                1e-12);
    }

    private static double sampled(Sector sector, Segment segment, double incidence) {
        int points = 20_000;
        Vector2 normal = segment.b().minus(segment.a()).perpendicular();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i <= points; i++) {
            Vector2 point = segment.pointAt((double) i / points);
            double off = Math.acos(Math.min(1, Math.abs(point.dot(normal)) / point.length() / normal.length()));
            boolean inCone =
                    point.dot(sector.axis()) >= sector.cosHalf() * point.length() && point.length() <= sector.range();
            least = inCone && off <= incidence ? Math.min(least, point.length()) : least;
        }
        return least;
    }
}
