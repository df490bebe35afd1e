package faultline.gui.canvas;

import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import faultline.paint.Brush;
import faultline.paint.Words;
import java.awt.Font;

/** The words in pictures of the world, in the user's language. */
public final class PictureWords {

    private PictureWords() {
    }

    /** As large as all other texts of the window. */
    static Font font() {
        return TextSize.font(Brush.FONT.getStyle(), Brush.FONT.getSize());
    }

    static Words spoken() {
        return spoken(font());
    }

    /**
     * What is written in pictures.
     *
     * @param font how
     * @return in today's language
     */
    public static Words spoken(Font font) {
        return new Words(Texts.text("picture.collision"), Texts.text("picture.faults"), Texts.text("picture.off"), Texts.text("reading.off"),
                kind -> Texts.text("picture.fault." + kind.fileName()), font);
    }
}
