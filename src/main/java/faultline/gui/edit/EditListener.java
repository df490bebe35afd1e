package faultline.gui.edit;

/** What becomes of edits beyond their being done. */
public interface EditListener {

    /**
     * Something was done at an earlier moment of the run, so that later edits will not happen by themselves any more.
     *
     * @param later how many edits can be redone in their place
     */
    void timelineForked(int later);

    /**
     * An edit was taken back.
     *
     * @param since the tick in which it was first done; 0 where it has been part of the run from its beginning
     */
    void editUndone(long since);
}
