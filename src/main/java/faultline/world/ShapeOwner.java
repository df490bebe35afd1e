package faultline.world;

/**
 * The owner of some convex shapes: an obstacle at one place, or the enclosing wall. Confined to the simulation thread.
 */
class ShapeOwner {

    private final String id;
    private final long order;
    private final double specularAngle;
    private final double specularTangent;
    private boolean removed;

    /**
     * Creates an owner.
     *
     * @param id reported in collisions
     * @param order drawing order: greater for owners drawn later
     * @param specularAngle the greatest angle of incidence that reflects light back, radians; {@link Obstacle#MATT} for
     *     all
     */
    ShapeOwner(String id, long order, double specularAngle) {
        this.id = id;
        this.order = order;
        this.specularAngle = specularAngle;
        this.specularTangent = tangent(specularAngle);
    }

    /** Returns the tangent of a specular angle; positive infinity for a matt surface. */
    static double tangent(double specularAngle) {
        return specularAngle < Obstacle.MATT ? StrictMath.tan(specularAngle) : Double.POSITIVE_INFINITY;
    }

    String id() {
        return id;
    }

    long order() {
        return order;
    }

    boolean isSpecular() {
        return specularAngle < Obstacle.MATT;
    }

    double specularAngle() {
        return specularAngle;
    }

    /** Returns the tangent of the specular angle; positive infinity for a matt surface. */
    double specularTangent() {
        return specularTangent;
    }

    /** Returns whether the shapes have left the world, though an index may still hold them. */
    boolean isRemoved() {
        return removed;
    }

    void markRemoved() {
        removed = true;
    }
}
