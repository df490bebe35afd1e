package faultline.paint.export;

import faultline.engine.Frame;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ObstacleOutlines;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.Snapshot;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;

/** Frames as pictures, made without a display by the painter that the window uses. */
public final class FrameRenderer {

    /**
     * What is left free about the world, pixels: room for the band, and below it for the scale bar, above it for the
     * badge.
     */
    private static final double MARGIN = 40;

    private FrameRenderer() {}

    /**
     * A picture of a whole world with the usual layers.
     *
     * @param frame what to paint
     * @param palette its colours; {@link Palette#LIGHT} for files
     * @param width pixels, positive
     * @param height pixels, positive
     * @return a new opaque picture
     */
    public static BufferedImage render(Frame frame, Palette palette, int width, int height) {
        return new RenderRequest(frame, fitCamera(frame.snapshot(), width, height), palette, Layer.defaults())
                .toImage(1);
    }

    /**
     * The camera that shows a whole world.
     *
     * @param world the world
     * @param width of the picture, pixels, positive
     * @param height of the picture, pixels, positive
     * @return a camera with a margin
     */
    public static Camera fitCamera(Snapshot world, int width, int height) {
        return Camera.fit(bounds(world), MARGIN, width, height);
    }

    /** The world's rectangle, and whatever stands outside of it. */
    private static Rectangle2D bounds(Snapshot world) {
        Rectangle2D bounds = new Rectangle2D.Double(0, 0, world.width(), world.height());
        for (Obstacle obstacle : world.obstacles()) {
            bounds = bounds.createUnion(ObstacleOutlines.worldShape(obstacle).getBounds2D());
        }
        return bounds;
    }
}
