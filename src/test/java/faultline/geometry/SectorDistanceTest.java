package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Sector readings against the {@link SectorDistanceOracle}, to a billionth of a metre. */
class SectorDistanceTest {

    private static final int CASES = 10 * Integer.getInteger("faultline.shapes", 4000);
    private static final double TOLERANCE = 1e-9;
    private static final double OUT_OF_RANGE = Double.POSITIVE_INFINITY;

    /**
     * Sector apex (0, 0), axis along x, edges along (3, 4) and (3, -4), range 5: its outline has points with exact
     * coordinates.
     */
    private static final Sector EXACT = new Sector(new RigidMotion(1, 0, 0, 0), 0.6, 0.8, 5);

    @Test
    void anyFigureReadsAsTheOracleSays() {
        RandomSectorScenes scenes = new RandomSectorScenes(11, 1);
        int loose = 0;
        for (int i = 0; i < CASES; i++) {
            Sector sector = scenes.sector();
            loose += assertMatchesOracle(sector, scenes.figure(sector), TOLERANCE) ? 0 : 1;
        }
        assertTrue(loose < CASES / 100, loose + " of the ordinary cases left the oracle in doubt");
    }

    @Test
    void aFigureThatTouchesReadsAsOneOfTheSidesOfTheJump() {
        RandomSectorScenes scenes = new RandomSectorScenes(12, 1);
        for (int i = 0; i < CASES; i++) {
            Sector sector = scenes.sector();
            assertMatchesOracle(sector, scenes.touching(sector), TOLERANCE);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-3, 1e3, 1e6})
    void sizeDoesNotMatter(double size) {
        RandomSectorScenes scenes = new RandomSectorScenes(13, size);
        for (int i = 0; i < CASES / 10; i++) {
            Sector sector = scenes.sector();
            assertMatchesOracle(sector, scenes.figure(sector), TOLERANCE * size);
            assertMatchesOracle(sector, scenes.touching(sector), TOLERANCE * size);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1e-4, 1e-2, 1e2, 1e4, 1e6})
    void anEllipseMayBeAsThinAsALine(double aspect) {
        RandomSectorScenes scenes = new RandomSectorScenes(14, 1);
        for (int i = 0; i < CASES / 10; i++) {
            Sector sector = scenes.sector();
            Vector2 place = scenes.figure(sector).centre();
            double rx = Math.min(0.5, 0.5 * aspect);
            assertMatchesOracle(
                    sector, new Ellipse(RigidMotion.of(new Pose(place.x(), place.y(), i)), rx, rx / aspect), TOLERANCE);
        }
    }

    /** Whether the oracle was sure. */
    private static boolean assertMatchesOracle(Sector sector, ConvexShape figure, double tolerance) {
        SectorDistanceOracle.Bounds bounds = SectorDistanceOracle.bounds(sector, figure);
        double reading = SectorDistance.nearest(sector, figure);
        assertTrue(
                bounds.contains(reading, tolerance),
                () -> sector + " reads " + figure + " as " + reading + ", not " + bounds);
        return bounds.isTight(tolerance);
    }

    @Test
    void aFlatWallReadsItsPerpendicularFoot() {
        assertEquals(0.25, SectorDistance.nearest(EXACT, new Segment(0.25, -9, 0.25, 9)));
    }

    @Test
    void aThinPoleBetweenTheEdgesIsSeen() {
        assertEquals(1.999, SectorDistance.nearest(EXACT, new Disc(2, 0, 0.001)), 1e-15);
    }

    @Test
    void aWallThatLeavesTheConeReadsWhereItsEdgeIs() {
        // The wall y = 2 from the left enters the sector on the left edge at (1.5, 2).
        assertEquals(2.5, SectorDistance.nearest(EXACT, new Segment(-9, 2, 9, 2)), 1e-15);
    }

    @Test
    void whatIsBehindTheApexIsNotSeen() {
        assertEquals(OUT_OF_RANGE, SectorDistance.nearest(EXACT, new Segment(-0.001, -9, -0.001, 9)));
        assertEquals(OUT_OF_RANGE, SectorDistance.nearest(EXACT, new Disc(-0.5, 0, 0.4)));
    }

    /** Its edges are one line up to rounding. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-18})
    void aVeryNarrowConeSeesNothingBehindTheApex(double degrees) {
        SplittableRandom random = new SplittableRandom(15);
        for (int i = 0; i < CASES / 10; i++) {
            Vector2 apex = new Vector2(random.nextDouble(6), random.nextDouble(4));
            double bearing = i % 5 == 0 ? Math.PI / 2 * random.nextInt(4) : random.nextDouble(-7, 7);
            Sector sector = Sector.of(apex, bearing, Math.toRadians(degrees), 2);
            double distance = random.nextDouble(0.01, 1.5);
            double radius = Math.min(0.9 * distance, 0.1);
            Vector2 behind = apex.minus(sector.axis().times(distance));
            Vector2 out = Vector2.direction(bearing + random.nextDouble(0.6, 2.4));
            Vector2 end = behind.minus(out.times(random.nextDouble(distance)));
            Vector2 otherEnd = behind.plus(out.times(random.nextDouble(distance)));
            RigidMotion frame = RigidMotion.of(new Pose(behind.x(), behind.y(), random.nextDouble(7)));
            for (ConvexShape shape : List.of(
                    new Segment(end.x(), end.y(), otherEnd.x(), otherEnd.y()),
                    new Disc(behind.x(), behind.y(), radius),
                    new Ellipse(frame, radius, radius / 3))) {
                assertEquals(OUT_OF_RANGE, SectorDistance.nearest(sector, shape), () -> sector + " and " + shape);
            }
        }
    }

    @Test
    void theArcBelongsToTheSector() {
        assertEquals(5, SectorDistance.nearest(EXACT, new Segment(5, -1, 5, 1)));
        assertEquals(5, SectorDistance.nearest(EXACT, new Disc(6, 0, 1)));
        assertEquals(OUT_OF_RANGE, SectorDistance.nearest(EXACT, new Segment(5.000000001, -1, 5.000000001, 1)));
    }

    @Test
    void theEdgesBelongToTheSector() {
        Sector quarter = new Sector(new RigidMotion(1, 0, 0, 0), Math.sqrt(0.5), Math.sqrt(0.5), 5);
        assertEquals(Math.sqrt(2), SectorDistance.nearest(quarter, new Segment(1, 1, 1, 1)), 1e-15);
        assertEquals(Math.sqrt(2), SectorDistance.nearest(quarter, new Segment(1, -1, 0, -1)), 1e-15);
        assertEquals(Math.sqrt(2), SectorDistance.nearest(quarter, new Segment(1, 1, 3, 3)), 1e-15);
    }

    @Test
    void aFigureThroughTheApexReadsZero() {
        assertEquals(0, SectorDistance.nearest(EXACT, new Segment(0, 0, 3, 0)));
        assertEquals(0, SectorDistance.nearest(EXACT, new Segment(0, -1, 0, 1)));
        assertEquals(0, SectorDistance.nearest(EXACT, new Segment(0, 0, 0, 0)));
        assertEquals(0, SectorDistance.nearest(EXACT, new Disc(-1, 0, 1)));
        assertEquals(0, SectorDistance.nearest(EXACT, new Disc(0.1, 0.1, 1)));
    }
}
