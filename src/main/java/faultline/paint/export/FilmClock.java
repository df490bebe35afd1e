package faultline.paint.export;

import faultline.geometry.Vector2;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.Palette;
import faultline.paint.surface.TextStyle;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Locale;

/** Shows the time of the run in the images of a film, at the middle of the lower edge, where no legend is. */
final class FilmClock {

    /** The size of the text, its distance from the edge of the image and the room around it, pixels. */
    private static final int TEXT_SIZE = 14;

    private static final int MARGIN = 6;
    private static final int PADDING = 4;
    /** The height of the baseline as a share of the size of the text, from above. */
    private static final double BASELINE = 0.85;

    private FilmClock() {}

    /** Paints a time, seconds, into an image in the colours of a palette. */
    static void paint(BufferedImage image, double time, Palette palette) {
        TextStyle style = TextStyle.plain(TEXT_SIZE, palette.text());
        String text = String.format(Locale.ROOT, "%.1f s", time);
        double width = style.estimateWidth(text) + 2 * PADDING;
        double height = TEXT_SIZE + 2 * PADDING;
        double left = (image.getWidth() - width) / 2;
        double top = image.getHeight() - MARGIN - height;
        Graphics2D graphics = image.createGraphics();
        GraphicsSurface surface = new GraphicsSurface(graphics);
        surface.fill(new Rectangle2D.Double(left, top, width, height), palette.canvas());
        surface.drawText(text, new Vector2(left + PADDING, top + PADDING + TEXT_SIZE * BASELINE), style);
        graphics.dispose();
    }
}
