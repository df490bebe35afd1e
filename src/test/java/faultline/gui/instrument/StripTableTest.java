package faultline.gui.instrument;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.TraceChannels;
import faultline.engine.recording.TraceLevel;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** Tables of a run and a reference run whose values are recorded at other times. */
class StripTableTest {

    private static final String HEADER =
            "t (s),\"target (m)\",\"distance used (m)\",\"ghost, target (m)\",\"ghost, distance used (m)\"";

    private static final String GHOST_RANGES = "\"ghost, distance used min (m)\",\"ghost, distance used max (m)\"";

    private static List<String> table(SessionFrame frame, ReferenceRun ghost, double length) {
        SignalGroup distance =
                SignalGroup.allOf(frame.snapshot().robot().sensorIds()).get(0);
        return new StripContent(frame, distance, new TimeSpan(0, length), ValueRange.FROM_ZERO, List.of(), ghost)
                .toCsv()
                .lines()
                .toList();
    }

    private static ReferenceRun ghost(SimulationSetup setup, long ticks) {
        return ReferenceRun.replay(new Journal(setup, List.of(), ticks), tick -> true);
    }

    /** Checks that the last two cells of a row are the least and the greatest distance in some ticks of a ghost. */
    private static void assertRange(ReferenceRun ghost, long from, long to, String row) {
        TraceLevel level = ghost.recording().trace().finestLevel();
        double[] values = LongStream.range(from, to)
                .mapToDouble(tick -> level.min(TraceChannels.MEASURED_DISTANCE, tick))
                .filter(Double::isFinite)
                .sorted()
                .toArray();
        String range = values.length == 0
                ? ","
                : Float.toString((float) values[0]) + "," + Float.toString((float) values[values.length - 1]);
        List<String> cells = List.of(row.split(",", -1));
        assertEquals(range, String.join(",", cells.subList(cells.size() - 2, cells.size())), row);
    }

    /** Of a run of more than 300 s, not every tick is kept from the start. */
    @Test
    void aRowOfFourTicksHasTheLeastAndTheGreatestValueOfAShortReferenceRun() {
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withDuration(2000);
        ReferenceRun ghost = ghost(setup, 1500);
        List<String> rows = table(SampleRuns.frame(setup, 34_000), ghost, 600);
        assertEquals(GHOST_RANGES, rows.get(0).substring(rows.get(0).length() - GHOST_RANGES.length()));
        assertEquals("0.015", rows.get(1).substring(0, 5));
        assertEquals("0.055", rows.get(2).substring(0, 5));
        for (int row = 0; row < 375; row++) {
            assertRange(ghost, 4L * row, 4L * row + 4, rows.get(1 + row));
        }
        assertRange(ghost, 1500, 1501, rows.get(1 + 375));
        assertEquals(",,,,", rows.get(1 + 376).substring(rows.get(1 + 376).length() - 4), "after its end");
    }

    @Test
    void aRowOfOneTickHasTheValuesOfTwoTicksOfHalfItsLength() {
        ReferenceRun ghost = ghost(SampleRuns.ROOM_SETUP.withTick(0.005), 400);
        List<String> rows = table(SampleRuns.frame(200), ghost, 2);
        assertEquals(1 + 201, rows.size());
        assertRange(ghost, 0, 1, rows.get(1));
        for (int tick = 1; tick <= 200; tick++) {
            assertRange(ghost, 2L * tick - 1, 2L * tick + 1, rows.get(1 + tick));
        }
    }

    @Test
    void severalRowsHaveTheValueOfALongerTick() {
        ReferenceRun ghost = ghost(SampleRuns.ROOM_SETUP, 100);
        List<String> rows = table(SampleRuns.frame(SampleRuns.ROOM_SETUP.withTick(0.005), 200), ghost, 1);
        assertEquals(HEADER, rows.get(0));
        TraceLevel level = ghost.recording().trace().finestLevel();
        for (int tick = 0; tick <= 200; tick++) {
            float value = level.min(TraceChannels.MEASURED_DISTANCE, (tick + 1) / 2);
            String cell = Float.isFinite(value) ? Float.toString(value) : "";
            assertEquals(cell, rows.get(1 + tick).split(",", -1)[4], "tick " + tick);
        }
    }
}
