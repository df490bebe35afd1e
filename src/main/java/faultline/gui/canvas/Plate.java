package faultline.gui.canvas;

import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The image on which a frame is put together before it goes to the screen as a whole. All of it is done in memory: an image that is sent to
 * the screen's own memory, or something translucent that is laid upon it there, now and then takes as long as a frame has time for.
 */
final class Plate {

    private Optional<BufferedImage> image = Optional.empty();

    /**
     * Paints by way of the plate, as crisp as the device that the graphics belongs to.
     *
     * @param graphics the target; only what it is clipped to is painted
     * @param width of the picture, pixels
     * @param height of the picture, pixels
     * @param painter given a graphics of the same user space
     */
    void paint(Graphics2D graphics, int width, int height, Consumer<Graphics2D> painter) {
        double scale = graphics.getTransform().getScaleX();
        BufferedImage plate = sized((int) Math.ceil(width * scale), (int) Math.ceil(height * scale));
        Graphics2D own = plate.createGraphics();
        own.scale(scale, scale);
        own.clip(graphics.getClip() == null ? new Rectangle(width, height) : graphics.getClip());
        painter.accept(own);
        own.dispose();
        graphics.scale(1 / scale, 1 / scale);
        graphics.drawImage((Image) plate, 0, 0, null);
        graphics.scale(scale, scale);
    }

    private BufferedImage sized(int width, int height) {
        BufferedImage plate = image.filter(kept -> kept.getWidth() == width && kept.getHeight() == height)
                .orElseGet(() -> new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB));
        plate.setAccelerationPriority(0);
        image = Optional.of(plate);
        return plate;
    }
}
