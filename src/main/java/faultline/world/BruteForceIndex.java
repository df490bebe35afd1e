package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;

/** Looks at every figure's enclosing circle: the judge of any faster index. */
final class BruteForceIndex implements SpatialIndex {

    private final ConvexShape[] shapes;
    private final int[] owners;
    private final double[] x;
    private final double[] y;
    private final double[] boundingRadius;

    /** An index over all figures of a list, which may be cleared afterwards. */
    BruteForceIndex(CandidateBuffer all) {
        int size = all.size();
        shapes = new ConvexShape[size];
        owners = new int[size];
        x = new double[size];
        y = new double[size];
        boundingRadius = new double[size];
        for (int i = 0; i < size; i++) {
            shapes[i] = all.shape(i);
            owners[i] = all.owner(i);
            Vector2 centre = shapes[i].centre();
            x[i] = centre.x();
            y[i] = centre.y();
            // Rounding of the circle must not hide a figure that just reaches.
            boundingRadius[i] = shapes[i].boundingRadius() * (1 + 1e-12);
        }
    }

    @Override
    public void findNear(double px, double py, double distance, CandidateBuffer found) {
        for (int i = 0; i < shapes.length; i++) {
            double dx = x[i] - px;
            double dy = y[i] - py;
            double limit = distance + boundingRadius[i];
            if (dx * dx + dy * dy <= limit * limit) {
                found.add(shapes[i], owners[i]);
            }
        }
    }
}
