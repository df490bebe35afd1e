package faultline.gui.instrument;

import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.Surface;
import faultline.paint.surface.SvgSurface;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;

/**
 * All that a strip chart shows; the reference run is null for none. Immutable, so that it can be exported on any
 * thread.
 */
public record StripContent(
        SessionFrame frame,
        SignalGroup signal,
        TimeSpan span,
        ValueRange range,
        List<TimelineItem> items,
        ReferenceRun reference) {

    /** The size of exported pictures, pixels. */
    private static final int WIDTH = 900;

    private static final int HEIGHT = 420;

    public StripContent {
        items = List.copyOf(items);
    }

    /** Returns the values of the reference run, for a plot of the given width; empty if there is none. */
    Optional<StripData> referenceData(int pixels) {
        return Optional.ofNullable(reference).map(run -> StripData.of(run, span, pixels));
    }

    /** Returns the scale of a picture, pixels, with a legend above the plot or without. */
    StripScale scale(int width, int height, boolean legend) {
        return StripScale.of(this, legend, width, height);
    }

    /** Paints the chart. */
    void paint(Surface surface, Theme theme, StripScale scale) {
        new StripPainter(surface, theme, scale, this).paint();
    }

    /** Returns an image for a file; {@code scale} pixels of it are one pixel of the screen. */
    public BufferedImage toImage(Theme theme, int scale) {
        BufferedImage image = new BufferedImage(WIDTH * scale, HEIGHT * scale, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(theme.palette().canvas());
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        g.scale(scale, scale);
        paint(new GraphicsSurface(g), theme, scale(WIDTH, HEIGHT, true));
        g.dispose();
        return image;
    }

    /** Returns the text of an SVG file. */
    public String toSvg(Theme theme) {
        SvgSurface surface = new SvgSurface(WIDTH, HEIGHT, theme.palette().canvas());
        paint(surface, theme, scale(WIDTH, HEIGHT, true));
        return surface.toSvg();
    }

    /**
     * Returns the text of a table with one row for each recorded tick or interval in the shown times. The intervals are
     * those of the run, also beyond its end if the reference run is longer.
     */
    public String toCsv() {
        return StripTable.format(this);
    }
}
