package faultline.control;

/** Thrown if a run is longer than the record of the decisions that it repeats. The message is one sentence. */
public final class RecordEndedException extends IllegalStateException {

    private static final long serialVersionUID = 1L;

    /** The number of ticks that the record covers. */
    private final long ticks;

    /**
     * Creates an exception.
     *
     * @param ticks the number of ticks that the record covers
     */
    public RecordEndedException(long ticks) {
        super("the record of decisions ends after tick " + ticks);
        this.ticks = ticks;
    }

    /** {@return the number of ticks that the record covers} */
    public long ticks() {
        return ticks;
    }
}
