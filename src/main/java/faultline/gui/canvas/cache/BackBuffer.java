package faultline.gui.canvas.cache;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.function.Consumer;

/**
 * The image in which a frame is painted before it is copied to the screen as a whole. It stays in main memory: drawing
 * translucent images in video memory, or copying images there, now and then takes as long as a frame.
 */
public final class BackBuffer {

    /** Null before the first frame. */
    private BufferedImage image;

    /**
     * Paints a component, whose size is in pixels, through the buffer at the resolution of the device, within the clip.
     * At a fractional scale (1.25, 1.5) the component may start within a device pixel; the buffer is drawn on whole
     * ones.
     */
    public void paint(Graphics2D graphics, int width, int height, Consumer<Graphics2D> painter) {
        AffineTransform device = graphics.getTransform();
        double scale = device.getScaleX();
        BufferedImage buffer = imageOfSize((int) Math.ceil(width * scale), (int) Math.ceil(height * scale));
        Graphics2D own = buffer.createGraphics();
        own.scale(scale, scale);
        own.clip(clip(graphics, width, height));
        painter.accept(own);
        own.dispose();
        graphics.setTransform(AffineTransform.getTranslateInstance(
                firstDevicePixel(device.getTranslateX()), firstDevicePixel(device.getTranslateY())));
        graphics.drawImage((Image) buffer, 0, 0, null);
        graphics.setTransform(device);
    }

    /** Returns the first device pixel of an area: the first one whose centre is inside. */
    private static double firstDevicePixel(double edge) {
        return Math.ceil(edge - 0.5);
    }

    /** Returns the clip, grown by a pixel: edges may be rounded differently in the buffer and on the device. */
    private static Rectangle clip(Graphics2D graphics, int width, int height) {
        Rectangle clip = new Rectangle(width, height);
        if (graphics.getClip() != null) {
            clip = graphics.getClipBounds();
            clip.grow(1, 1);
        }
        return clip;
    }

    private BufferedImage imageOfSize(int width, int height) {
        if (image == null || image.getWidth() != width || image.getHeight() != height) {
            image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
            image.setAccelerationPriority(0);
        }
        return image;
    }
}
