package faultline.gui.text;

import java.awt.FontMetrics;
import java.awt.Rectangle;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;

/** Shortens texts that are too wide, as the labels of Swing do. */
public final class ShortenedText {

    private ShortenedText() {}

    /** Returns a text, with dots in place of its end if it is wider than a width, pixels. */
    public static String of(String text, FontMetrics metrics, double width) {
        return SwingUtilities.layoutCompoundLabel(
                metrics,
                text,
                null,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                SwingConstants.CENTER,
                new Rectangle(0, 0, (int) width, metrics.getHeight()),
                new Rectangle(),
                new Rectangle(),
                0);
    }
}
