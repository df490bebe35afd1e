package faultline.engine.recording;

import faultline.engine.Frame;
import java.util.Optional;

/**
 * Frames at evenly spaced ticks from the start of a run on, as a view on a recording that goes on. They have no
 * recordings of their own.
 */
public final class Keyframes {

    /** Of a run that is not recorded. */
    public static final Keyframes EMPTY = new Keyframes(new Frame[0], 0, 1);

    private final Frame[] frames;
    private final int size;
    private final long stride;

    Keyframes(Frame[] frames, int size, long stride) {
        this.frames = frames;
        this.size = size;
        this.stride = stride;
    }

    /**
     * How many there are.
     *
     * @return from 0
     */
    public int size() {
        return size;
    }

    /**
     * How far they are apart.
     *
     * @return ticks
     */
    public long stride() {
        return stride;
    }

    /**
     * The newest frame that is not after a tick.
     *
     * @param tick not negative
     * @return empty where nothing is recorded
     */
    public Optional<Frame> frameAt(long tick) {
        return size == 0 ? Optional.empty() : Optional.of(frames[(int) Math.min(size - 1, tick / stride)]);
    }
}
