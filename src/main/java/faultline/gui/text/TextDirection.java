package faultline.gui.text;

import java.text.Bidi;

/** The direction of texts: all are read from left to right, as the languages of the window are. */
public final class TextDirection {

    private static final String LEFT_TO_RIGHT_MARK = "\u200e";

    private TextDirection() {}

    /**
     * Returns the text, after a left-to-right mark if it begins with a word of a script that is read from right to
     * left, such as the name of a file. Without the mark, its parts would be shown in the opposite order.
     */
    public static String leftToRight(String text) {
        return Bidi.requiresBidi(text.toCharArray(), 0, text.length())
                        && !new Bidi(text, Bidi.DIRECTION_DEFAULT_LEFT_TO_RIGHT).baseIsLeftToRight()
                ? LEFT_TO_RIGHT_MARK + text
                : text;
    }
}
