package faultline.gui.canvas;

import faultline.gui.text.Texts;
import faultline.paint.Words;

/** The words on the canvas, in the user's language. */
final class PictureWords {

    private PictureWords() {
    }

    static Words spoken() {
        return new Words(Texts.text("picture.collision"), Texts.text("picture.faults"), Texts.text("picture.off"), Texts.text("reading.off"),
                kind -> Texts.text("picture.fault." + kind.fileName()));
    }
}
