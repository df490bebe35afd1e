package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;

/**
 * Tests the oracle itself: no point of a figure that lies in a sector is nearer than the oracle says, and one is as
 * near up to the sampling's step.
 */
class SectorDistanceOracleTest {

    private static final int SAMPLES = 20_000;

    @Test
    void theOracleAgreesWithSamplingWholeFigures() {
        RandomSectorScenes scenes = new RandomSectorScenes(15, 1);
        int seen = 0;
        for (int i = 0; i < 1000; i++) {
            Sector sector = scenes.sector();
            ConvexShape figure = scenes.figure(sector);
            SectorDistanceOracle.Bounds bounds = SectorDistanceOracle.bounds(sector, figure);
            double sampled = sampled(sector, figure);
            double step = 2 * Math.PI * figure.boundingRadius() / SAMPLES;
            boolean visible = sampled < Double.POSITIVE_INFINITY;
            seen += visible ? 1 : 0;
            assertTrue(sampled >= bounds.min() - 1e-12, () -> sector + " " + figure + " " + sampled + " " + bounds);
            // The nearest sample may lie a step further along an outline that an edge cuts at a sharp angle, so 20
            // steps are granted.
            assertTrue(
                    !visible || sampled <= bounds.max() + 20 * step,
                    () -> sector + " " + figure + " " + sampled + " " + bounds);
        }
        assertTrue(seen > 300, "too few of the scenes show anything: " + seen);
    }

    private static double sampled(Sector sector, ConvexShape figure) {
        if (figure.nearestTo(sector.apex()).equals(sector.apex())) {
            return 0;
        }
        double nearest = Double.POSITIVE_INFINITY;
        IntFunction<Vector2> point = points(figure);
        for (int i = 0; i <= SAMPLES; i++) {
            Vector2 p = point.apply(i).minus(sector.apex());
            if (p.length() <= sector.range() && sector.rightEdge().cross(p) >= 0 && p.cross(sector.leftEdge()) >= 0) {
                nearest = Math.min(nearest, p.length());
            }
        }
        return nearest;
    }

    private static IntFunction<Vector2> points(ConvexShape figure) {
        if (figure instanceof Segment segment) {
            return i -> segment.pointAt(i / (double) SAMPLES);
        }
        Ellipse oval = figure instanceof Ellipse given
                ? given
                : new Ellipse(
                        RigidMotion.of(
                                new Pose(figure.centre().x(), figure.centre().y(), 0)),
                        figure.boundingRadius(),
                        figure.boundingRadius());
        return i -> oval.frame()
                .toParent(new Vector2(
                        oval.rx() * Math.cos(2 * Math.PI * i / SAMPLES),
                        oval.ry() * Math.sin(2 * Math.PI * i / SAMPLES)));
    }
}
