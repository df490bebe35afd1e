package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;

/** The text sizes. Some systems scale the screen by whole numbers only; this allows sizes in between. */
public enum TextSize {
    /** The designed size. */
    NORMAL(100),
    /** 125 %. */
    LARGE(125),
    /** 150 %. */
    LARGEST(150);

    private static final String DEFAULTS_KEY = "faultline.textSize";
    private static final double FULL_PERCENT = 100;

    private final int percent;

    TextSize(int percent) {
        this.percent = percent;
    }

    /** Returns the installed size, normal if none is. */
    public static TextSize current() {
        return UIManager.get(DEFAULTS_KEY) instanceof TextSize size ? size : NORMAL;
    }

    /** Scales a length in pixels with the text. */
    public static int scaled(int pixels) {
        return (int) Math.round(pixels * current().percent / FULL_PERCENT);
    }

    /** Returns the length at the normal text size of a length in pixels at the installed one. */
    public static int unscaled(int pixels) {
        return (int) Math.round(pixels * FULL_PERCENT / current().percent);
    }

    /** Returns the sans serif font for texts in images, scaled with all other texts. */
    public static Font scaledFont(int style, int points) {
        return new Font(Font.SANS_SERIF, style, scaled(points));
    }

    /**
     * Returns the scale, at least 1, of an image with text in an area, pixels: that of the text, but limited so that
     * the image fits, given its size at the normal text size.
     */
    public static double imageScale(int width, int height, Dimension minSize) {
        double room = Math.min((double) width / minSize.width, (double) height / minSize.height);
        return Math.max(1, Math.min(current().percent / FULL_PERCENT, room));
    }

    /** Installs this size for components created or refreshed afterwards, once a theme is installed. */
    public void install() {
        UIManager.put(DEFAULTS_KEY, this);
    }

    /** Returns the size in percent of the normal one. */
    public int percent() {
        return percent;
    }
}
