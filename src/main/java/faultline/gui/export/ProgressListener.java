package faultline.gui.export;

/** Told how far something slow is. */
interface ProgressListener {

    /**
     * It is so far.
     *
     * @param share of the whole, from 0 to 1
     * @throws java.util.concurrent.CancellationException if it is to stop
     */
    void progressed(double share);
}
