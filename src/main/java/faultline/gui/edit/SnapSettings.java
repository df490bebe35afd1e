package faultline.gui.edit;

import faultline.geometry.Vector2;

/** The steps that positions and lengths, metres, and angles, radians, of a drag are rounded to; 0 for none. */
public record SnapSettings(double gridStep, double angleStep) {

    /** The step of lengths without a grid, metres. */
    private static final double MIN_STEP = 1e-4;

    private static final double MIN_DEGREES = 0.1;

    /** No snapping. */
    public static final SnapSettings NONE = new SnapSettings(0, 0);

    /** Returns the nearest point on the grid. */
    public Vector2 point(Vector2 free) {
        return new Vector2(length(free.x()), length(free.y()));
    }

    /** Returns the nearest point on the grid; without a grid, a coordinate that is as before is not rounded. */
    public Vector2 point(Vector2 before, Vector2 free) {
        return new Vector2(
                gridStep == 0 && free.x() == before.x() ? before.x() : length(free.x()),
                gridStep == 0 && free.y() == before.y() ? before.y() : length(free.y()));
    }

    /**
     * Returns the nearest length on the grid; without a grid, to a tenth of a millimetre, which is finer than a drag.
     */
    public double length(double free) {
        double step = gridStep > 0 ? gridStep : MIN_STEP;
        return Rounding.round(Math.rint(free / step) * step);
    }

    /** Returns the nearest allowed angle; without steps, to a tenth of a degree. */
    public double angle(double free) {
        return Rounding.roundAngle(free, angleStep > 0 ? Math.toDegrees(angleStep) : MIN_DEGREES);
    }
}
