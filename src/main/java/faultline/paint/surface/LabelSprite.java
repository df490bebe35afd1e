package faultline.paint.surface;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The image of a text with a halo, and the start of the text's baseline in it, device pixels. Images are cached,
 * because painting letters and halo takes fifty times as long as copying an image. They are aligned to whole device
 * pixels, which keeps the letters sharp.
 */
record LabelSprite(BufferedImage image, int left, int baseline) {

    /** Enough for the names of a crowded world: 5 to 18 MB, and up to 125 MB on a screen with a scale of 3. */
    private static final int MAX_CACHED = 1000;
    /** An upper bound of the width of the halo, pixels. */
    private static final int MARGIN = 3;

    private static final Map<SpriteKey, LabelSprite> CACHE =
            Collections.synchronizedMap(new LinkedHashMap<>(MAX_CACHED, 0.75f, true) {
                @Override
                protected boolean removeEldestEntry(Map.Entry<SpriteKey, LabelSprite> eldest) {
                    return size() > MAX_CACHED;
                }
            });

    /** All parameters of an image; the scale is device pixels per pixel. */
    private record SpriteKey(String text, Font font, Color colour, Color halo, double scale) {

        private LabelSprite render() {
            Shape letters = TextOutline.of(text, font, DrawContext.FONT_CONTEXT, 0, 0);
            Shape rim = DrawContext.HALO_STROKE.createStrokedShape(letters);
            AffineTransform larger = AffineTransform.getScaleInstance(scale, scale);
            Rectangle bounds = larger.createTransformedShape(rim).getBounds();
            bounds.grow(MARGIN, MARGIN);
            BufferedImage image = new BufferedImage(bounds.width, bounds.height, BufferedImage.TYPE_INT_ARGB_PRE);
            Graphics2D graphics = image.createGraphics();
            GraphicsSurface.enableAntialiasing(graphics);
            graphics.translate(-bounds.x, -bounds.y);
            graphics.scale(scale, scale);
            graphics.setColor(halo);
            graphics.fill(rim);
            graphics.setColor(colour);
            graphics.fill(letters);
            graphics.dispose();
            return new LabelSprite(image, -bounds.x, -bounds.y);
        }
    }

    /** Returns the image of a text; {@code scale} is device pixels per pixel. Any thread may call it. */
    static LabelSprite of(String text, Font font, Color colour, Color halo, double scale) {
        SpriteKey key = new SpriteKey(text, font, colour, halo, scale);
        LabelSprite cached = CACHE.get(key);
        return cached == null ? create(key) : cached;
    }

    /** Creates an image outside the lock of the cache: two threads may create the same image, which does no harm. */
    private static LabelSprite create(SpriteKey key) {
        LabelSprite sprite = key.render();
        CACHE.put(key, sprite);
        return sprite;
    }

    /** Paints the image with the start of its baseline at the device pixel nearest to a point. */
    void paint(Graphics2D graphics, double x, double y) {
        AffineTransform place = graphics.getTransform();
        Point2D at = place.transform(new Point2D.Double(x, y), null);
        graphics.setTransform(new AffineTransform());
        graphics.drawImage(image, (int) Math.rint(at.getX()) - left, (int) Math.rint(at.getY()) - baseline, null);
        graphics.setTransform(place);
    }
}
