package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;

/**
 * How large texts are. Whole screens are enlarged by whole numbers only on some systems; this is for what lies between.
 */
public enum TextSize {
    /** As designed. */
    NORMAL(100),
    /** A quarter larger. */
    LARGE(125),
    /** Half as large again. */
    LARGEST(150);

    private static final String DEFAULTS_KEY = "faultline.textSize";
    private static final double FULL_PERCENT = 100;

    private final int percent;

    TextSize(int percent) {
        this.percent = percent;
    }

    /**
     * The size that is installed.
     *
     * @return normal where none is
     */
    public static TextSize current() {
        return UIManager.get(DEFAULTS_KEY) instanceof TextSize size ? size : NORMAL;
    }

    /**
     * A length that goes along with texts.
     *
     * @param pixels at the normal size
     * @return pixels at the installed size
     */
    public static int scaled(int pixels) {
        return (int) Math.round(pixels * current().percent / FULL_PERCENT);
    }

    /**
     * A font of pictures' texts that goes along with all others.
     *
     * @param style of {@link Font}
     * @param points at the normal size
     * @return the sans serif font at the installed size
     */
    public static Font scaledFont(int style, int points) {
        return new Font(Font.SANS_SERIF, style, scaled(points));
    }

    /**
     * How much a picture with texts in it is enlarged: like all texts, but never so much that it has less room than it
     * needs.
     *
     * @param width of the place for the picture, pixels
     * @param height of the place for the picture, pixels
     * @param least what the picture needs at the normal size
     * @return at least 1
     */
    public static double imageScale(int width, int height, Dimension least) {
        double room = Math.min((double) width / least.width, (double) height / least.height);
        return Math.max(1, Math.min(current().percent / FULL_PERCENT, room));
    }

    /** Makes this the size of all texts of windows made from now on, once a theme is installed after it. */
    public void install() {
        UIManager.put(DEFAULTS_KEY, this);
    }

    /**
     * The size.
     *
     * @return percent of the normal one
     */
    public int percent() {
        return percent;
    }
}
