package faultline.paint.surface;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A text with a halo as an image, kept because smoothing the edges of both takes fifty times as long as copying them. A
 * stamp lies on whole pixels of the device, which also keeps its letters sharp.
 *
 * @param image the text with its halo
 * @param left of the base line's left end, device pixels from the image's left
 * @param baseline of the base line, device pixels from the image's top
 */
record LabelSprite(BufferedImage image, int left, int baseline) {

    /** Enough for the names of a crowded world; some 10 MB at worst. */
    private static final int MAX_CACHED = 1000;
    /** The halo reaches less far than this beyond the letters, pixels. */
    private static final int MARGIN = 3;

    private static final FontRenderContext FONT_CONTEXT = new FontRenderContext(null, true, true);
    private static final Map<Key, LabelSprite> CACHE =
            Collections.synchronizedMap(new LinkedHashMap<>(MAX_CACHED, 0.75f, true) {
                @Override
                protected boolean removeEldestEntry(Map.Entry<Key, LabelSprite> eldest) {
                    return size() > MAX_CACHED;
                }
            });

    /** All that a stamp depends on; the scale is device pixels per pixel. */
    private record Key(String text, Font font, Color colour, Color halo, double scale) {

        private LabelSprite render() {
            Shape letters = font.createGlyphVector(FONT_CONTEXT, text).getOutline();
            Shape rim = DrawContext.HALO_STROKE.createStrokedShape(letters);
            AffineTransform larger = AffineTransform.getScaleInstance(scale, scale);
            Rectangle bounds = larger.createTransformedShape(rim).getBounds();
            bounds.grow(MARGIN, MARGIN);
            BufferedImage image = new BufferedImage(bounds.width, bounds.height, BufferedImage.TYPE_INT_ARGB_PRE);
            Graphics2D graphics = image.createGraphics();
            graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
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

    /** The stamp of a text; {@code scale} is device pixels per pixel. Any thread. */
    static LabelSprite of(String text, Font font, Color colour, Color halo, double scale) {
        Key look = new Key(text, font, colour, halo, scale);
        LabelSprite kept = CACHE.get(look);
        return kept == null ? create(look) : kept;
    }

    /** Made outside the map's lock: two threads may make the same, which does no harm. */
    private static LabelSprite create(Key look) {
        LabelSprite stamp = look.render();
        CACHE.put(look, stamp);
        return stamp;
    }

    /** Puts the base line's left end to the whole pixel of the device that is nearest to a place. */
    void paint(Graphics2D graphics, double x, double y) {
        AffineTransform place = graphics.getTransform();
        Point2D at = place.transform(new Point2D.Double(x, y), null);
        graphics.setTransform(new AffineTransform());
        graphics.drawImage(image, (int) Math.rint(at.getX()) - left, (int) Math.rint(at.getY()) - baseline, null);
        graphics.setTransform(place);
    }
}
