package faultline.gui.instrument;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.record.EventRecorder;
import faultline.engine.record.RunEvent;
import faultline.world.Command;
import java.util.Optional;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;

/** The rows of the event log while a run goes on, beside an earlier run too. */
class EventTableTest {

    private final EventRecorder recorder = new EventRecorder();
    private final EventTable events = new EventTable();
    private final JTable table = onEdt(() -> new JTable(events));

    private boolean happens(long tick) {
        recorder.add(new RunEvent.Done(tick, tick * 0.01, new Command.SwitchSensor("left", false)));
        return looked();
    }

    private boolean looked() {
        return onEdt(() -> events.show(recorder.view()));
    }

    private void choose(int row) {
        edt(() -> table.setRowSelectionInterval(row, row));
    }

    private int chosen() {
        return onEdt(table::getSelectedRow);
    }

    private void diverge(long tick) {
        edt(() -> events.mark(Optional.of(new RunEvent.Diverged(tick, tick * 0.01))));
    }

    @Test
    void aChosenEventStaysChosenWhileTheRunGoesOn() {
        happens(1);
        choose(0);
        assertTrue(happens(5));
        assertFalse(looked());
        assertEquals(0, chosen());
    }

    @Test
    void aChosenEventStaysChosenInARunThatHasLeftAnEarlierOne() {
        happens(1);
        happens(5);
        diverge(7);
        choose(1);
        assertFalse(looked(), "nothing is new");
        assertTrue(happens(9));
        assertEquals(1, chosen());
        assertEquals(7, events.event(2).tick());
        assertEquals(9, events.event(3).tick());
    }

    @Test
    void anEventBeforeTheDivergenceMovesItsRow() {
        happens(1);
        diverge(7);
        assertTrue(happens(5));
        assertEquals(5, events.event(1).tick());
        assertEquals(7, events.event(2).tick());
    }
}
