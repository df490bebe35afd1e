package faultline.gui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class EndNotifierTest {

    @Test
    void aRunThatPassesItsEndIsReportedOnce() {
        List<String> notes = new ArrayList<>();
        EndNotifier notifier = new EndNotifier(notes::add);
        for (long tick : new long[] {999, 1000, 1001, 5000, 1000}) {
            notifier.update(tick, 1000, 10);
        }
        String note = "The scenario ended at 10.00 s. The run continues until it is paused or restarted";
        assertEquals(List.of(note), notes);
        notifier.update(1001, 1000, 10);
        assertEquals(List.of(note, note), notes);
    }
}
