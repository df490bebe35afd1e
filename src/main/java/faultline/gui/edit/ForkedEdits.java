package faultline.gui.edit;

/**
 * What is no longer repeated automatically because a run that was moved back has been edited there.
 *
 * @param edits the number of later edits, which remain under Redo
 * @param undos the number of edits that were undone later and are done now
 */
public record ForkedEdits(int edits, int undos) {

    boolean isEmpty() {
        return edits == 0 && undos == 0;
    }
}
