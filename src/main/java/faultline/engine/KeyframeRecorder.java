package faultline.engine;

/** Keeps frames at evenly spaced ticks; whenever there are too many, every second one goes. */
final class KeyframeRecorder {

    /** How many are kept at most: with a simple room, some 3 MB. */
    static final int MOST = 1024;

    private Frame[] frames = new Frame[MOST];
    private int size;
    private long stride = 1;

    /** Whether the frame of a tick would be kept. */
    boolean isDue(long tick) {
        return tick % stride == 0;
    }

    /** Keeps a frame whose tick is due. */
    void add(Frame frame) {
        if (size == MOST) {
            thin();
        }
        if (isDue(frame.world().tick())) {
            frames[size] = frame;
            size++;
        }
    }

    /** Views hold the old array, so the thinned one is another. */
    private void thin() {
        Frame[] thinned = new Frame[MOST];
        for (int i = 0; i < MOST; i += 2) {
            thinned[i / 2] = frames[i];
        }
        frames = thinned;
        size = MOST / 2;
        stride *= 2;
    }

    Keyframes view() {
        return new Keyframes(frames, size, stride);
    }
}
