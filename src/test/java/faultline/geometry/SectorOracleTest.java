package faultline.geometry;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;

/**
 * The judge judged: no point of a figure that lies in a sector is nearer than the oracle says, and one is as near up to the sampling's
 * step.
 */
class SectorOracleTest {

    private static final int SAMPLES = 20_000;

    @Test
    void theOracleAgreesWithSamplingWholeFigures() {
        SectorScenes scenes = new SectorScenes(15, 1);
        int seen = 0;
        for (int i = 0; i < 1000; i++) {
            Sector sector = scenes.sector();
            Convex figure = scenes.figure(sector);
            SectorOracle.Bounds bounds = SectorOracle.reading(sector, figure);
            double sampled = sampled(sector, figure);
            double step = 2 * Math.PI * figure.reach() / SAMPLES;
            boolean visible = sampled < Double.POSITIVE_INFINITY;
            seen += visible ? 1 : 0;
            assertTrue(sampled >= bounds.least() - 1e-12, () -> sector + " " + figure + " " + sampled + " " + bounds);
            // The nearest sample may lie a step further along an outline that an edge cuts at a sharp angle, so 20 steps are granted.
            assertTrue(!visible || sampled <= bounds.most() + 20 * step, () -> sector + " " + figure + " " + sampled + " " + bounds);
        }
        assertTrue(seen > 300, "too few of the scenes show anything: " + seen);
    }

    private static double sampled(Sector sector, Convex figure) {
        if (figure.nearestTo(sector.apex()).equals(sector.apex())) {
            return 0;
        }
        double nearest = Double.POSITIVE_INFINITY;
        IntFunction<Vec> point = points(figure);
        for (int i = 0; i <= SAMPLES; i++) {
            Vec p = point.apply(i).minus(sector.apex());
            if (p.length() <= sector.range() && sector.rightEdge().cross(p) >= 0 && p.cross(sector.leftEdge()) >= 0) {
                nearest = Math.min(nearest, p.length());
            }
        }
        return nearest;
    }

    private static IntFunction<Vec> points(Convex figure) {
        if (figure instanceof Segment segment) {
            return i -> segment.at(i / (double) SAMPLES);
        }
        Oval oval = figure instanceof Oval given ? given : Oval.at(new Pose(figure.centre().x(), figure.centre().y(), 0), figure.reach(),
                figure.reach());
        return i -> oval.toWorld(new Vec(oval.rx() * Math.cos(2 * Math.PI * i / SAMPLES), oval.ry() * Math.sin(2 * Math.PI * i / SAMPLES)));
    }
}
