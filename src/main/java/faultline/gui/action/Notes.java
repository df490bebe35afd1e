package faultline.gui.action;

import java.util.function.Consumer;

/**
 * Where the window shows notes to the user, one at a time. Used on the event dispatch thread.
 *
 * @param shower shows a sentence for as long as it takes to read
 * @param keeper shows a sentence until it is removed
 * @param lineShower shows a line that a program has printed, after all sentences
 * @param remover removes a sentence or a line if it is still there
 */
public record Notes(
        Consumer<String> shower, Consumer<String> keeper, Consumer<String> lineShower, Consumer<String> remover) {

    /**
     * Shows a sentence in place of the last one, for as long as it takes to read.
     *
     * @param sentence the sentence
     */
    public void show(String sentence) {
        shower.accept(sentence);
    }

    /**
     * Shows a sentence until it is removed; others that are shown meanwhile hide it for as long as it takes to read
     * them.
     *
     * @param sentence the sentence
     */
    public void keep(String sentence) {
        keeper.accept(sentence);
    }

    /**
     * Shows a line that a program has printed, for as long as it takes to read, while there is no sentence to show.
     *
     * @param line the line
     */
    public void showLine(String line) {
        lineShower.accept(line);
    }

    /**
     * Removes a sentence or a line if it is still there.
     *
     * @param sentence the sentence, as it was shown
     */
    public void remove(String sentence) {
        remover.accept(sentence);
    }
}
