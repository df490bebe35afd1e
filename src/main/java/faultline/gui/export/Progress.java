package faultline.gui.export;

/** Told how far something slow is. */
interface Progress {

    /**
     * It is so far.
     *
     * @param share of the whole, from 0 to 1
     * @throws java.util.concurrent.CancellationException if it is to stop
     */
    void reached(double share);
}
