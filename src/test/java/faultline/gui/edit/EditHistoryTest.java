package faultline.gui.edit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EditHistoryTest {

    private final EditHistory history = new EditHistory();
    private final List<Integer> applied = new ArrayList<>();

    private SetupEdit edit(int gesture) {
        return new SetupEdit(() -> "edit " + gesture, gesture, () -> applied.add(-gesture), () -> applied.add(gesture));
    }

    private int countUndoable() {
        int count = 0;
        while (history.nextUndo().isPresent()) {
            history.mark(history.nextUndo().get(), false);
            count++;
        }
        return count;
    }

    @Test
    void theLastThousandEditsAreKept() {
        for (int gesture = 0; gesture < 1001; gesture++) {
            history.add(edit(gesture));
        }
        assertEquals("edit 1000", history.nextUndo().orElseThrow().name());
        assertEquals(1000, countUndoable());
        assertEquals("edit 1", history.nextRedo().orElseThrow().name());
    }

    @Test
    void editsOfOneGestureAreOne() {
        assertTrue(history.add(edit(1)));
        assertFalse(history.add(edit(1)));
        assertTrue(history.add(edit(2)));
        assertEquals(2, countUndoable());
    }

    @Test
    void aNewEditDropsThoseThatAreUndone() {
        history.add(edit(1));
        history.add(edit(2));
        history.mark(history.nextUndo().orElseThrow(), false);
        history.add(edit(3));
        assertTrue(history.nextRedo().isEmpty());
        assertEquals(2, countUndoable());
    }
}
