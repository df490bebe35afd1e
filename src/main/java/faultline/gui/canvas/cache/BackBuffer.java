package faultline.gui.canvas.cache;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The image on which a frame is put together before it goes to the screen as a whole. All of it is done in memory: an
 * image that is sent to the screen's own memory, or something translucent that is laid upon it there, now and then
 * takes as long as a frame has time for.
 */
public final class BackBuffer {

    private Optional<BufferedImage> image = Optional.empty();

    /**
     * Paints by way of the plate, as crisp as the device that the graphics belongs to. Where that has one and a quarter
     * or one and a half pixels for one of ours, the picture may begin within a device pixel; the plate is laid on whole
     * ones.
     *
     * @param graphics the target; only what it is clipped to is painted
     * @param width of the picture, pixels
     * @param height of the picture, pixels
     * @param painter given a graphics of the same user space
     */
    public void paint(Graphics2D graphics, int width, int height, Consumer<Graphics2D> painter) {
        AffineTransform device = graphics.getTransform();
        double scale = device.getScaleX();
        BufferedImage plate = imageOfSize((int) Math.ceil(width * scale), (int) Math.ceil(height * scale));
        Graphics2D own = plate.createGraphics();
        own.scale(scale, scale);
        own.clip(clip(graphics, width, height));
        painter.accept(own);
        own.dispose();
        graphics.setTransform(AffineTransform.getTranslateInstance(
                firstDevicePixel(device.getTranslateX()), firstDevicePixel(device.getTranslateY())));
        graphics.drawImage((Image) plate, 0, 0, null);
        graphics.setTransform(device);
    }

    /** The first device pixel of an area that begins here: as everywhere, the first whose middle lies in it. */
    private static double firstDevicePixel(double edge) {
        return Math.ceil(edge - 0.5);
    }

    /**
     * What of the picture is wanted, and a pixel more: its edges may round to others on the plate than on the device.
     */
    private static Rectangle clip(Graphics2D graphics, int width, int height) {
        Rectangle clip = new Rectangle(width, height);
        if (graphics.getClip() != null) {
            clip = graphics.getClipBounds();
            clip.grow(1, 1);
        }
        return clip;
    }

    private BufferedImage imageOfSize(int width, int height) {
        BufferedImage plate = image.filter(kept -> kept.getWidth() == width && kept.getHeight() == height)
                .orElseGet(() -> new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB));
        plate.setAccelerationPriority(0);
        image = Optional.of(plate);
        return plate;
    }
}
