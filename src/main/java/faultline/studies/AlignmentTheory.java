package faultline.studies;

import faultline.control.TimingRule;
import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Vector2;
import faultline.sensor.SensorSpec;
import faultline.world.ObstacleGeometry;
import java.util.List;

/**
 * What eq. (4) gives in theory. The left sensor sees the wall between two headings, the edges; for an endless wall they
 * lie at plus and minus the phi0 that solves R cos(max(0, phi0 - b)) + a cos(phi0) = D, with the range R, half the cone
 * b, the seat a and the distance D from centre to wall. Turning back for half the time ends in their middle, which is
 * parallel where the edges are symmetric. The paper's rule to the letter falls short of it by the motor's lag and half
 * a period.
 *
 * @param trial what is tried
 * @param walls the outlines that stand there
 * @param position where the robot's centre is
 */
record AlignmentTheory(AlignmentTrial trial, List<ConvexShape> walls, Vector2 position) {

    private static final double STEP = StrictMath.toRadians(0.05);
    private static final double NEAREST_RANGE = StrictMath.toRadians(20);
    private static final int BISECTION_STEPS = 40;

    static AlignmentTheory of(AlignmentTrial trial, Vector2 at) {
        List<ConvexShape> walls = trial.setup().world().obstacles().stream()
                .flatMap(obstacle -> ObstacleGeometry.of(obstacle).parts().stream())
                .toList();
        return new AlignmentTheory(trial, walls, at);
    }

    /** The mean heading error at the hand-over, radians. */
    double headingError() {
        double late =
                trial.timing() == TimingRule.RANGE ? trial.robot().motor().timeConstant() + trial.period() / 2 : 0;
        return middleHeading() - trial.robot().turnRate() * late;
    }

    /** How far single trials may be from the mean because a look comes up to one period late, radians. */
    double spread() {
        return trial.timing() == TimingRule.RANGE ? trial.robot().turnRate() * trial.period() / 2 : 0;
    }

    /** The middle between the two edges, radians from parallel. */
    private double middleHeading() {
        double level = edgeReading();
        return (edgeHeading(level, 1) + edgeHeading(level, -1)) / 2;
    }

    /**
     * The reading at which the sensor comes and leaves: the range, or a little more than the nearest, unless the
     * readings turn round before.
     */
    double edgeReading() {
        if (trial.timing() == TimingRule.RANGE) {
            return leftSensor().range();
        }
        double nearest = nearestHeading();
        double level = readingAt(nearest) * (1 + TimingRule.MARGIN);
        return Math.min(level, Math.min(maxReading(nearest, level, 1), maxReading(nearest, level, -1)));
    }

    /**
     * The heading of the nearest reading about parallel; it is not parallel itself where the axis misses the centre.
     */
    private double nearestHeading() {
        double nearest = 0;
        for (double heading = -NEAREST_RANGE; heading < NEAREST_RANGE; heading += STEP) {
            nearest = readingAt(heading) < readingAt(nearest) ? heading : nearest;
        }
        return nearest;
    }

    /** The farthest reading on one side of a heading before the readings fall again, looked for up to a level. */
    private double maxReading(double from, double level, int side) {
        double last = readingAt(from);
        for (double turned = STEP; turned < StrictMath.PI; turned += STEP) {
            double next = readingAt(from + side * turned);
            if (next > level || next < last - 1e-9) {
                return Math.min(level, Math.max(last, next));
            }
            last = next;
        }
        return last;
    }

    /** The heading at which the reading first comes up to a level, turning from the nearest reading to one side. */
    double edgeHeading(double level, int side) {
        double from = nearestHeading();
        double seen = 0;
        while (readingAt(from + side * (seen + STEP)) < level && seen < 2 * StrictMath.PI) {
            seen += STEP;
        }
        double unseen = seen + STEP;
        for (int i = 0; i < BISECTION_STEPS; i++) {
            double middle = (seen + unseen) / 2;
            if (readingAt(from + side * middle) < level) {
                seen = middle;
            } else {
                unseen = middle;
            }
        }
        return from + side * seen;
    }

    private double readingAt(double heading) {
        SensorSpec left = leftSensor();
        Sector sector = Sector.of(
                new Pose(position.x(), position.y(), heading).toParent(left.mountPosition()),
                heading + left.bearing(),
                left.cone(),
                left.range());
        double least = Double.POSITIVE_INFINITY;
        for (ConvexShape wall : walls) {
            least = Math.min(least, SectorDistance.nearest(sector, wall));
        }
        return least;
    }

    private SensorSpec leftSensor() {
        return trial.robot().sensor("left").orElseThrow();
    }
}
