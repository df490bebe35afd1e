package faultline.engine.recording;

import faultline.engine.Frame;
import java.util.Optional;

/** Frames at evenly spaced ticks from the start of a run, as a view on a recording that continues. */
public final class Keyframes {

    /** The keyframes of a run that is not recorded. */
    public static final Keyframes EMPTY = new Keyframes(new Frame[0], 0, 1);

    private final Frame[] frames;
    private final int size;
    /** The number of ticks between two frames. */
    private final long stride;

    Keyframes(Frame[] frames, int size, long stride) {
        this.frames = frames;
        this.size = size;
        this.stride = stride;
    }

    /** {@return the number of frames} */
    public int size() {
        return size;
    }

    /**
     * {@return the newest frame that is not after a tick; empty if nothing is recorded}
     *
     * @param tick the tick, not negative
     */
    public Optional<Frame> frameAt(long tick) {
        return size == 0 ? Optional.empty() : Optional.of(frames[(int) Math.min(size - 1, tick / stride)]);
    }
}
