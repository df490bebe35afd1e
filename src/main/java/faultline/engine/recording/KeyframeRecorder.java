package faultline.engine.recording;

import faultline.engine.Frame;
import faultline.engine.RobotPath;

/** Keeps frames at evenly spaced ticks; if there are too many, every second one is dropped. */
final class KeyframeRecorder {

    /** The maximum number of frames: about 3 MB in a simple room. */
    static final int MAX_FRAMES = 1024;

    private Frame[] frames = new Frame[MAX_FRAMES];
    private int size;
    private long stride = 1;

    /** Returns whether the frame of a tick would be kept. */
    boolean isDue(long tick) {
        return tick % stride == 0;
    }

    /** Keeps a frame whose tick is due. */
    void add(Frame frame) {
        if (size == MAX_FRAMES) {
            thin();
        }
        if (size > 0 && !frame.path().isContinuationOf(frames[size - 1].path())) {
            sharePath(frame.path());
        }
        if (isDue(frame.snapshot().tick())) {
            frames[size] = frame;
            size++;
        }
    }

    /**
     * Makes all frames share the points of a path that has been thinned; otherwise the frames would keep the points of
     * each earlier version. Replaces the array, because views refer to the old one.
     */
    private void sharePath(RobotPath path) {
        Frame[] shared = new Frame[MAX_FRAMES];
        for (int i = 0; i < size; i++) {
            shared[i] = frames[i].withPrefixOf(path);
        }
        frames = shared;
    }

    /** Replaces the array, because views refer to the old one. */
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
