package faultline.engine;

/**
 * The robot's path so far, as a view of fixed length on a recording that goes on growing: taking one copies nothing, and any thread may read it.
 * Two views of one recording agree wherever both have points, so a painter may draw only what has been added.
 */
public final class Path {

    private final PathRecorder recorder;
    private final double[][] chunks;
    private final int size;

    Path(PathRecorder recorder, double[][] chunks, int size) {
        this.recorder = recorder;
        this.chunks = chunks;
        this.size = size;
    }

    /**
     * How many points there are.
     *
     * @return at least 1: the start
     */
    public int size() {
        return size;
    }

    /**
     * A point's x.
     *
     * @param index from 0, the start, to size - 1
     * @return metres
     */
    public double x(int index) {
        return chunks[index / PathRecorder.CHUNK][2 * (index % PathRecorder.CHUNK)];
    }

    /**
     * A point's y.
     *
     * @param index from 0, the start, to size - 1
     * @return metres
     */
    public double y(int index) {
        return chunks[index / PathRecorder.CHUNK][2 * (index % PathRecorder.CHUNK) + 1];
    }

    /**
     * Whether this view continues another: same run, at least as long.
     *
     * @param earlier another view
     * @return true where the first points of this are all of {@code earlier}'s
     */
    public boolean continues(Path earlier) {
        return recorder == earlier.recorder && size >= earlier.size;
    }
}
