package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertIterableEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.recording.EventRecorder;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.world.Collision;
import faultline.world.Command;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.swing.JTable;
import javax.swing.RowFilter;
import javax.swing.event.TableModelEvent;
import javax.swing.table.TableRowSorter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rows of the event log during a run, with and without a reference run. */
class EventTableModelTest {

    /** The number of events that fill the log; with one more, a chunk of the oldest is dropped. */
    private static final int LOG_CAPACITY = 8192;

    private static final int CHUNK = 512;

    private final EventRecorder recorder = new EventRecorder();
    private final EventTableModel events = new EventTableModel();
    private long shownTick;
    private final JTable table = callOnEdt(() -> new JTable(events));

    private boolean recordEvent(long tick) {
        recorder.add(new RunEvent.CommandExecuted(tick, tick * 0.01, new Command.SwitchSensor("left", false)));
        return updateTo(tick);
    }

    private boolean update() {
        return updateTo(shownTick);
    }

    private boolean updateTo(long tick) {
        shownTick = tick;
        return callOnEdt(() -> events.update(recorder.view(), tick));
    }

    private void choose(int row) {
        runOnEdt(() -> table.setRowSelectionInterval(row, row));
    }

    private int chosen() {
        return callOnEdt(table::getSelectedRow);
    }

    private void diverge(long tick) {
        runOnEdt(() -> events.setDivergence(new RunEvent.Diverged(tick, tick * 0.01)));
    }

    @Test
    void aChosenEventStaysChosenWhileTheRunGoesOn() {
        recordEvent(1);
        choose(0);
        assertTrue(recordEvent(5));
        assertFalse(update());
        assertEquals(0, chosen());
    }

    @Test
    void aChosenEventStaysChosenInARunThatHasLeftAnEarlierOne() {
        recordEvent(1);
        recordEvent(5);
        diverge(7);
        choose(1);
        assertFalse(update(), "nothing is new");
        assertTrue(recordEvent(9));
        assertEquals(1, chosen());
        assertEquals(7, events.eventAt(2).tick());
        assertEquals(9, events.eventAt(3).tick());
    }

    @Test
    void anEventBeforeTheDivergenceMovesItsRow() {
        recordEvent(1);
        diverge(7);
        assertTrue(recordEvent(5));
        assertEquals(5, events.eventAt(1).tick());
        assertEquals(7, events.eventAt(2).tick());
    }

    /** Returns the notifications of the table in order. */
    private List<String> notifications() {
        List<String> kinds = new ArrayList<>();
        runOnEdt(() -> events.addTableModelListener(event -> kinds.add(kind(event))));
        return kinds;
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
            recorder.add(new RunEvent.CommandExecuted(10L * i, i * 0.1, new Command.SwitchSensor("left", false)));
        }
        updateTo(10L * (events - 1));
    }

    private long tickOfChosen() {
        return callOnEdt(() -> events.eventAt(table.getSelectedRow()).tick());
    }

    @Test
    void onlyNewRowsAreReported() {
        List<String> notifications = notifications();
        recordEvent(1);
        recordEvent(5);
        update();
        assertEquals(List.of("+0..0", "+1..1"), notifications);
    }

    @Test
    void anotherRunIsReportedAsAWhole() {
        recordEvent(1);
        List<String> notifications = notifications();
        EventRecorder other = new EventRecorder();
        other.add(new RunEvent.CommandExecuted(1, 0.01, new Command.SwitchSensor("left", true)));
        assertTrue(callOnEdt(() -> events.update(other.view(), 1)));
        assertEquals(List.of("all"), notifications);
    }

    @Test
    void whatAFullLogForgetsIsTakenFromItsTopAndAChosenEventStaysChosen() {
        fill(LOG_CAPACITY);
        choose(1000);
        long tick = tickOfChosen();
        List<String> notifications = notifications();
        assertTrue(recordEvent(100_000));
        assertEquals(
                List.of("-0.." + (CHUNK - 1), "+" + (LOG_CAPACITY - CHUNK) + ".." + (LOG_CAPACITY - CHUNK)),
                notifications);
        assertEquals(1000 - CHUNK, chosen());
        assertEquals(tick, tickOfChosen());
        assertEquals(LOG_CAPACITY - CHUNK + 1, events.getRowCount());
    }

    @Test
    void anEventThatIsForgottenIsChosenNoMore() {
        fill(LOG_CAPACITY);
        choose(CHUNK - 1);
        recordEvent(100_000);
        assertEquals(-1, chosen());
    }

    @Test
    void theDivergenceStaysAtTheTopWhereWhatCameBeforeItIsForgotten() {
        fill(LOG_CAPACITY);
        diverge(50);
        choose(5);
        List<String> notifications = notifications();
        assertTrue(recordEvent(100_000));
        assertEquals(
                List.of(
                        "-0..4",
                        "-1.." + (CHUNK - 5),
                        "+" + (LOG_CAPACITY - CHUNK + 1) + ".." + (LOG_CAPACITY - CHUNK + 1)),
                notifications);
        assertEquals(0, chosen());
        assertEquals(50, tickOfChosen());
        assertEquals(10 * CHUNK, events.eventAt(1).tick());
    }

    /** As in the log, where the boxes of the kinds hide rows. */
    @ParameterizedTest
    @ValueSource(ints = {10, 300, 1000, 5000})
    void aFilteredTableKeepsItsRowsWhileTheLogForgets(int diverged) {
        TableRowSorter<EventTableModel> rows = new TableRowSorter<>(events);
        runOnEdt(() -> table.setRowSorter(rows));
        fill(diverged);
        printLines(100);
        for (int i = diverged; i < LOG_CAPACITY - 1; i++) {
            recordEvent(10L * i);
        }
        diverge(10L * diverged);
        runOnEdt(() -> rows.setRowFilter(new OddRows()));
        for (int i = 0; i < 2 * CHUNK; i++) {
            recordEvent(100_000 + i);
            if (i % 100 == 0) {
                printLines(30);
            }
            // The log forgets a chunk at the second event of each.
            if (i % CHUNK < 4 || i % 50 == 0) {
                assertTheTableShowsTheOddRows();
            }
        }
        assertTheTableShowsTheOddRows();
    }

    private void assertTheTableShowsTheOddRows() {
        assertIterableEquals(
                callOnEdt(() -> IntStream.range(0, events.getRowCount())
                        .mapToObj(events::eventAt)
                        .filter(OddRows::isShown)
                        .toList()),
                callOnEdt(() -> IntStream.range(0, table.getRowCount())
                        .mapToObj(row -> events.eventAt(table.convertRowIndexToModel(row)))
                        .toList()));
    }

    /** Hides the events at even tenths of a tick, and the divergence. */
    private static final class OddRows extends RowFilter<EventTableModel, Integer> {
        @Override
        public boolean include(Entry<? extends EventTableModel, ? extends Integer> row) {
            return isShown(row.getModel().eventAt(row.getIdentifier()));
        }

        private static boolean isShown(RunEvent event) {
            return event instanceof RunEvent.CommandExecuted && event.tick() / 10 % 2 == 1;
        }
    }

    private void printLines(int count) {
        List<String> lines =
                IntStream.range(0, count).mapToObj(i -> "line " + i).toList();
        runOnEdt(() -> events.addLines(lines, shownTick * 0.01));
    }

    private List<String> sentences() {
        return callOnEdt(() -> IntStream.range(0, events.getRowCount())
                .mapToObj(row -> events.eventAt(row).tick() + " "
                        + (events.eventAt(row) instanceof RunEvent.Printed printed
                                ? printed.line()
                                : events.getValueAt(row, EventTableModel.KIND_COLUMN)))
                .toList());
    }

    @Test
    void printedLinesAreListedWhenTheyArrive() {
        recordEvent(1);
        diverge(9);
        printLines(2);
        recordEvent(1);
        updateTo(5);
        printLines(1);
        recordEvent(10);
        assertEquals(
                List.of("1 Command", "1 line 0", "1 line 1", "1 Command", "5 line 0", "9 Ghost", "10 Command"),
                sentences());
    }

    @Test
    void aRunThatIsMovedBackLosesTheLinesOfLaterTicks() {
        recordEvent(1);
        printLines(1);
        updateTo(7);
        printLines(2);
        updateTo(4);
        assertEquals(List.of("1 Command", "1 line 0"), sentences());
        runOnEdt(events::clear);
        assertEquals(List.of(), sentences());
    }

    @Test
    void theContactOfTheGhostIsListedWhenTheRunHasReachedItsTick() {
        Collision collision = new Collision(new Vector2(1, 2), 0.05, 5, "desk", Map.of(), List.of(), MotorFaults.NONE);
        recordEvent(1);
        runOnEdt(() -> events.setGhostContact(new RunEvent.GhostCollided(5, collision)));
        assertEquals(List.of("1 Command"), sentences());
        recordEvent(7);
        assertEquals(List.of("1 Command", "5 Ghost", "7 Command"), sentences());
        updateTo(4);
        assertEquals(List.of("1 Command", "7 Command"), sentences(), "a run that was moved back has another log");
        updateTo(6);
        assertEquals(List.of("1 Command", "5 Ghost", "7 Command"), sentences());
        runOnEdt(() -> events.setGhostContact(null));
        assertEquals(List.of("1 Command", "7 Command"), sentences());
    }

    @Test
    void aFloodOfLinesHidesNoEvent() {
        choose(fillAndReturnLast());
        printLines(2 * EventTableModel.MAX_LINES);
        recordEvent(1000);
        List<String> notifications = notifications();
        printLines(10);
        assertEquals(List.of("+311..320", "-10..19"), notifications);
        assertEquals(11 + EventTableModel.MAX_LINES, events.getRowCount());
        assertEquals("line 310", ((RunEvent.Printed) events.eventAt(10)).line());
        assertEquals(1000, events.eventAt(10 + EventTableModel.MAX_LINES - 10).tick());
        assertEquals(90, tickOfChosen());
    }

    private int fillAndReturnLast() {
        fill(10);
        return 9;
    }

    @Test
    void aDivergenceThatComesOrGoesLeavesTheChosenEventChosen() {
        fill(10);
        choose(7);
        diverge(30);
        assertEquals(70, tickOfChosen());
        assertEquals(8, chosen());
        runOnEdt(() -> events.setDivergence(null));
        assertEquals(70, tickOfChosen());
        assertEquals(7, chosen());
    }

    @Test
    void anEventBeforeTheDivergenceLeavesTheChosenEventChosen() {
        recordEvent(1);
        diverge(7);
        choose(0);
        List<String> notifications = notifications();
        recordEvent(5);
        assertEquals(List.of("-1..1", "+1..1", "+2..2"), notifications);
        assertEquals(0, chosen());
    }
}
