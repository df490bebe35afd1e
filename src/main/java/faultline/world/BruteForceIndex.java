package faultline.world;

import faultline.geometry.ConvexShape;
import faultline.geometry.Vector2;

/** Checks every shape's bounding circle: the reference for any faster index. */
final class BruteForceIndex implements SpatialIndex {

    private final ConvexShape[] shapes;
    private final ShapeOwner[] owners;
    private final double[] x;
    private final double[] y;
    private final double[] boundingRadius;

    BruteForceIndex(CandidateBuffer all) {
        int size = all.size();
        shapes = all.shapes();
        owners = all.owners();
        x = new double[size];
        y = new double[size];
        boundingRadius = new double[size];
        for (int i = 0; i < size; i++) {
            Vector2 centre = shapes[i].centre();
            x[i] = centre.x();
            y[i] = centre.y();
            // A shape that the circle only just reaches must not be lost by rounding.
            boundingRadius[i] = shapes[i].boundingRadius() * (1 + 1e-12);
        }
    }

    @Override
    public int size() {
        return shapes.length;
    }

    @Override
    public ConvexShape shape(int number) {
        return shapes[number];
    }

    @Override
    public SpatialIndex copy() {
        return this;
    }

    @Override
    public void findNear(double px, double py, double distance, CandidateBuffer found) {
        for (int i = 0; i < shapes.length; i++) {
            double dx = x[i] - px;
            double dy = y[i] - py;
            double limit = distance + boundingRadius[i];
            if (dx * dx + dy * dy <= limit * limit) {
                found.add(shapes[i], owners[i], i);
            }
        }
    }
}
