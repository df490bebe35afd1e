package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The gap between the robot's body and a figure, against the {@link BoxDistanceOracle}. */
class BoxDistanceTest {

    private static final int CASES = Integer.getInteger("faultline.shapes", 3000);
    private static final double TOLERANCE = 1e-9;
    private static final OrientedBox BODY = new OrientedBox(new Pose(0, 0, 0), 2, 1);

    private final SplittableRandom random = new SplittableRandom(31);

    @Test
    void theDistanceIsTheOracles() {
        int apart = 0;
        for (int i = 0; i < CASES; i++) {
            OrientedBox box = randomBox();
            ConvexShape figure = randomShape();
            apart += assertMatchesOracle(box, figure) > 0 ? 1 : 0;
        }
        assertTrue(
                apart > CASES / 2 && apart < CASES * 98 / 100,
                "the test needs both kinds: " + apart + " of " + CASES + " lie apart");
    }

    @Test
    void aShapeMovedAlongItsSeparationTouches() {
        for (int i = 0; i < CASES; i++) {
            OrientedBox box = randomBox();
            ConvexShape figure = randomShape();
            Separation gap = BoxDistance.between(box, figure);
            Vector2 way = gap.onBox().minus(gap.onShape());
            assertTrue(assertMatchesOracle(box, figure.translated(way.x(), way.y())) < TOLERANCE);
        }
    }

    /** Figures that lie along a side, stand on a corner, or have shrunk to a point. */
    @Test
    void awkwardFiguresHaveTheOraclesDistanceToo() {
        for (int i = 0; i < CASES; i++) {
            OrientedBox box = randomBox();
            Vector2 corner = box.corner(random.nextInt(4));
            Vector2 ahead = new Vector2(box.frame().cos(), box.frame().sin()).times(random.nextDouble(-1, 1));
            assertMatchesOracle(box, new Segment(corner, corner.plus(ahead)));
            assertMatchesOracle(
                    box,
                    new Segment(
                            corner.plus(ahead.perpendicular()),
                            corner.plus(ahead.perpendicular()).plus(ahead)));
            assertMatchesOracle(box, new Segment(corner.plus(ahead), corner.plus(ahead)));
            assertMatchesOracle(box, new Disc(corner.x() + 0.5 * ahead.x(), corner.y() + 0.5 * ahead.y(), 0.0005));
            assertMatchesOracle(
                    box,
                    new Ellipse(
                            box.frame()
                                    .translated(
                                            corner.x() + ahead.x() - box.frame().x(),
                                            corner.y() + ahead.y() - box.frame().y()),
                            0.5,
                            0.0005));
            assertMatchesOracle(
                    box,
                    new Ellipse(
                            box.frame()
                                    .translated(
                                            corner.x() + ahead.x() - box.frame().x(),
                                            corner.y() + ahead.y() - box.frame().y()),
                            0.0005,
                            0.5));
        }
    }

    @Test
    void aWallAheadIsMeasuredFromTheFront() {
        assertEquals(
                0.5, BoxDistance.between(BODY, new Segment(1.5, -9, 1.5, 9)).distance());
    }

    @Test
    void aPoleOffACornerIsMeasuredFromTheCorner() {
        Separation gap = BoxDistance.between(BODY, new Disc(4, 4.5, 1));
        assertEquals(4, gap.distance(), 1e-15);
        assertEquals(0, gap.onBox().distanceTo(new Vector2(1, 0.5)), 1e-15);
    }

    @Test
    void aFigureWhollyInsideOverlapsAndSoDoesOneAround() {
        assertEquals(0, BoxDistance.between(BODY, new Segment(-0.1, 0, 0.1, 0)).distance());
        assertEquals(0, BoxDistance.between(BODY, new Disc(0.1, 0, 0.01)).distance());
        assertEquals(0, BoxDistance.between(BODY, new Disc(0, 0, 10)).distance());
        assertEquals(
                0,
                BoxDistance.between(BODY, new Ellipse(RigidMotion.of(new Pose(0, 0, 1)), 10, 5))
                        .distance());
    }

    /** Checks a gap, and gives its distance. */
    private static double assertMatchesOracle(OrientedBox box, ConvexShape figure) {
        Separation gap = BoxDistance.between(box, figure);
        assertEquals(BoxDistanceOracle.distance(box, figure), gap.distance(), TOLERANCE, () -> box + " and " + figure);
        assertEquals(
                gap.distance(),
                gap.onBox().distanceTo(gap.onShape()),
                TOLERANCE,
                () -> gap + " of " + box + " and " + figure);
        assertEquals(
                0, BoxDistanceOracle.outside(box, gap.onBox()), TOLERANCE, () -> gap + " of " + box + " and " + figure);
        assertEquals(
                0,
                BoxDistanceOracle.outside(figure, gap.onShape()),
                TOLERANCE,
                () -> gap + " of " + box + " and " + figure);
        return gap.distance();
    }

    private OrientedBox randomBox() {
        double heading = random.nextInt(5) == 0 ? Math.PI / 2 * random.nextInt(4) : random.nextDouble(-10, 10);
        return new OrientedBox(
                new Pose(random.nextDouble(4), random.nextDouble(4), heading),
                random.nextDouble(0.05, 0.8),
                random.nextDouble(0.05, 0.8));
    }

    private ConvexShape randomShape() {
        Vector2 place = new Vector2(random.nextDouble(4), random.nextDouble(4));
        return switch (random.nextInt(3)) {
            case 0 -> new Disc(place.x(), place.y(), randomLength());
            case 1 ->
                new Ellipse(
                        RigidMotion.of(new Pose(place.x(), place.y(), random.nextDouble(7))),
                        randomLength(),
                        randomLength());
            default ->
                new Segment(
                        place,
                        place.plus(Vector2.direction(random.nextDouble(7)).times(2 * randomLength())));
        };
    }

    private double randomLength() {
        return Math.pow(10, random.nextDouble(-3.3, 0.2));
    }
}
