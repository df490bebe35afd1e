package faultline.world;

import faultline.geometry.Convex;
import faultline.geometry.Vec;

/** Looks at every figure's enclosing circle: the judge of any faster index. */
final class BruteForceIndex implements FigureIndex {

    private final Convex[] figures;
    private final int[] owners;
    private final double[] x;
    private final double[] y;
    private final double[] reach;

    /** An index over all figures of a list, which may be cleared afterwards. */
    BruteForceIndex(Candidates all) {
        int size = all.size();
        figures = new Convex[size];
        owners = new int[size];
        x = new double[size];
        y = new double[size];
        reach = new double[size];
        for (int i = 0; i < size; i++) {
            figures[i] = all.figure(i);
            owners[i] = all.owner(i);
            Vec centre = figures[i].centre();
            x[i] = centre.x();
            y[i] = centre.y();
            // Rounding of the circle must not hide a figure that just reaches.
            reach[i] = figures[i].reach() * (1 + 1e-12);
        }
    }

    @Override
    public void near(double px, double py, double distance, Candidates found) {
        for (int i = 0; i < figures.length; i++) {
            double dx = x[i] - px;
            double dy = y[i] - py;
            double limit = distance + reach[i];
            if (dx * dx + dy * dy <= limit * limit) {
                found.add(figures[i], owners[i]);
            }
        }
    }
}
