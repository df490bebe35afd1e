package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The gap between the robot's body and a figure, against the {@link BoxOracle}. */
class BoxGapTest {

    private static final int CASES = 3000;
    private static final double TOLERANCE = 1e-9;
    private static final Box BODY = new Box(new Pose(0, 0, 0), 2, 1);

    private final SplittableRandom random = new SplittableRandom(31);

    @Test
    void theDistanceIsTheOracles() {
        int apart = 0;
        for (int i = 0; i < CASES; i++) {
            Box box = box();
            Convex figure = figure();
            apart += judge(box, figure) > 0 ? 1 : 0;
        }
        assertTrue(apart > CASES / 2 && apart < CASES * 98 / 100, "a judge needs both kinds: " + apart + " of " + CASES + " lie apart");
    }

    @Test
    void movedAlongItsGapAFigureTouches() {
        for (int i = 0; i < CASES; i++) {
            Box box = box();
            Convex figure = figure();
            Gap gap = BoxGap.between(box, figure);
            Vec way = gap.onBox().minus(gap.onFigure());
            assertTrue(judge(box, figure.shifted(way.x(), way.y())) < TOLERANCE);
        }
    }

    /** Figures that lie along a side, stand on a corner, or have shrunk to a point. */
    @Test
    void awkwardFiguresHaveTheOraclesDistanceToo() {
        for (int i = 0; i < CASES; i++) {
            Box box = box();
            Vec corner = box.corner(random.nextInt(4));
            Vec ahead = new Vec(box.cos(), box.sin()).times(random.nextDouble(-1, 1));
            judge(box, new Segment(corner, corner.plus(ahead)));
            judge(box, new Segment(corner.plus(ahead.perpendicular()), corner.plus(ahead.perpendicular()).plus(ahead)));
            judge(box, new Segment(corner.plus(ahead), corner.plus(ahead)));
            judge(box, new Disc(corner.x() + 0.5 * ahead.x(), corner.y() + 0.5 * ahead.y(), 0.0005));
            judge(box, new Oval(corner.x() + ahead.x(), corner.y() + ahead.y(), 0.5, 0.0005, box.cos(), box.sin()));
            judge(box, new Oval(corner.x() + ahead.x(), corner.y() + ahead.y(), 0.0005, 0.5, box.cos(), box.sin()));
        }
    }

    @Test
    void aWallAheadIsMeasuredFromTheFront() {
        assertEquals(0.5, BoxGap.between(BODY, new Segment(1.5, -9, 1.5, 9)).distance());
    }

    @Test
    void aPoleOffACornerIsMeasuredFromTheCorner() {
        Gap gap = BoxGap.between(BODY, new Disc(4, 4.5, 1));
        assertEquals(4, gap.distance(), 1e-15);
        assertEquals(0, gap.onBox().distanceTo(new Vec(1, 0.5)), 1e-15);
    }

    @Test
    void aFigureWhollyInsideOverlapsAndSoDoesOneAround() {
        assertEquals(0, BoxGap.between(BODY, new Segment(-0.1, 0, 0.1, 0)).distance());
        assertEquals(0, BoxGap.between(BODY, new Disc(0.1, 0, 0.01)).distance());
        assertEquals(0, BoxGap.between(BODY, new Disc(0, 0, 10)).distance());
        assertEquals(0, BoxGap.between(BODY, Oval.at(new Pose(0, 0, 1), 10, 5)).distance());
    }

    /** Checks a gap, and gives its distance. */
    private static double judge(Box box, Convex figure) {
        Gap gap = BoxGap.between(box, figure);
        assertEquals(BoxOracle.distance(box, figure), gap.distance(), TOLERANCE, () -> box + " and " + figure);
        assertEquals(gap.distance(), gap.onBox().distanceTo(gap.onFigure()), TOLERANCE, () -> gap + " of " + box + " and " + figure);
        assertEquals(0, BoxOracle.outside(box, gap.onBox()), TOLERANCE, () -> gap + " of " + box + " and " + figure);
        assertEquals(0, BoxOracle.outside(figure, gap.onFigure()), TOLERANCE, () -> gap + " of " + box + " and " + figure);
        return gap.distance();
    }

    private Box box() {
        double heading = random.nextInt(5) == 0 ? Math.PI / 2 * random.nextInt(4) : random.nextDouble(-10, 10);
        return new Box(new Pose(random.nextDouble(4), random.nextDouble(4), heading), random.nextDouble(0.05, 0.8), random.nextDouble(0.05, 0.8));
    }

    private Convex figure() {
        Vec place = new Vec(random.nextDouble(4), random.nextDouble(4));
        return switch (random.nextInt(3)) {
            case 0 -> new Disc(place.x(), place.y(), length());
            case 1 -> Oval.at(new Pose(place.x(), place.y(), random.nextDouble(7)), length(), length());
            default -> new Segment(place, place.plus(Vec.direction(random.nextDouble(7)).times(2 * length())));
        };
    }

    private double length() {
        return Math.pow(10, random.nextDouble(-3.3, 0.2));
    }
}
