package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.engine.SimulationSetup;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.swing.JTable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A reader with eq. (4), t_p = (F4 - F3) / 2, computes the t_p that the window shows from the F3 and F4 that it shows,
 * in the turn timing and in the event log. Only shown texts are read.
 */
class TurnTimingTextTest {

    /** Less than the last digit that is shown, seconds: what the reader computes has the same digits. */
    private static final double EXACT = 1e-9;

    private static final Pattern NUMBER = Pattern.compile("\\d+\\.\\d{3,4}(?= s)");

    /** Meets a wall that stands alone at an angle. */
    private static SessionFrame run(TimingRule rule, WallSide side, double headingDegrees) {
        Obstacle wall = new Obstacle(
                "wall",
                new ObstacleShape.WallShape(List.of(new Vector2(-4, 0), new Vector2(4, 0))),
                new Pose(4.3, 2.7, 0));
        SimulationSetup setup = SimulationSetup.of(
                        new WorldSpec(8.6, 3.4, false, 5, List.of(wall)),
                        new Pose(4.1, 1.3, Math.toRadians(headingDegrees)))
                .withController(
                        ControllerSpec.WallFollowing.DEFAULT.withSide(side).withTimingRule(rule))
                .withDuration(20);
        return SampleRuns.frame(setup, 1100);
    }

    @ParameterizedTest
    @CsvSource({
        "EQUAL_READINGS, LEFT, 97",
        "EQUAL_READINGS, RIGHT, 81",
        "RANGE, LEFT, 93",
        "RANGE, RIGHT, 88",
    })
    void theShownTpIsHalfTheDifferenceOfTheShownF3AndF4(TimingRule rule, WallSide side, double heading) {
        SessionFrame frame = run(rule, side, heading);
        AlignmentView timing = callOnEdt(AlignmentView::new);
        runOnEdt(() -> timing.setFrame(frame));
        Map<String, String> shown = callOnEdt(() -> timing.rows().stream()
                .collect(Collectors.toMap(AlignmentText.NamedValue::name, AlignmentText.NamedValue::value)));
        assertTrue(shown.containsKey("t_p"), "the robot has turned: " + shown);
        double f3 = seconds(shown.get("F3"));
        double f4 = seconds(shown.get("F4"));
        assertTrue(f3 < f4, shown.toString());
        assertEquals((f4 - f3) / 2, seconds(shown.get("t_p")), EXACT, shown.toString());
        assertEquals(f4 - f3, seconds(shown.get("t_D")), EXACT, shown.toString());

        String event = lastTimingEvent(frame);
        assertEquals(
                List.of(f3, f4, seconds(shown.get("t_D")), seconds(shown.get("t_p"))),
                NUMBER.matcher(event)
                        .results()
                        .map(MatchResult::group)
                        .map(Double::valueOf)
                        .toList(),
                event);
    }

    private static double seconds(String text) {
        return Double.parseDouble(text.replace(" s", ""));
    }

    /** Returns the text of the last timing in the event log, after checking that no other event names F3 or F4. */
    private static String lastTimingEvent(SessionFrame frame) {
        EventLogView log = callOnEdt(() -> new EventLogView(tick -> {}));
        runOnEdt(() -> log.setFrame(frame));
        JTable table = log.table();
        Map<Boolean, List<String>> texts = callOnEdt(() -> IntStream.range(0, table.getRowCount())
                .boxed()
                .collect(Collectors.partitioningBy(
                        row -> "Timing".equals(table.getValueAt(row, EventTableModel.KIND_COLUMN)),
                        Collectors.mapping(
                                row -> String.valueOf(table.getValueAt(row, table.getColumnCount() - 1)),
                                Collectors.toList()))));
        assertFalse(texts.get(true).isEmpty(), "a turn is timed");
        assertEquals(
                List.of(),
                texts.get(false).stream()
                        .filter(text -> text.matches(".*F[34].*"))
                        .toList());
        StateDiagramView diagram = callOnEdt(StateDiagramView::new);
        runOnEdt(() -> diagram.setFrame(frame));
        String words = callOnEdt(() -> diagram.getAccessibleContext().getAccessibleDescription());
        assertFalse(words.matches(".*F[34].*"), words);
        return texts.get(true).get(texts.get(true).size() - 1);
    }
}
