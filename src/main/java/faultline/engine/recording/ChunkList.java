package faultline.engine.recording;

import java.util.ArrayList;
import java.util.List;

/**
 * The newest chunks of something that grows for ever. The list is exchanged whenever a chunk is added, never changed,
 * so that a view that holds the old one is good for ever.
 *
 * @param <C> a chunk, filled by its writer entry by entry
 */
final class ChunkList<C> {

    private final int capacity;
    private List<C> chunks = List.of();
    private long dropped;

    /** Keeps so many chunks. */
    ChunkList(int kept) {
        this.capacity = kept;
    }

    /** Adds a chunk, and forgets the oldest where there are too many. */
    void add(C chunk) {
        int surplus = Math.max(0, chunks.size() + 1 - capacity);
        List<C> changed = new ArrayList<>(chunks.subList(surplus, chunks.size()));
        changed.add(chunk);
        chunks = List.copyOf(changed);
        dropped += surplus;
    }

    C newest() {
        return chunks.get(chunks.size() - 1);
    }

    List<C> chunks() {
        return chunks;
    }

    /** How many chunks have been forgotten. */
    long dropped() {
        return dropped;
    }
}
