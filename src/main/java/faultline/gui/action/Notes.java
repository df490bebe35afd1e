package faultline.gui.action;

import java.util.function.Consumer;

/**
 * Where the window shows notes to the user, one at a time. Used on the event dispatch thread.
 *
 * @param shower shows a sentence
 * @param remover removes a sentence if it is still shown
 */
public record Notes(Consumer<String> shower, Consumer<String> remover) {

    /**
     * Shows a sentence in place of the last one.
     *
     * @param sentence the sentence
     */
    public void show(String sentence) {
        shower.accept(sentence);
    }

    /**
     * Removes a sentence if it is still shown.
     *
     * @param sentence the sentence, as it was shown
     */
    public void remove(String sentence) {
        remover.accept(sentence);
    }
}
