package faultline.paint.export;

import java.awt.geom.Rectangle2D;

/**
 * The part of the plane that a film shows. It grows in steps, so that its images differ only in what moves: a camera
 * that followed the robot would change each of them as a whole.
 */
public final class FilmBounds {

    /** The share of its size by which it grows beyond what must be shown, on each side. */
    private static final double STEP = 0.25;

    /** Null before the first image. */
    private Rectangle2D bounds;

    /**
     * Returns the bounds of the next image, given what it must show, metres. Those of the first image are exactly that.
     */
    public Rectangle2D next(Rectangle2D needed) {
        if (bounds == null) {
            bounds = needed;
        } else if (!bounds.contains(needed)) {
            Rectangle2D all = bounds.createUnion(needed);
            double dx = STEP * all.getWidth();
            double dy = STEP * all.getHeight();
            bounds = new Rectangle2D.Double(
                    all.getX() - dx, all.getY() - dy, all.getWidth() + 2 * dx, all.getHeight() + 2 * dy);
        }
        return bounds;
    }
}
