package faultline.gui.instrument;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.record.EventRecorder;
import faultline.engine.record.RunEvent;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JTable;
import javax.swing.event.TableModelEvent;
import org.junit.jupiter.api.Test;

/** The rows of the event log while a run goes on, beside an earlier run too. */
class EventTableTest {

    /** So many events fill the log; with one more, so many of the oldest are forgotten. */
    private static final int FULL = 8192;
    private static final int CHUNK = 512;

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

    /** What the table is told, in the order of telling. */
    private List<String> told() {
        List<String> told = new ArrayList<>();
        edt(() -> events.addTableModelListener(event -> told.add(kind(event))));
        return told;
    }

    private static String kind(TableModelEvent event) {
        if (event.getLastRow() == Integer.MAX_VALUE) {
            return "all";
        }
        return (event.getType() == TableModelEvent.INSERT ? "+" : event.getType() == TableModelEvent.DELETE ? "-" : "=")
                + event.getFirstRow() + ".." + event.getLastRow();
    }

    private void fill(int events) {
        for (int i = 0; i < events; i++) {
            recorder.add(new RunEvent.Done(10L * i, i * 0.1, new Command.SwitchSensor("left", false)));
        }
        looked();
    }

    private long tickOfChosen() {
        return onEdt(() -> events.event(table.getSelectedRow()).tick());
    }

    @Test
    void onlyWhatIsNewIsTold() {
        List<String> told = told();
        happens(1);
        happens(5);
        looked();
        assertEquals(List.of("+0..0", "+1..1"), told);
    }

    @Test
    void anotherRunIsToldAsAWhole() {
        happens(1);
        List<String> told = told();
        EventRecorder other = new EventRecorder();
        other.add(new RunEvent.Done(1, 0.01, new Command.SwitchSensor("left", true)));
        assertTrue(onEdt(() -> events.show(other.view())));
        assertEquals(List.of("all"), told);
    }

    @Test
    void whatAFullLogForgetsIsTakenFromItsTopAndAChosenEventStaysChosen() {
        fill(FULL);
        choose(1000);
        long tick = tickOfChosen();
        List<String> told = told();
        assertTrue(happens(100_000));
        assertEquals(List.of("-0.." + (CHUNK - 1), "+" + (FULL - CHUNK) + ".." + (FULL - CHUNK)), told);
        assertEquals(1000 - CHUNK, chosen());
        assertEquals(tick, tickOfChosen());
        assertEquals(FULL - CHUNK + 1, events.getRowCount());
    }

    @Test
    void anEventThatIsForgottenIsChosenNoMore() {
        fill(FULL);
        choose(CHUNK - 1);
        happens(100_000);
        assertEquals(-1, chosen());
    }

    @Test
    void theDivergenceStaysAtTheTopWhereWhatCameBeforeItIsForgotten() {
        fill(FULL);
        diverge(50);
        choose(5);
        List<String> told = told();
        assertTrue(happens(100_000));
        assertEquals(List.of("-6.." + CHUNK, "-0..4", "+" + (FULL - CHUNK + 1) + ".." + (FULL - CHUNK + 1)), told);
        assertEquals(0, chosen());
        assertEquals(50, tickOfChosen());
        assertEquals(10 * CHUNK, events.event(1).tick());
    }

    @Test
    void aDivergenceThatComesOrGoesLeavesTheChosenEventChosen() {
        fill(10);
        choose(7);
        diverge(30);
        assertEquals(70, tickOfChosen());
        assertEquals(8, chosen());
        edt(() -> events.mark(Optional.empty()));
        assertEquals(70, tickOfChosen());
        assertEquals(7, chosen());
    }

    @Test
    void anEventBeforeTheDivergenceLeavesTheChosenEventChosen() {
        happens(1);
        diverge(7);
        choose(0);
        List<String> told = told();
        happens(5);
        assertEquals(List.of("-1..1", "+1..1", "+2..2"), told);
        assertEquals(0, chosen());
    }
}
