package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.recording.TraceChannels;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SampleSessionFrames;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.chart.Axis;
import faultline.paint.surface.Contrast;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.awt.Color;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JCheckBoxMenuItem;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What strip charts show beside the lines of one signal, and the files that they become. */
class StripContentTest {

    private static final SessionFrame FRAME = SampleRuns.frame(2000);
    private static final List<SignalGroup> GROUPS =
            SignalGroup.allOf(FRAME.snapshot().robot().sensorIds());
    private static final TimeSpan SPAN = new TimeSpan(10, 10);
    /** Less than the width of a halo in an image with four times as many pixels. */
    private static final int NEAR = 4;

    private static final ReferenceRun OTHER_RUN = ReferenceRun.replay(
            new Journal(SampleRuns.ROOM_SETUP.withStart(new Pose(2, 1.3, 0.1)), List.of(), 2000), tick -> true);

    private final StripChart chart = callOnEdt(StripChart::new);

    @BeforeEach
    void shown() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            chart.setFrame(FRAME);
            SampleRuns.render(chart, 560, 220);
        });
    }

    private static StripContent content(TimeSpan span, List<TimelineItem> items, ReferenceRun reference) {
        return new StripContent(FRAME, GROUPS.get(0), span, ValueRange.FROM_ZERO, items, reference);
    }

    private static int rgb(StripContent content, double time, double value) {
        StripScale scale = content.scale(900, 420, true);
        return content.toImage(Theme.LIGHT, 1)
                        .getRGB((int) scale.plot().x(time), (int) scale.plot().y(value))
                & 0xFFFFFF;
    }

    private static TimelineItem fault(String sensor) {
        return new TimelineItem(new Command.InjectFault(sensor, new Fault.Dead()), 12.05, 14.05);
    }

    @Test
    void aFaultIsShadedBehindTheLinesInTheColourOfItsSensor() {
        TimelineItem fault = fault("left");
        StripContent with = content(SPAN, List.of(fault), null);
        assertEquals(rgb(content(SPAN, List.of(), null), 11, 0.03), rgb(with, 11, 0.03));
        assertNotEquals(rgb(content(SPAN, List.of(), null), 13, 0.03), rgb(with, 13, 0.03));
        assertNotEquals(rgb(content(SPAN, List.of(fault("front")), null), 13, 0.03), rgb(with, 13, 0.03));
    }

    @Test
    void faultsOfOneSensorShadeItOnce() {
        assertEquals(
                rgb(content(SPAN, List.of(fault("left")), null), 13, 0.03),
                rgb(content(SPAN, Collections.nCopies(6, fault("left")), null), 13, 0.03));
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void allFaultySensorsTogetherLeaveTheTextReadable(Theme theme) {
        List<TimelineItem> faults = FRAME.snapshot().sensors().stream()
                .map(sensor -> fault(sensor.spec().id()))
                .toList();
        StripContent content = content(SPAN, faults, null);
        StripScale scale = content.scale(900, 420, true);
        Color shade = new Color(content.toImage(theme, 1)
                .getRGB((int) scale.plot().x(13), (int) scale.plot().y(0.03)));
        assertTrue(Contrast.of(theme.palette().text(), shade) >= 7, shade.toString());
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void aCurveIsSeenWhereTwoSensorsAreFaulty(Theme theme) {
        List<String> sensors = FRAME.snapshot().robot().sensorIds();
        List<Color> curves = content(SPAN, List.of(), null).signal().lines().stream()
                .map(line -> line.style(theme).colour())
                .toList();
        for (String one : sensors) {
            for (String other : sensors) {
                StripContent content = content(SPAN, List.of(fault(one), fault(other)), null);
                StripScale scale = content.scale(900, 420, true);
                Color shade = new Color(content.toImage(theme, 1)
                        .getRGB((int) scale.plot().x(13), (int) scale.plot().y(0.03)));
                curves.forEach(curve -> assertTrue(Contrast.of(curve, shade) >= 3, one + " and " + other));
            }
        }
    }

    /** The colours of many sensors have a contrast of 3 to the canvas only, so each line has a halo. */
    @ParameterizedTest
    @EnumSource(Theme.class)
    void everyCurveIsSeparatedFromTheShadesOfTwoFaultySensors(Theme theme) {
        List<String> sensors = FRAME.snapshot().robot().sensorIds();
        // There is no band, because no pixel has several ticks.
        TimeSpan span = new TimeSpan(11.5, 3);
        long separated = 0;
        for (int i = 0; i < GROUPS.size(); i++) {
            List<TimelineItem> faults =
                    List.of(fault(sensors.get(i % sensors.size())), fault(sensors.get((i + 1) % sensors.size())));
            StripContent content = new StripContent(FRAME, GROUPS.get(i), span, ValueRange.FITTED, faults, OTHER_RUN);
            BufferedImage image = content.toImage(theme, 4);
            StripScale scale = content.scale(900, 420, true);
            separated += Stream.concat(
                            content.signal().lines().stream()
                                    .map(line -> line.style(theme).colour()),
                            Stream.of(theme.palette().reference()))
                    .distinct()
                    .mapToLong(curve -> countSeparated(image, curve, scale, content.signal()))
                    .sum();
        }
        assertTrue(separated > 1000, separated + " pixels of curves");
    }

    /** Counts the pixels of a curve whose colour differs too little from the shade, which touches none of them. */
    private static long countSeparated(BufferedImage image, Color curve, StripScale scale, SignalGroup signal) {
        int left = (int) (4 * scale.plot().x(12.5));
        int right = (int) (4 * scale.plot().x(13.5));
        int top = (int) (4 * scale.plot().area().y());
        int[] shaded = image.getRGB(left, top, right - left, image.getHeight() - top, null, 0, right - left);
        int shade = mostFrequent(shaded);
        long found = 0;
        if (Contrast.of(curve, new Color(shade)) < 3) {
            for (int i = 0; i < shaded.length; i++) {
                int x = left + i % (right - left);
                int y = top + i / (right - left);
                found += shaded[i] == curve.getRGB() ? 1 : 0;
                assertFalse(
                        shaded[i] == curve.getRGB()
                                && IntStream.rangeClosed(-NEAR, NEAR)
                                        .anyMatch(d -> image.getRGB(x + d, y) == shade
                                                || y + d < image.getHeight() && image.getRGB(x, y + d) == shade),
                        signal.name() + " at " + x + ", " + y);
            }
        }
        return found;
    }

    private static int mostFrequent(int[] pixels) {
        int[] sorted = pixels.clone();
        Arrays.sort(sorted);
        int most = 0;
        int mode = 0;
        for (int from = 0, to; from < sorted.length; from = to) {
            to = from + 1;
            while (to < sorted.length && sorted[to] == sorted[from]) {
                to++;
            }
            if (to - from > most) {
                most = to - from;
                mode = sorted[from];
            }
        }
        return mode;
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void theGridIsSeenWhereASensorIsOffOrFaulty(Theme theme) {
        for (Command start :
                List.of(new Command.SwitchSensor("front", false), new Command.InjectFault("left", new Fault.Dead()))) {
            StripContent content = content(SPAN, List.of(new TimelineItem(start, 10, 20)), null);
            StripScale scale = content.scale(900, 420, true);
            BufferedImage image = content.toImage(theme, 1);
            // A line of the grid below all curves, between two lines across.
            double value = scale.plot().vertical().ticks().get(1);
            int x = (int) scale.plot().x(12.5);
            int y = (int) scale.plot().y(value);
            double contrast = IntStream.rangeClosed(-1, 1)
                    .mapToDouble(
                            row -> Contrast.of(new Color(image.getRGB(x, y + row)), new Color(image.getRGB(x, y - 8))))
                    .max()
                    .orElseThrow();
            assertTrue(contrast >= 1.12, start + " at " + value + ": " + contrast);
        }
    }

    @Test
    void theDistanceOfAControllerFromOutsideRefersToTheSensors() {
        ControllerSource silent = new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                return observation -> new Decision(1, 1, Telemetry.ofState(FollowerState.SEARCH));
            }

            @Override
            public boolean limitsAnswerTime() {
                return true;
            }
        };
        SessionFrame frame = SampleRuns.frame(
                SampleRuns.ROOM_SETUP.withController(
                        new ControllerSpec.Chosen(SampleRuns.ROOM_SETUP.controller(), silent)),
                10);
        List<String> shown = GROUPS.stream()
                .limit(2)
                .map(signal ->
                        new StripContent(frame, signal, SPAN, ValueRange.FROM_ZERO, List.of(), null).toSvg(Theme.LIGHT))
                .toList();
        assertTrue(shown.get(0).contains("The controller reports no distance;"));
        assertTrue(shown.get(0).contains("choose a sensor in the list of signals"));
        assertFalse(shown.get(0).contains("No data"));
        assertTrue(shown.get(1).contains("No data"), "the other signals");
        assertTrue(content(new TimeSpan(1000, 10), List.of(), null)
                .toSvg(Theme.LIGHT)
                .contains("No data"));
    }

    @Test
    void aChartWithOnlyTheCurvesOfAReferenceRunDoesNotSayThatThereIsNoData() {
        ReferenceRun other = ReferenceRun.replay(new Journal(SampleRuns.ROOM_SETUP, List.of(), 100), tick -> true);
        TimeSpan future = new TimeSpan(1000, 10);
        assertTrue(content(future, List.of(), null).toSvg(Theme.LIGHT).contains("No data"));
        assertFalse(content(future, List.of(), other).toSvg(Theme.LIGHT).contains("No data"));
    }

    @Test
    void theReferenceRunHasItsOwnCurves() {
        ReferenceRun other = ReferenceRun.replay(
                new Journal(SampleRuns.ROOM_SETUP.withStart(new Pose(2, 1.3, 0.1)), List.of(), 2000), tick -> true);
        Color colour = Theme.LIGHT.palette().reference();
        assertEquals(0, SampleRuns.count(content(SPAN, List.of(), null).toImage(Theme.LIGHT, 1), colour));
        assertTrue(SampleRuns.count(content(SPAN, List.of(), other).toImage(Theme.LIGHT, 1), colour) > 20);
    }

    @Test
    void zoomedOutABandShowsLeastAndGreatestValues() {
        SessionFrame longRun = SampleRuns.frame(20_000);
        int[] shades = Stream.of(SPAN, new TimeSpan(0, 200))
                .mapToInt(span -> {
                    StripContent content =
                            new StripContent(longRun, GROUPS.get(0), span, ValueRange.FROM_ZERO, List.of(), null);
                    return content.toSvg(Theme.LIGHT).split("fill-opacity=", -1).length;
                })
                .toArray();
        assertTrue(shades[1] > shades[0], "translucent areas: " + shades[0] + ", " + shades[1]);
    }

    @Test
    void signalsWithTheSameUnitCanBeAdded() {
        List<String> offered =
                callOnEdt(() -> items(chart).map(JCheckBoxMenuItem::getText).toList());
        assertEquals(2 * 8, offered.size());
        assertEquals("1  Sensor front, reported", offered.get(0));
        runOnEdt(() -> items(chart).findFirst().orElseThrow().doClick());
        assertEquals(3, lines().size());
        assertEquals(TraceChannels.reportedReading(0), lines().get(0).channel());
        assertTrue(callOnEdt(() -> items(chart).findFirst().orElseThrow().isSelected()));
        runOnEdt(() -> items(chart).findFirst().orElseThrow().doClick());
        assertEquals(2, lines().size());
    }

    private static Stream<JCheckBoxMenuItem> items(StripChart chart) {
        return Stream.of(chart.createAdditionsMenu().getComponents()).map(JCheckBoxMenuItem.class::cast);
    }

    private List<ChartLine> lines() {
        return callOnEdt(() -> chart.content().orElseThrow().signal().lines());
    }

    @Test
    void aLineHasTheColourOfItsSensorOnTheCanvas() {
        Palette palette = Theme.LIGHT.palette();
        assertEquals(
                palette.sensorColours(2).outline(),
                GROUPS.get(5 + 2).lines().get(0).colour().apply(Theme.LIGHT));
    }

    @Test
    void ctrlAndTheWheelZoomTheValuesAtTheCursor() {
        Axis before = verticalAxis();
        double value = before.valueAt(0.25);
        runOnEdt(() -> {
            StripScale scale = chart.content().orElseThrow().scale(width(), height(), false);
            int y = (int) Math.round(scale.plot().y(value));
            chart.view()
                    .dispatchEvent(new MouseWheelEvent(
                            chart.view(),
                            MouseEvent.MOUSE_WHEEL,
                            0,
                            InputEvent.CTRL_DOWN_MASK,
                            200,
                            y,
                            0,
                            false,
                            MouseWheelEvent.WHEEL_UNIT_SCROLL,
                            1,
                            -4));
        });
        Axis after = verticalAxis();
        assertEquals((before.high() - before.low()) / Math.pow(1.25, 4), after.high() - after.low(), 1e-9);
        assertEquals(0.25, after.fractionOf(value), 0.01);
        assertEquals(20, chart.view().span().end(), 1e-9, "the times stay");
        runOnEdt(chart::release);
        assertEquals(before, verticalAxis());
    }

    private int width() {
        return chart.view().getWidth();
    }

    private int height() {
        return chart.view().getHeight();
    }

    private Axis verticalAxis() {
        return callOnEdt(() -> chart.content()
                .orElseThrow()
                .scale(width(), height(), false)
                .plot()
                .vertical());
    }

    /**
     * The robot follows the wall by the end: it drives at its speed, and the commanded values are about the actual
     * ones.
     */
    @Test
    void theTableOfTheVelocitiesHasTheirUnitsAndTheActualAndTheCommandedValue() {
        List<List<String>> velocity = table(3);
        assertEquals(List.of("t (s)", "\"commanded (m/s)\"", "\"actual (m/s)\""), velocity.get(0));
        List<String> last = velocity.get(velocity.size() - 1);
        assertEquals(FRAME.snapshot().wheelSpeeds().linear(), Double.parseDouble(last.get(2)), 1e-6);
        assertEquals(Double.parseDouble(last.get(1)), Double.parseDouble(last.get(2)), 0.02);
        List<List<String>> turnRate = table(4);
        assertEquals(List.of("t (s)", "\"commanded (°/s)\"", "\"actual (°/s)\""), turnRate.get(0));
        double actual = FRAME.snapshot()
                .wheelSpeeds()
                .toVelocity(FRAME.snapshot().robot().track())
                .angular();
        assertEquals(
                StrictMath.toDegrees(actual),
                Double.parseDouble(turnRate.get(turnRate.size() - 1).get(2)),
                1e-4);
    }

    private static List<List<String>> table(int group) {
        return callOnEdt(() ->
                        new StripContent(FRAME, GROUPS.get(group), SPAN, ValueRange.FITTED, List.of(), null).toCsv())
                .lines()
                .map(row -> List.of(row.split(",")))
                .toList();
    }

    @Test
    void theTableHasARowForEveryTickAndAnEmptyCellForNothing() {
        List<String> rows = callOnEdt(() ->
                        new StripContent(FRAME, GROUPS.get(5 + 5), SPAN, ValueRange.FITTED, List.of(), null).toCsv())
                .lines()
                .toList();
        assertEquals("t (s),\"reported (m)\",\"true (m)\"", rows.get(0));
        assertTrue(rows.get(1).matches("10,0\\.4,(\\d\\.\\d+)?"), rows.get(1));
        assertEquals(1 + 1001, rows.size());
        assertTrue(rows.get(1001).startsWith("20,"), rows.get(1001));
    }

    @Test
    void timesOfATableAreDecimalsWithoutTheErrorsOfMultiplication() {
        List<String> rows =
                content(new TimeSpan(0, 20), List.of(), null).toCsv().lines().toList();
        for (int tick = 0; tick <= 2000; tick++) {
            String time = BigDecimal.valueOf(tick, 2).stripTrailingZeros().toPlainString();
            assertEquals(time, rows.get(tick + 1).split(",", -1)[0]);
        }
    }

    @Test
    void aSensorIsComparedWithTheSensorOfThatNameInTheReferenceRun() {
        RobotSpec robot = SampleRuns.ROOM_SETUP.robot();
        List<SensorSpec> reversed = new ArrayList<>(robot.sensors());
        Collections.reverse(reversed);
        reversed.removeIf(sensor -> sensor.id().equals("front"));
        Journal journal = new Journal(SampleRuns.ROOM_SETUP.withRobot(robot.withSensors(reversed)), List.of(), 0);
        ReferenceRun other = ReferenceRun.replay(journal, tick -> true);
        TimeSpan start = new TimeSpan(0, 1);
        for (SignalGroup group : GROUPS.subList(5, GROUPS.size())) {
            StripContent content = new StripContent(FRAME, group, start, ValueRange.FITTED, List.of(), other);
            List<String> rows = content.toCsv().lines().toList();
            assertEquals(
                    !group.name().equals("Sensor front"),
                    content.toSvg(Theme.LIGHT).contains(">ghost<"),
                    "legend of " + group.name());
            if (group.name().equals("Sensor front")) {
                assertEquals("t (s),\"reported (m)\",\"true (m)\"", rows.get(0));
            } else {
                String[] cells = rows.get(1).split(",", -1);
                assertEquals(5, cells.length, group.name());
                assertEquals(cells[1], cells[3], group.name());
                assertEquals(cells[2], cells[4], group.name());
            }
        }
    }

    @Test
    void aTableHasColumnsForTheReferenceRunAsFarAsItGoes() {
        Journal journal = new Journal(SampleRuns.ROOM_SETUP.withStart(new Pose(2, 1.3, 0.1)), List.of(), 1500);
        ReferenceRun other = ReferenceRun.replay(journal, tick -> true);
        List<String> rows = content(SPAN, List.of(), other).toCsv().lines().toList();
        assertEquals(
                "t (s),\"target (m)\",\"distance used (m)\",\"ghost, target (m)\",\"ghost, distance used (m)\"",
                rows.get(0));
        float expected = other.recording().trace().finestLevel().min(TraceChannels.MEASURED_DISTANCE, 1499);
        assertEquals(Float.toString(expected), rows.get(500).split(",", -1)[4]);
        assertTrue(rows.get(502).startsWith("15.01,") && rows.get(502).endsWith(",,"), rows.get(502));
    }

    @Test
    void aTableHasRowsForAReferenceRunThatIsLonger() {
        SessionFrame start = SampleRuns.frame(200);
        ReferenceRun longer = ReferenceRun.replay(new Journal(SampleRuns.ROOM_SETUP, List.of(), 1000), tick -> true);
        List<String> rows = new StripContent(
                        start, GROUPS.get(0), new TimeSpan(0, 20), ValueRange.FROM_ZERO, List.of(), longer)
                .toCsv()
                .lines()
                .toList();
        int last = 1000;
        assertEquals(1 + last + 1, rows.size());
        String[] cells = rows.get(1 + last).split(",", -1);
        assertEquals(List.of("10", "", ""), List.of(cells).subList(0, 3));
        float target = longer.recording().trace().finestLevel().min(TraceChannels.MEASURED_DISTANCE, last);
        assertEquals(Float.toString(target), cells[4]);
    }

    @Test
    void theAxisCoversTheReferenceRun() {
        ReferenceRun close = ReferenceRun.replay(
                new Journal(
                        SampleRuns.ROOM_SETUP.withController(ControllerSpec.WallFollowing.DEFAULT.withDistance(0.45)),
                        List.of(),
                        2000),
                tick -> true);
        double alone = content(SPAN, List.of(), null)
                .scale(500, 200, false)
                .plot()
                .vertical()
                .high();
        double both = content(SPAN, List.of(), close)
                .scale(500, 200, false)
                .plot()
                .vertical()
                .high();
        assertTrue(alone < 0.45 && both >= 0.45, alone + ", " + both);
    }

    /** A text of a chart makes a subscript of what follows an underscore, as in t_D. */
    @Test
    void underscoresInTheNamesOfSensorsAndStatesAreDrawn() {
        Telemetry telemetry = FRAME.telemetry();
        Telemetry named = new Telemetry(
                ControllerState.of("KEEP_LEFT"),
                telemetry.condition(),
                telemetry.sinceTick(),
                telemetry.transitions(),
                telemetry.wall(),
                telemetry.edges(),
                telemetry.diagnosis());
        SessionFrame frame = SampleSessionFrames.unmeasured(
                new Frame(
                        FRAME.snapshot(),
                        named,
                        FRAME.frame().leftVolts(),
                        FRAME.frame().rightVolts(),
                        FRAME.frame().path(),
                        FRAME.frame().trajectoryHash()),
                FRAME.recording());
        ChartLine line = GROUPS.get(5).lines().get(0).withName("Sensor left_front, reported");
        String svg = new StripContent(
                        frame, GROUPS.get(0).with(List.of(line)), SPAN, ValueRange.FROM_ZERO, List.of(), null)
                .toSvg(Theme.LIGHT);
        assertTrue(svg.contains(">KEEP_LEFT<"), svg);
        assertTrue(svg.contains(">Sensor left_front, reported<"), svg);
    }

    @Test
    void theDrawingNamesItsLines() {
        String svg = content(SPAN, List.of(), null).toSvg(Theme.LIGHT);
        assertTrue(svg.contains("distance used") && svg.contains("target"), svg);
        assertFalse(svg.contains("NaN"));
    }
}
