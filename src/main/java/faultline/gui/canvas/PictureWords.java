package faultline.gui.canvas;

import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import faultline.paint.Brush;
import faultline.paint.Words;
import java.awt.Font;

/** The words on the canvas, in the user's language. */
final class PictureWords {

    private PictureWords() {
    }

    /** As large as all other texts of the window. */
    static Font font() {
        return TextSize.font(Brush.FONT.getStyle(), Brush.FONT.getSize());
    }

    static Words spoken() {
        return new Words(Texts.text("picture.collision"), Texts.text("picture.faults"), Texts.text("picture.off"), Texts.text("reading.off"),
                kind -> Texts.text("picture.fault." + kind.fileName()), font());
    }
}
