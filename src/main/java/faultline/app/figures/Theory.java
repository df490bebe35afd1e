package faultline.app.figures;

import faultline.control.Timing;
import faultline.geometry.Convex;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Vec;
import faultline.sensor.SensorSpec;
import faultline.world.Outline;
import java.util.List;

/**
 * What eq. (4) gives in theory. The left sensor sees the wall between two headings, the edges; for an endless wall they lie at plus and
 * minus the phi0 that solves R cos(max(0, phi0 - b)) + a cos(phi0) = D, with the range R, half the cone b, the seat a and the distance D
 * from centre to wall. Turning back for half the time ends in their middle, which is parallel where the edges are symmetric. The paper's
 * rule to the letter falls short of it by the motor's lag and half a period.
 *
 * @param trial what is tried
 * @param walls the outlines that stand there
 * @param at where the robot's centre is
 */
record Theory(Alignment trial, List<Convex> walls, Vec at) {

    private static final double STEP = StrictMath.toRadians(0.05);
    private static final double NEAREST_WITHIN = StrictMath.toRadians(20);
    private static final int HALVINGS = 40;

    static Theory of(Alignment trial, Vec at) {
        List<Convex> walls = trial.setup().world().obstacles().stream().flatMap(obstacle -> Outline.of(obstacle).parts().stream()).toList();
        return new Theory(trial, walls, at);
    }

    /** The mean heading error at the hand-over, radians. */
    double error() {
        double late = trial.timing() == Timing.RANGE ? trial.robot().motor().timeConstant() + trial.period() / 2 : 0;
        return middle() - trial.robot().turnRate() * late;
    }

    /** How far single trials may be from the mean because a look comes up to one period late, radians. */
    double spread() {
        return trial.timing() == Timing.RANGE ? trial.robot().turnRate() * trial.period() / 2 : 0;
    }

    /** The middle between the two edges, radians from parallel. */
    private double middle() {
        double level = level();
        return (edge(level, 1) + edge(level, -1)) / 2;
    }

    /**
     * The reading at which the sensor comes and leaves: the range, or a little more than the nearest, unless the readings turn round
     * before.
     */
    double level() {
        if (trial.timing() == Timing.RANGE) {
            return left().range();
        }
        double nearest = nearest();
        double level = reading(nearest) * (1 + Timing.MARGIN);
        return Math.min(level, Math.min(summit(nearest, level, 1), summit(nearest, level, -1)));
    }

    /** The heading of the nearest reading about parallel; it is not parallel itself where the axis misses the centre. */
    private double nearest() {
        double nearest = 0;
        for (double heading = -NEAREST_WITHIN; heading < NEAREST_WITHIN; heading += STEP) {
            nearest = reading(heading) < reading(nearest) ? heading : nearest;
        }
        return nearest;
    }

    /** The farthest reading on one side of a heading before the readings fall again, looked for up to a level. */
    private double summit(double from, double level, int side) {
        double last = reading(from);
        for (double turned = STEP; turned < StrictMath.PI; turned += STEP) {
            double next = reading(from + side * turned);
            if (next > level || next < last - 1e-9) {
                return Math.min(level, Math.max(last, next));
            }
            last = next;
        }
        return last;
    }

    /** The heading at which the reading first comes up to a level, turning from the nearest reading to one side. */
    double edge(double level, int side) {
        double from = nearest();
        double seen = 0;
        while (reading(from + side * (seen + STEP)) < level && seen < 2 * StrictMath.PI) {
            seen += STEP;
        }
        double unseen = seen + STEP;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (seen + unseen) / 2;
            if (reading(from + side * middle) < level) {
                seen = middle;
            } else {
                unseen = middle;
            }
        }
        return from + side * seen;
    }

    private double reading(double heading) {
        SensorSpec left = left();
        Sector sector = Sector.of(new Pose(at.x(), at.y(), heading).toOuter(left.seat()), heading + left.bearing(), left.cone(), left.range());
        double least = Double.POSITIVE_INFINITY;
        for (Convex wall : walls) {
            least = Math.min(least, SectorDistance.nearest(sector, wall));
        }
        return least;
    }

    private SensorSpec left() {
        return trial.robot().sensor("left").orElseThrow();
    }
}
