package faultline.engine;

import faultline.geometry.ConvexShape;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.SectorDistance;
import faultline.geometry.Segment;
import faultline.geometry.Vector2;
import java.util.List;

/**
 * The range rule and nothing else, in steps far shorter than any control period: a sensor on the left of a robot that
 * spins right on the spot, the time t_D between its first and its last sight of the walls, and a turn back for t_p =
 * t_D / 2. Its error terms show here as they are.
 *
 * @param rate of the spin, radians per second, positive
 * @param period between two looks, seconds
 * @param phase of the first look, seconds, less than the period
 * @param tau the motors' time constant, seconds
 * @param mountPosition the sensor's apex, metres ahead and to the left of the centre of rotation
 * @param range metres
 * @param cone full angle, radians
 * @param level the reading up to which a wall counts as seen, metres
 * @param walls what there is; the robot's centre is at (0, 0), and heading 0 is parallel to the wall in question
 */
record AlignmentModel(
        double rate,
        double period,
        double phase,
        double tau,
        Vector2 mountPosition,
        double range,
        double cone,
        double level,
        List<ConvexShape> walls) {

    private static final double TIME_STEP = 1e-4;
    private static final double START_HEADING = Math.toRadians(200);

    /** A perfect robot beside one endless wall: no lag, looks at every step, axis through the centre. */
    static AlignmentModel ideal(double distance, double rate, double range, double cone) {
        return new AlignmentModel(
                rate,
                TIME_STEP,
                0,
                0,
                new Vector2(0, 0.1),
                range,
                cone,
                range,
                List.of(new Segment(-50, distance, 50, distance)));
    }

    AlignmentModel withSampling(double newPeriod, double newPhase) {
        return new AlignmentModel(rate, newPeriod, newPhase, tau, mountPosition, range, cone, level, walls);
    }

    AlignmentModel withLag(double newTau) {
        return new AlignmentModel(rate, period, phase, newTau, mountPosition, range, cone, level, walls);
    }

    AlignmentModel withMountPosition(Vector2 newMountPosition) {
        return new AlignmentModel(rate, period, phase, tau, newMountPosition, range, cone, level, walls);
    }

    AlignmentModel withWalls(List<ConvexShape> newWalls) {
        return new AlignmentModel(rate, period, phase, tau, mountPosition, range, cone, level, newWalls);
    }

    AlignmentModel withTimingLevel(double newLevel) {
        return new AlignmentModel(rate, period, phase, tau, mountPosition, range, cone, newLevel, walls);
    }

    /** The heading at the end of the turn back and after the spin has ended, radians; 0 is parallel. */
    double headingError() {
        return headingError(0);
    }

    /** The same with a turn back that is longer by some seconds. */
    double headingError(double longer) {
        double f3 = nextEdge(phase, true);
        double f4 = nextEdge(f3 + period, false);
        double tP = (f4 - f3) / 2; // eq. (4)
        return turnBack(START_HEADING - rate * f4, tP + longer);
    }

    /** The first look, from a given one on, at which a wall is seen or is not. */
    private double nextEdge(double from, boolean wanted) {
        double now = from;
        while (reading(START_HEADING - rate * now) <= level != wanted) {
            now += period;
            if (rate * now > 2 * Math.PI) {
                throw new IllegalStateException("a whole turn meets no such wall: " + this);
            }
        }
        return now;
    }

    /** From a spin at -rate: +rate for a time, then nothing, through a first-order motor. */
    private double turnBack(double from, double time) {
        double heading = from;
        double omega = -rate;
        double rest = 12 * tau;
        double keep = tau == 0 ? 0 : Math.exp(-TIME_STEP / tau);
        for (double now = 0; now < time + rest; now += TIME_STEP) {
            double share = Math.max(0, Math.min(1, (time - now) / TIME_STEP));
            double wanted = rate * share;
            // Computes the mean of omega over the step, and the rest of the difference.
            heading += wanted * TIME_STEP + (omega - wanted) * (tau == 0 ? 0 : tau * (1 - keep));
            omega = wanted + (omega - wanted) * keep;
        }
        return heading;
    }

    private double reading(double heading) {
        Sector sector = Sector.of(new Pose(0, 0, heading).toParent(mountPosition), heading + Math.PI / 2, cone, range);
        return walls.stream()
                .mapToDouble(wall -> SectorDistance.nearest(sector, wall))
                .min()
                .orElse(Double.POSITIVE_INFINITY);
    }
}
