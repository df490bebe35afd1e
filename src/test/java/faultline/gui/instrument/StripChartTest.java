package faultline.gui.instrument;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.recording.TraceChannels;
import faultline.engine.recording.TraceLevel;
import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.ComponentFinder;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.chart.Axis;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.MenuElement;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The strip chart without a display: its choices, values and wheel. */
class StripChartTest {

    private static final int WIDTH = 560;
    private static final int HEIGHT = 220;
    private static final SessionFrame FRAME = SampleRuns.frame(2000);

    private StripChart chart;

    @BeforeEach
    void shown() {
        runOnEdt(() -> {
            TextSize.NORMAL.install();
            Theme.LIGHT.install();
            chart = new StripChart();
            chart.setFrame(FRAME);
            SampleRuns.render(chart, WIDTH, HEIGHT);
        });
    }

    private void choose(int signal) {
        runOnEdt(() -> ComponentFinder.find(chart, JComboBox.class, "Signals").setSelectedIndex(signal));
    }

    /** Returns the values shown at a time of a span of ten seconds. */
    private List<String> readOut(double time) {
        return callOnEdt(() -> {
            chart.view().setPointer(x(time));
            return chart.view().tooltip();
        });
    }

    private double x(double time) {
        TimeSpan span = chart.view().span();
        return StripScale.LEFT_MARGIN
                + (time - span.start())
                        / span.length()
                        * (chart.view().getWidth() - StripScale.LEFT_MARGIN - StripScale.RIGHT_MARGIN);
    }

    @Test
    void screenReadersCallItACanvas() {
        AccessibleContext view = callOnEdt(() -> chart.view().getAccessibleContext());
        assertEquals("Strip chart", view.getAccessibleName());
        assertEquals(AccessibleRole.CANVAS, view.getAccessibleRole());
    }

    @Test
    void itOffersTheControllersNumbersAndEverySensor() {
        JComboBox<?> choice = ComponentFinder.find(chart, JComboBox.class, "Signals");
        assertEquals(5 + 8, callOnEdt(choice::getItemCount));
        assertEquals("Sensor left", callOnEdt(() -> choice.getItemAt(7).toString()));
    }

    /** Returns a frame of a robot without one of the sensors. */
    private static SessionFrame frameWithout(String sensor) {
        RobotSpec robot = SampleRuns.ROOM_SETUP.robot();
        return SampleRuns.frame(
                SampleRuns.ROOM_SETUP.withRobot(robot.withSensors(robot.sensors().stream()
                        .filter(spec -> !spec.id().equals(sensor))
                        .toList())),
                50);
    }

    private List<String> shownLines() {
        return callOnEdt(() -> chart.content().orElseThrow().signal().lines().stream()
                .map(ChartLine::name)
                .toList());
    }

    private void addLineOfRear() {
        JMenuItem added = (JMenuItem) Stream.of(chart.createAdditionsMenu().getSubElements())
                .map(MenuElement::getComponent)
                .filter(item -> ((JMenuItem) item).getText().contains("rear, reported"))
                .findFirst()
                .orElseThrow();
        added.doClick(0);
    }

    @Test
    void theChosenSensorAndTheAddedLinesStayWhenAnotherSensorIsRemoved() {
        choose(5 + 6);
        runOnEdt(() -> {
            addLineOfRear();
            chart.setFrame(frameWithout("front-left"));
        });
        JComboBox<?> choice = ComponentFinder.find(chart, JComboBox.class, "Signals");
        assertEquals("Sensor right", callOnEdt(() -> choice.getSelectedItem().toString()));
        assertEquals(List.of("Sensor rear, reported", "reported", "true"), shownLines());
    }

    /** Shows a frame of a robot with other ids of sensors, given those that differ. */
    private void rename(Map<String, String> ids) {
        UnaryOperator<String> presentId = id -> ids.getOrDefault(id, id);
        RobotSpec robot = SampleRuns.ROOM_SETUP.robot();
        chart.renameSensors(presentId);
        chart.setFrame(SampleRuns.frame(
                SampleRuns.ROOM_SETUP.withRobot(robot.withSensors(robot.sensors().stream()
                        .map(spec -> spec.withId(presentId.apply(spec.id())))
                        .toList())),
                50));
    }

    @Test
    void theChosenSensorAndTheAddedLinesStayWhenSensorsAreRenamed() {
        choose(5 + 6);
        runOnEdt(() -> {
            addLineOfRear();
            rename(Map.of("right", "starboard", "rear", "stern"));
        });
        JComboBox<?> choice = ComponentFinder.find(chart, JComboBox.class, "Signals");
        assertEquals(
                "Sensor starboard", callOnEdt(() -> choice.getSelectedItem().toString()));
        assertEquals(List.of("Sensor stern, reported", "reported", "true"), shownLines());
    }

    @Test
    void choosingTheChosenSignalKeepsAddedLinesAndTheZoom() {
        int right = 5 + 6;
        choose(right);
        ValueRange zoomed = ValueRange.fixed(0.2, 0.3);
        runOnEdt(() -> {
            addLineOfRear();
            chart.view().setRange(zoomed);
        });
        choose(right);
        runOnEdt(() -> {
            JMenu signals = (JMenu) chart.createMenu().getComponent(0);
            signals.getItem(right).doClick(0);
        });
        assertEquals(List.of("Sensor rear, reported", "reported", "true"), shownLines());
        assertEquals(zoomed, callOnEdt(() -> chart.view().range()));
        choose(right - 1);
        assertEquals(List.of("reported", "true"), shownLines());
    }

    @Test
    void theDistanceIsShownWhenTheChosenSensorIsRemoved() {
        choose(5 + 1);
        runOnEdt(() -> chart.setFrame(frameWithout("front-left")));
        assertEquals(List.of("target", "distance used"), shownLines());
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void linesThatCanBeShownTogetherDiffer(Theme theme) {
        List<String> sensors =
                IntStream.rangeClosed(1, 64).mapToObj(i -> "sensor-" + i).toList();
        List<SignalGroup> all = SignalGroup.allOf(sensors);
        for (SignalGroup shown : all) {
            List<ChartLine> lines =
                    shown.with(SignalGroup.additions(shown, all)).lines();
            assertEquals(
                    lines.size(),
                    lines.stream().map(line -> line.style(theme)).distinct().count(),
                    shown.name());
        }
    }

    @Test
    void everyLineIsNamedHoweverNarrowTheChart() {
        assertTrue(isLegendComplete(WIDTH), "in one row");
        assertTrue(isLegendComplete(420), "in two rows");
        assertEquals(List.of(), namesAbovePlot());
        assertFalse(isLegendComplete(330));
        assertEquals(List.of("distance used", "target"), namesAbovePlot());
    }

    private boolean isLegendComplete(int width) {
        runOnEdt(() -> SampleRuns.render(chart, width, HEIGHT));
        return callOnEdt(() -> ComponentFinder.findAll(chart, StripLegend.class)
                .findFirst()
                .orElseThrow()
                .isComplete());
    }

    /** Returns the names above the plot of the chart in its present size. */
    private List<String> namesAbovePlot() {
        return callOnEdt(() -> chart.view().scale().orElseThrow().legend().rows().rows().stream()
                .flatMap(row -> row.stream().map(LegendEntry::name))
                .toList());
    }

    /** A thin line between two rows of pixels has half of its colour in each. */
    @ParameterizedTest
    @EnumSource(Theme.class)
    void theSampleOfALineHasItsColour(Theme theme) {
        runOnEdt(theme::install);
        for (int width : new int[] {WIDTH, 420}) {
            BufferedImage picture = callOnEdt(() -> {
                SampleRuns.render(chart, width, HEIGHT);
                StripLegend legend = ComponentFinder.findAll(chart, StripLegend.class)
                        .findFirst()
                        .orElseThrow();
                return SampleRuns.render(legend, legend.getWidth(), legend.getHeight());
            });
            for (ChartLine line :
                    callOnEdt(() -> chart.view().scale().orElseThrow().signal().lines())) {
                Color colour = line.style(theme).colour();
                assertTrue(SampleRuns.count(picture, colour) > 5, line.name() + " at " + width);
            }
        }
    }

    /** The samples of the lines are in the middle if there is one row. */
    @Test
    void theLegendHasOneRowOnlyIfItsNamesFitIntoIt() {
        Color colour = callOnEdt(
                        () -> chart.view().scale().orElseThrow().signal().lines())
                .get(0)
                .style(Theme.LIGHT)
                .colour();
        for (int width = 400; width < WIDTH; width++) {
            int chartWidth = width;
            boolean fits = callOnEdt(() -> {
                SampleRuns.render(chart, chartWidth, HEIGHT);
                return legend().getWidth() >= legend().getMaximumSize().width;
            });
            BufferedImage picture =
                    callOnEdt(() -> SampleRuns.render(legend(), legend().getWidth(), legend().getHeight()));
            BufferedImage middle = picture.getSubimage(0, picture.getHeight() / 2 - 1, picture.getWidth(), 2);
            assertEquals(fits, SampleRuns.count(middle, colour) > 5, "at " + width);
        }
    }

    private StripLegend legend() {
        return ComponentFinder.findAll(chart, StripLegend.class).findFirst().orElseThrow();
    }

    @Test
    void aLowChartHasRoomForItsLinesBeforeThatOfTheirNames() {
        TimeSpan span = TimeSpan.DEFAULT.endingAt(FRAME.snapshot().time());
        for (int height = 86; height < 130; height++) {
            StripScale scale = content(FRAME, span, ValueRange.FROM_ZERO).scale(190, height, true);
            assertTrue(
                    scale.plot().area().height() >= 30,
                    height + ": " + scale.plot().area());
            assertEquals(height >= 89, !scale.legend().rows().rows().isEmpty(), "names at " + height);
        }
        StripScale small = content(FRAME, span, ValueRange.FROM_ZERO).scale(250, 100, true);
        assertEquals(2, small.legend().rows().rows().get(0).size(), "both names above the labels of the axis, too");
        assertTrue(small.legend().rows().width() + small.legend().corner().x() <= 250, "wider than the picture");
        StripScale narrow = content(FRAME, span, ValueRange.FROM_ZERO).scale(125, 120, true);
        assertEquals(LegendPlace.NONE, narrow.legend(), "a name is wider than the picture");
    }

    @ParameterizedTest
    @EnumSource(TextSize.class)
    void namesLieAbovePlotAndRibbonOfAChartOfAnySize(TextSize size) {
        runOnEdt(size::install);
        addSensors(4);
        for (int width : new int[] {240, 330, 480, 700, 1200}) {
            for (int height : new int[] {140, 200, 400}) {
                runOnEdt(() -> SampleRuns.render(chart, width, height));
                StripScale scale = callOnEdt(() -> chart.view().scale().orElseThrow());
                LegendPlace legend = scale.legend();
                PixelRectangle area = scale.plot().area();
                int rows = legend.rows().rows().size();
                String message = width + "x" + height + " leaves " + area;
                assertTrue(
                        rows == 0
                                || legend.corner().y() + rows * LegendPlace.ROW_HEIGHT
                                        <= area.y() - StripScale.TOP_MARGIN
                                || area.x() + area.width() < legend.corner().x(),
                        message);
                assertTrue(rows <= 1 || area.height() >= 45 || legend.beside() > 0, message);
                assertTrue(
                        TextSize.unscaled(width) < 480
                                || rows == 0
                                || namesAbovePlot().size() == 6,
                        message + namesAbovePlot());
            }
        }
        runOnEdt(TextSize.NORMAL::install);
    }

    @Test
    void theValuesAtTheCursorShowTheColoursOfTheirLines() {
        addSensors(4);
        runOnEdt(() -> SampleRuns.render(chart, 240, HEIGHT));
        StripScale scale = callOnEdt(() -> chart.view().scale().orElseThrow());
        BufferedImage picture = new BufferedImage(240, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = picture.createGraphics();
        ChartTooltip values = new ChartTooltip(scale, 15);
        values.paint(graphics, Theme.LIGHT, 240, HEIGHT);
        graphics.dispose();
        assertEquals(scale.signal().lines().size() + 1, values.lines().size());
        for (ChartLine line : scale.signal().lines()) {
            long pixels = SampleRuns.count(picture, line.colour().apply(Theme.LIGHT));
            assertTrue(pixels >= 16, line.name() + " has " + pixels + " pixels");
        }
    }

    @Test
    void theBoxOfValuesIsWithinTheChart() {
        addSensors(2);
        for (int width : new int[] {240, 300, 420}) {
            runOnEdt(() -> SampleRuns.render(chart, width, HEIGHT));
            StripScale scale = callOnEdt(() -> chart.view().scale().orElseThrow());
            FontMetrics metrics = callOnEdt(() -> chart.getFontMetrics(new Font(Font.SANS_SERIF, Font.PLAIN, 12)));
            for (double time = 10.5; time < 20; time += 0.5) {
                Rectangle2D box = new ChartTooltip(scale, time).box(metrics, width, HEIGHT);
                assertTrue(new Rectangle2D.Double(0, 0, width, HEIGHT).contains(box), time + ": " + box);
            }
        }
    }

    /** Adds the first lines that can be shown beside the distance. */
    private void addSensors(int count) {
        for (int i = 0; i < count; i++) {
            int item = i;
            runOnEdt(() -> ((AbstractButton) chart.createAdditionsMenu().getComponent(item)).doClick());
        }
    }

    @Test
    void theLinesOfTheMenuHaveMnemonics() {
        List<Integer> mnemonics =
                callOnEdt(() -> Stream.of(chart.createAdditionsMenu().getComponents())
                        .map(item -> ((AbstractButton) item).getMnemonic())
                        .toList());
        assertTrue(mnemonics.size() > 5, "there are " + mnemonics.size() + " lines");
        assertFalse(mnemonics.contains(0));
        assertEquals(mnemonics.stream().distinct().toList(), mnemonics);
    }

    @Test
    void theGhostIsNamedWhileThereIsOne() {
        ReferenceRun ghost = ReferenceRun.replay(new Journal(SampleRuns.ROOM_SETUP, List.of(), 100), tick -> true);
        runOnEdt(() -> chart.setReference(ghost));
        isLegendComplete(330);
        assertEquals(List.of("distance used", "target", "ghost"), namesAbovePlot());
        BufferedImage with = bar(ghost);
        BufferedImage without = bar(null);
        long changed = IntStream.range(0, with.getHeight())
                .mapToLong(y -> IntStream.range(0, with.getWidth())
                        .filter(x -> with.getRGB(x, y) != without.getRGB(x, y))
                        .count())
                .sum();
        assertTrue(changed > 30, "beside the controls: " + changed + " pixels");
    }

    /** Returns an image of the controls with the legend beside them. */
    private BufferedImage bar(ReferenceRun ghost) {
        return callOnEdt(() -> {
            StripChart fresh = new StripChart();
            fresh.setFrame(FRAME);
            fresh.setReference(ghost);
            BufferedImage image = SampleRuns.render(fresh, 700, HEIGHT);
            return image.getSubimage(0, 0, 700, fresh.view().getY());
        });
    }

    private void press(String key) {
        runOnEdt(() -> {
            StripView view = chart.view();
            Object name = view.getInputMap().get(KeyStroke.getKeyStroke(key));
            assertTrue(view.getActionMap().get(name).isEnabled());
            view.getActionMap().get(name).actionPerformed(new ActionEvent(view, 0, key));
        });
    }

    private String description() {
        return callOnEdt(() -> chart.view().getAccessibleContext().getAccessibleDescription());
    }

    @Test
    void keysShowTheValuesAndSayThem() {
        String lines = "Distance to the wall: target, distance used";
        assertEquals(lines, description());
        press("shift LEFT");
        assertTrue(description().startsWith("Distance to the wall: t 20.000 s, distance used 0.2"), description());
        press("shift LEFT");
        assertTrue(
                description().startsWith("Distance to the wall: t 19.980 s, "), "a pixel is 0.02 s: " + description());
        press("ctrl LEFT");
        assertEquals("t 18.980 s", callOnEdt(() -> chart.view().tooltip()).get(0));
        press("shift RIGHT");
        assertEquals("t 19.000 s", callOnEdt(() -> chart.view().tooltip()).get(0));
        press("ctrl RIGHT");
        press("ctrl RIGHT");
        assertTrue(description().startsWith("Distance to the wall: t 20.000 s, "), description());
        press("ESCAPE");
        assertEquals(lines, description());
        assertEquals(List.of(), callOnEdt(() -> chart.view().tooltip()));
    }

    @Test
    void keysReachEveryTickOfAShortSpan() {
        runOnEdt(() -> chart.view().setSpan(new TimeSpan(19.8, 0.2)));
        press("shift LEFT");
        for (int tick = 1999; tick > 1985; tick--) {
            press("shift LEFT");
            assertEquals(
                    String.format(Locale.ROOT, "t %.3f s", tick / 100.0),
                    callOnEdt(() -> chart.view().tooltip()).get(0));
        }
    }

    @Test
    void timesTellShortTicksApart() {
        runOnEdt(() -> {
            chart.setFrame(SampleRuns.frame(SampleRuns.ROOM_SETUP.withTick(5e-4), 2000));
            chart.view().setSpan(new TimeSpan(0.8, 0.2));
            SampleRuns.render(chart, 420, HEIGHT);
        });
        StripScale scale = callOnEdt(() -> chart.view().scale().orElseThrow());
        assertEquals("t 0.9990 s", new ChartTooltip(scale, 0.999).lines().get(0));
        assertEquals("t 0.9995 s", new ChartTooltip(scale, 0.9995).lines().get(0));
    }

    @Test
    void itRunsAlongWithTheNewestFrame() {
        assertEquals(20, chart.view().span().end(), 1e-9);
        runOnEdt(() -> chart.setFrame(SampleRuns.frame(2100)));
        assertEquals(21, chart.view().span().end(), 1e-9);
    }

    @Test
    void heldItStandsStill() {
        runOnEdt(() -> {
            ComponentFinder.find(chart, JToggleButton.class, "Hold the strip chart")
                    .doClick(0);
            chart.setFrame(SampleRuns.frame(2100));
        });
        assertEquals(20, chart.view().span().end(), 1e-9);
    }

    @Test
    void pointingReadsOutTheMomentAndTheValues() {
        String measured = String.format(
                Locale.ROOT,
                "distance used %.3f m",
                FRAME.recording().trace().finestLevel().min(TraceChannels.MEASURED_DISTANCE, 1500));
        assertEquals(List.of("t 15.000 s", measured, "target 0.250 m"), readOut(15));
    }

    /** The Run panel shows the same value in degrees; the PD terms have the unit of their gains. */
    @Test
    void theTurnRateIsInDegreesPerSecond() {
        choose(4);
        runOnEdt(() -> chart.view().setSpan(new TimeSpan(0, 20)));
        TraceLevel level = FRAME.recording().trace().finestLevel();
        int fastest = IntStream.range(0, 2000)
                .boxed()
                .max(Comparator.comparing(tick -> Math.abs(level.min(TraceChannels.TURN_RATE, tick))))
                .orElseThrow();
        double degrees = StrictMath.toDegrees(level.min(TraceChannels.TURN_RATE, fastest));
        assertEquals(-60, degrees, 1, "the robot spins right at its turn rate");
        Axis axis = callOnEdt(() -> chart.view().scale().orElseThrow().plot().vertical());
        assertEquals(degrees, axis.low(), 0.1);
        assertEquals(
                String.format(Locale.ROOT, "actual %.3f °/s", degrees),
                readOut(fastest / 100.0).get(1));
        choose(1);
        int controlled = IntStream.range(0, 2000)
                .filter(tick -> Float.isFinite(level.min(TraceChannels.PROPORTIONAL, tick)))
                .findFirst()
                .orElseThrow();
        String term = readOut(controlled / 100.0).get(1);
        assertTrue(term.endsWith(" rad/s"), term);
        assertEquals("P –", readOut(fastest / 100.0).get(1), "the robot spins");
    }

    @Test
    void aSensorThatIsOffReadsOutAsADash() {
        choose(5 + 4);
        assertEquals("reported –", readOut(15).get(2));
    }

    @Test
    void aFaultyReadingAndTheTrueOneStandSideBySide() {
        choose(5 + 5);
        assertEquals(
                List.of("reported 0.400 m"),
                readOut(15).stream().filter(line -> line.startsWith("reported")).toList());
    }

    @Test
    void theWheelZoomsOnTheMomentUnderThePointer() {
        runOnEdt(() -> chart.view().setFrozen(true));
        double x = x(13);
        runOnEdt(() -> chart.view()
                .dispatchEvent(new MouseWheelEvent(
                        chart.view(),
                        MouseEvent.MOUSE_WHEEL,
                        0,
                        0,
                        (int) Math.round(x),
                        50,
                        0,
                        false,
                        MouseWheelEvent.WHEEL_UNIT_SCROLL,
                        1,
                        -3)));
        TimeSpan span = chart.view().span();
        assertEquals(10 / 1.25 / 1.25 / 1.25, span.length(), 1e-9);
        assertEquals(13, span.timeAt(chart.view().shareAt(Math.round(x))), 0.02);
    }

    @Test
    void zoomedOutOverTheWholeRunItReadsOutRanges() {
        runOnEdt(() -> chart.view().setSpan(new TimeSpan(0, 400)));
        assertTrue(
                readOut(10).get(1).matches("distance used 0\\.\\d{3}( … 0\\.\\d{3})? m"),
                readOut(10).get(1));
    }

    @Test
    void arrowsGoThroughTimeAndEndRunsAlongAgain() {
        runOnEdt(() -> chart.view().getActionMap().get("LEFT").actionPerformed(null));
        assertEquals(19, chart.view().span().end(), 1e-9);
        assertTrue(callOnEdt(() -> ComponentFinder.find(chart, JToggleButton.class, "Hold the strip chart")
                .isSelected()));
        runOnEdt(() -> chart.view().getActionMap().get("END").actionPerformed(null));
        assertEquals(20, chart.view().span().end(), 1e-9);
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void bothLinesAreSeenInBothThemes(Theme theme) {
        long[] seen = callOnEdt(() -> {
            theme.install();
            StripChart fresh = new StripChart();
            fresh.setFrame(FRAME);
            var picture = SampleRuns.render(fresh, WIDTH, HEIGHT);
            SignalGroup signal =
                    SignalGroup.allOf(FRAME.snapshot().robot().sensorIds()).get(0);
            Theme.LIGHT.install();
            return signal.lines().stream()
                    .mapToLong(curve -> SampleRuns.count(picture, curve.colour().apply(theme)))
                    .toArray();
        });
        for (long pixels : seen) {
            assertTrue(pixels > 20, "only " + pixels + " pixels");
        }
    }

    @Test
    void aChangeOfTheControllerIsMarkedAtItsTime() {
        // The same settings again leave the lines as they are.
        SimulationSetup setup = SampleRuns.ROOM_SETUP.withTimeline(Stream.concat(
                        SampleRuns.ROOM_SETUP.timeline().stream(),
                        Stream.of(new SimulationSetup.TimedCommand(
                                16, new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT))))
                .toList());
        int[] columns = callOnEdt(() -> {
            StripChart fresh = new StripChart();
            fresh.setFrame(FRAME);
            BufferedImage before = SampleRuns.render(fresh, WIDTH, HEIGHT);
            fresh.setFrame(SampleRuns.frame(setup, 2000));
            BufferedImage after = SampleRuns.render(fresh, WIDTH, HEIGHT);
            return IntStream.range(0, WIDTH)
                    .filter(x -> IntStream.range(0, HEIGHT).anyMatch(y -> before.getRGB(x, y) != after.getRGB(x, y)))
                    .toArray();
        });
        assertTrue(columns.length >= 1 && columns.length <= 3, columns.length + " columns");
        int expected = callOnEdt(() -> (int) x(16) + chart.view().getX());
        assertEquals(expected, columns[0], 2);
    }

    @Test
    void whereNothingIsMeasuredTheAxisStillHasAScale() {
        StripScale scale = content(
                        SampleRuns.frame(SampleRuns.setup(new ControllerSpec.None()), 100),
                        TimeSpan.DEFAULT,
                        ValueRange.FROM_ZERO)
                .scale(WIDTH, HEIGHT, false);
        assertTrue(scale.isEmpty());
        assertEquals(1, scale.plot().vertical().high());
    }

    private static StripContent content(SessionFrame frame, TimeSpan span, ValueRange range) {
        SignalGroup distance =
                SignalGroup.allOf(FRAME.snapshot().robot().sensorIds()).get(0);
        return new StripContent(frame, distance, span, range, List.of(), null);
    }

    @Test
    void aRunWithoutATickIsATableOfItsStart() {
        runOnEdt(() -> {
            StripChart fresh = new StripChart();
            SampleRuns.render(fresh, WIDTH, HEIGHT);
            assertEquals(Optional.empty(), fresh.content());
            fresh.setFrame(SampleRuns.frame(0));
            SampleRuns.render(fresh, WIDTH, HEIGHT);
            List<String> table = fresh.content().orElseThrow().toCsv().lines().toList();
            assertEquals(2, table.size(), table::toString);
            assertTrue(table.get(1).startsWith("0,"), table::toString);
        });
    }

    @Test
    void theVerticalAxisFitsTheValuesOnRequest() {
        TimeSpan span = TimeSpan.DEFAULT.endingAt(FRAME.snapshot().time());
        StripScale fromZero = content(FRAME, span, ValueRange.FROM_ZERO).scale(400, 200, false);
        StripScale fitted = content(FRAME, span, ValueRange.FITTED).scale(400, 200, false);
        assertEquals(0, fromZero.plot().vertical().low());
        assertTrue(fitted.plot().vertical().low() > 0.1);
    }

    @Test
    void theLabelsOfTheVerticalAxisDifferHoweverFarItIsZoomedAndMoved() {
        for (double factor : new double[] {1.25, 0.8}) {
            ValueRange range = ValueRange.fixed(0, 1);
            for (int notch = 0; notch < 400; notch++) {
                range = ValueRange.zoomed(range.axis("m", new double[0]), factor, 0.5);
            }
            Axis centred = range.axis("m", new double[0]);
            double expected = factor > 1 ? 0 : 0.5;
            assertEquals(expected, centred.valueAt(0.5), 1e-9, "at the limit, the value at the pointer stays");
            for (double to : new double[] {-1e12, 1e12}) {
                List<String> labels = ValueRange.moved(centred, to).axis("m", new double[0]).ticks().stream()
                        .map(Axis::formatTick)
                        .toList();
                assertTrue(labels.size() > 1, labels.toString());
                assertEquals(labels.size(), Set.copyOf(labels).size(), labels.toString());
                assertTrue(labels.stream().allMatch(label -> label.length() <= 14), labels.toString());
            }
        }
    }

    @Test
    void theLabelsOfAConstantAreShortAndThoseOfADeepZoomFitBesideThePlot() {
        double[] constant = {0.25, 0.25};
        List<String> labels = ValueRange.FITTED.axis("m", constant).ticks().stream()
                .map(Axis::formatTick)
                .toList();
        assertTrue(labels.stream().allMatch(label -> label.length() <= 6), labels.toString());
        TimeSpan span = new TimeSpan(10, 10);
        StripScale scale = content(FRAME, span, ValueRange.fixed(0.25, 0.25001)).scale(400, 200, false);
        TextStyle style = TextStyle.plain(StripScale.FONT_SIZE, Color.BLACK);
        scale.plot().vertical().ticks().forEach(tick -> {
            double width = style.estimateWidth(Axis.formatTick(tick));
            assertTrue(width < scale.plot().area().x(), Axis.formatTick(tick) + " is " + width + " pixels wide");
        });
    }

    @Test
    void noLineCanBeAddedIfNoneHasTheSameUnit() {
        JButton add = callOnEdt(() -> ComponentFinder.find(chart, JButton.class, "Add signals"));
        for (int signal = 0; signal < 6; signal++) {
            choose(signal);
            boolean some = callOnEdt(() -> chart.createAdditionsMenu().getComponentCount() > 0);
            assertEquals(some, callOnEdt(add::isEnabled), "signal " + signal);
        }
    }

    @Test
    void aHeldChartIsReleasedForAnotherScenario() {
        InstrumentDock dock = callOnEdt(() -> new InstrumentDock(tick -> {}));
        runOnEdt(() -> {
            JToggleButton hold = ComponentFinder.find(dock, JToggleButton.class, "Hold the strip chart");
            hold.doClick();
            assertTrue(hold.isSelected());
            dock.startScenario();
            assertFalse(hold.isSelected());
        });
    }

    @Test
    void framesAreShownOnTheEventDispatchThreadOnly() {
        assertThrows(AssertionError.class, () -> chart.setFrame(FRAME));
    }
}
