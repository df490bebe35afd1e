package faultline.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * An append-only log whose entries are stored in chunks of equal size, usually arrays. One thread writes it. Any thread
 * may read its views, because an entry never changes after it was written and the list of chunks is replaced, not
 * changed, when a chunk is added. If there is a limit, the oldest chunks are dropped.
 *
 * @param <C> the type of a chunk
 */
public final class ChunkLog<C> {

    private final int chunkSize;
    private final int maxChunks;
    private final Supplier<C> chunkFactory;
    private List<C> chunks = List.of();
    private long first;
    private long end;

    /**
     * Creates an empty log.
     *
     * @param chunkSize the number of entries in a chunk
     * @param maxChunks the largest number of chunks that are kept
     * @param chunkFactory the function that makes an empty chunk
     */
    public ChunkLog(int chunkSize, int maxChunks, Supplier<C> chunkFactory) {
        this.chunkSize = chunkSize;
        this.maxChunks = maxChunks;
        this.chunkFactory = chunkFactory;
    }

    /**
     * Adds an entry, which the caller then writes to {@link #newest}.
     *
     * @return the index of the entry in its chunk
     */
    public int append() {
        int offset = (int) (end % chunkSize);
        if (offset == 0) {
            int surplus = Math.max(0, chunks.size() + 1 - maxChunks);
            List<C> changed = new ArrayList<>(chunks.subList(surplus, chunks.size()));
            changed.add(chunkFactory.get());
            chunks = List.copyOf(changed);
            first += (long) surplus * chunkSize;
        }
        end++;
        return offset;
    }

    /** {@return the chunk of the newest entry} */
    public C newest() {
        return chunks.get(chunks.size() - 1);
    }

    /** {@return a view of the current entries} Later entries do not appear in it. */
    public View<C> view() {
        return new View<>(chunks, chunkSize, first, end);
    }

    /**
     * The entries of a log at one moment.
     *
     * @param chunks the chunks, oldest first
     * @param chunkSize the number of entries in a chunk
     * @param first the index of the oldest entry that is kept, which is also the number of dropped entries
     * @param end the index after the newest entry
     * @param <C> the type of a chunk
     */
    public record View<C>(List<C> chunks, int chunkSize, long first, long end) {

        /**
         * {@return the chunk of an entry}
         *
         * @param index the index of the entry in the log
         * @throws IndexOutOfBoundsException if the entry was dropped or is not yet written
         */
        public C chunk(long index) {
            if (index < first || index >= end) {
                throw new IndexOutOfBoundsException("entry " + index + " is not in [" + first + ", " + end + ")");
            }
            return chunks.get((int) ((index - first) / chunkSize));
        }

        /**
         * {@return the index of an entry in its chunk}
         *
         * @param index the index of the entry in the log
         */
        public int offset(long index) {
            return (int) (index % chunkSize);
        }

        /**
         * {@return whether this view begins with all entries of an earlier, non-empty view of the same log}
         *
         * @param earlier the earlier view
         */
        public boolean isContinuationOf(View<C> earlier) {
            return earlier.end > 0 && end >= earlier.end && chunks.get(0) == earlier.chunks.get(0);
        }
    }
}
