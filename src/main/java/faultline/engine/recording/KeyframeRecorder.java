package faultline.engine.recording;

import faultline.engine.Frame;

/** Keeps frames at evenly spaced ticks; whenever there are too many, every second one goes. */
final class KeyframeRecorder {

    /** How many are kept at most: with a simple room, some 3 MB. */
    static final int MAX_FRAMES = 1024;

    private Frame[] frames = new Frame[MAX_FRAMES];
    private int size;
    private long stride = 1;

    /** Whether the frame of a tick would be kept. */
    boolean isDue(long tick) {
        return tick % stride == 0;
    }

    /** Keeps a frame whose tick is due. */
    void add(Frame frame) {
        if (size == MAX_FRAMES) {
            thin();
        }
        if (isDue(frame.snapshot().tick())) {
            frames[size] = frame;
            size++;
        }
    }

    /** Views hold the old array, so the thinned one is another. */
    private void thin() {
        Frame[] thinned = new Frame[MAX_FRAMES];
        for (int i = 0; i < MAX_FRAMES; i += 2) {
            thinned[i / 2] = frames[i];
        }
        frames = thinned;
        size = MAX_FRAMES / 2;
        stride *= 2;
    }

    Keyframes view() {
        return new Keyframes(frames, size, stride);
    }
}
