package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;
import org.junit.jupiter.api.Test;

/**
 * The circled points against sampling: every hit lies on both outlines, and wherever the sector's outline changes from
 * one side of the figure's to the other, a hit is there.
 */
class SectorIntersectionsTest {

    private static final int CASES = Integer.getInteger("faultline.shapes", 3000);
    private static final int SAMPLES = 1000;
    private static final double TOLERANCE = 1e-9;

    @Test
    void everyIntersectionLiesOnBothOutlines() {
        RandomSectorScenes scenes = new RandomSectorScenes(21, 1);
        int hits = 0;
        for (int i = 0; i < 10 * CASES; i++) {
            Sector sector = scenes.sector();
            ConvexShape figure = i % 4 == 0 ? scenes.touching(sector) : scenes.figure(sector);
            for (Vector2 hit : SectorIntersections.points(sector, figure)) {
                hits++;
                assertTrue(
                        offSector(sector, hit) <= TOLERANCE,
                        () -> hit + " is not on the outline of " + sector + " with " + figure);
                assertTrue(
                        offFigure(figure, hit) <= TOLERANCE,
                        () -> hit + " is not on the outline of " + figure + " in " + sector);
            }
        }
        assertTrue(hits > CASES, "too few hits for this test: " + hits);
    }

    @Test
    void noCrossingIsMissed() {
        RandomSectorScenes scenes = new RandomSectorScenes(22, 1);
        int crossings = 0;
        for (int i = 0; i < CASES; i++) {
            Sector sector = scenes.sector();
            ConvexShape figure = scenes.figure(sector);
            List<Vector2> hits = SectorIntersections.points(sector, figure);
            for (Vector2 crossing : crossings(sector, figure)) {
                crossings++;
                assertTrue(
                        hits.stream().anyMatch(hit -> hit.distanceTo(crossing) < 1e-7),
                        () -> crossing + " is missing in " + hits + " of " + figure + " in " + sector);
            }
        }
        assertTrue(crossings > CASES / 3, "too few crossings for this test: " + crossings);
    }

    @Test
    void aWallAcrossTheConeIsCircledOnBothEdges() {
        Sector sector = new Sector(new RigidMotion(1, 0, 0, 0), 0.8, 0.6, 5);
        List<Vector2> hits = SectorIntersections.points(sector, new Segment(2, -9, 2, 9));
        assertEquals(2, hits.size());
        assertTrue(hits.stream().anyMatch(hit -> hit.distanceTo(new Vector2(2, 1.5)) < 1e-15));
        assertTrue(hits.stream().anyMatch(hit -> hit.distanceTo(new Vector2(2, -1.5)) < 1e-15));
    }

    @Test
    void whatLiesWhollyInsideTheConeHasNoCircles() {
        Sector sector = new Sector(new RigidMotion(1, 0, 0, 0), 0.8, 0.6, 5);
        assertEquals(List.of(), SectorIntersections.points(sector, new Disc(3, 0, 0.1)));
    }

    private static double offSector(Sector sector, Vector2 point) {
        Vector2 p = point.minus(sector.apex());
        double offArc = p.dot(sector.axis()) >= (sector.cosHalf() - 1e-12) * p.length()
                ? Math.abs(p.length() - sector.range())
                : 1;
        return Math.min(
                offArc, Math.min(offEdge(sector, sector.leftEdge(), p), offEdge(sector, sector.rightEdge(), p)));
    }

    private static double offEdge(Sector sector, Vector2 edge, Vector2 p) {
        double along = Math.max(0, Math.min(sector.range(), p.dot(edge)));
        return p.distanceTo(edge.times(along));
    }

    /** How far a point lies off a figure's outline; for an ellipse to first order, level over gradient. */
    private static double offFigure(ConvexShape figure, Vector2 point) {
        if (figure instanceof Ellipse oval) {
            Vector2 local = oval.frame().toLocal(point);
            Vector2 slope = new Vector2(local.x() / oval.rx() / oval.rx(), local.y() / oval.ry() / oval.ry());
            return Math.abs(slope.dot(local) - 1) / (2 * slope.length());
        }
        return figure instanceof Segment segment
                ? offSegment(segment, point)
                : Math.abs(point.distanceTo(figure.centre()) - figure.boundingRadius());
    }

    private static double offSegment(Segment segment, Vector2 point) {
        Vector2 way = segment.b().minus(segment.a());
        double share = way.dot(way) == 0 ? 0 : point.minus(segment.a()).dot(way) / way.dot(way);
        return point.distanceTo(segment.pointAt(Math.max(0, Math.min(1, share))));
    }

    private static List<Vector2> crossings(Sector sector, ConvexShape figure) {
        double half = Math.atan2(sector.sinHalf(), sector.cosHalf());
        List<Vector2> found = new ArrayList<>();
        findCrossings(share -> sector.apex().plus(sector.leftEdge().times(share * sector.range())), figure, found);
        findCrossings(share -> sector.apex().plus(sector.rightEdge().times(share * sector.range())), figure, found);
        findCrossings(
                share -> {
                    double turn = (2 * share - 1) * half;
                    return sector.apex()
                            .plus(sector.axis()
                                    .rotated(Math.cos(turn), Math.sin(turn))
                                    .times(sector.range()));
                },
                figure,
                found);
        return found;
    }

    /** Adds where a curve over [0, 1] crosses a figure's outline, by sampling and bisection. */
    private static void findCrossings(DoubleFunction<Vector2> curve, ConvexShape figure, List<Vector2> found) {
        for (int i = 0; i < SAMPLES; i++) {
            double low = i / (double) SAMPLES;
            double high = (i + 1) / (double) SAMPLES;
            boolean side = inside(figure, curve.apply(low));
            if (side == inside(figure, curve.apply(high))) {
                continue;
            }
            for (int step = 0; step < 60; step++) {
                double middle = (low + high) / 2;
                if (inside(figure, curve.apply(middle)) == side) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            Vector2 crossing = curve.apply(low);
            if (!(figure instanceof Segment segment) || insideBand(segment, crossing)) {
                found.add(crossing);
            }
        }
    }

    /** Whether a point is inside the figure, or on the left of a segment's line. */
    private static boolean inside(ConvexShape figure, Vector2 point) {
        if (figure instanceof Segment segment) {
            return segment.b().minus(segment.a()).cross(point.minus(segment.a())) > 0;
        }
        if (figure instanceof Ellipse oval) {
            Vector2 local = oval.frame().toLocal(point);
            return Math.hypot(local.x() / oval.rx(), local.y() / oval.ry()) < 1;
        }
        return point.distanceTo(figure.centre()) < figure.boundingRadius();
    }

    /** Whether a point of a segment's line is clearly between its ends. */
    private static boolean insideBand(Segment segment, Vector2 point) {
        Vector2 way = segment.b().minus(segment.a());
        double share = point.minus(segment.a()).dot(way) / way.dot(way);
        return share * way.length() > TOLERANCE && (1 - share) * way.length() > TOLERANCE;
    }
}
