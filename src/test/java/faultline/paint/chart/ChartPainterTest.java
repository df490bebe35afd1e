package faultline.paint.chart;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.SvgSurface;
import faultline.paint.surface.SvgTheme;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Charts: nice ticks, lines clipped at the frame, and the same picture on both kinds of surface. */
class ChartPainterTest {

    @Test
    void ticksAreNiceAndCoverTheAxis() {
        assertEquals(
                List.of("0", "0.2", "0.4", "0.6", "0.8", "1"),
                Axis.linear("", 0, 1).ticks().stream().map(Axis::formatTick).toList());
        assertEquals(
                List.of("1", "2", "5", "10", "20", "50", "100"),
                new Axis("", 1, 100, true)
                        .ticks().stream().map(Axis::formatTick).toList());
        assertEquals(
                List.of("\u221210", "\u22125", "0", "5"),
                Axis.linear("", -12, 8).ticks().stream()
                        .map(Axis::formatTick)
                        .filter(name -> !name.isEmpty())
                        .toList());
    }

    @Test
    void ticksOfARunOfDaysHaveAllTheirDigits() {
        assertEquals(
                List.of(
                        "1576100", "1576101", "1576102", "1576103", "1576104", "1576105", "1576106", "1576107",
                        "1576108"),
                Axis.linear("", 1_576_100, 1_576_108).ticks().stream()
                        .map(Axis::formatTick)
                        .toList());
    }

    @Test
    void labelsWithoutRoomAreLeftOutAndStayAtTheirValues() {
        assertEquals(List.of("0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8"), labels(0, 0.8, 88));
        assertEquals(List.of("0", "0.2", "0.4", "0.6", "0.8"), labels(0, 0.8, 70));
        assertEquals(List.of("0.2", "0.4", "0.6", "0.8"), labels(0.1, 0.9, 70));
        assertEquals(List.of("0"), labels(0, 0.8, 3));
        assertEquals(1, new Axis("", 1, 100, true).labelStride(10, 11));
    }

    private static List<String> labels(double low, double high, double length) {
        Axis axis = Axis.linear("", low, high);
        int stride = axis.labelStride(length, 11);
        return axis.ticks().stream()
                .filter(tick -> axis.hasLabel(tick, stride))
                .map(Axis::formatTick)
                .toList();
    }

    @Test
    void anAxisCoversAllValuesAndEndsAtNiceOnes() {
        Axis axis = Axis.covering("", DoubleStream.of(0.13, 7.9, Double.NaN));
        assertEquals(0, axis.low());
        assertEquals(8, axis.high());
    }

    @Test
    void anAxisOfRowsHasALabelInTheMiddleOfEach() {
        Axis axis = Axis.rows(List.of("lower", "upper"));
        assertEquals(List.of(0.0, 1.0), axis.ticks());
        assertEquals("upper", axis.tickLabel(1));
        assertEquals(0.75, axis.fractionOf(1));
    }

    @Test
    void anAxisOfEqualValuesHasReadableTicks() {
        Axis axis = Axis.covering("", DoubleStream.of(7.3, 7.3), 0.001);
        assertTrue(axis.low() <= 7.299 && axis.high() >= 7.3, axis::toString);
        axis.ticks().forEach(tick -> assertTrue(Axis.formatTick(tick).length() <= 6, axis::toString));
    }

    @Test
    void aHistogramCountsEveryValueOnce() {
        double[] values = {0, 0.05, 0.1, 0.5, 0.95, 1, 1};
        long[] counts = Histogram.counts(Axis.linear("", 0, 1), values);
        assertArrayEquals(new long[] {3, 0, 1, 0, 3}, counts);
    }

    /** The bars of five values from 0 to 10, of which four are in the first and one in the last of five bars. */
    @Test
    void theBarsOfAHistogramAreAsHighAsTheirCountsAndTouch() {
        Chart chart = Histogram.chart("", "time (s)", "runs", new double[] {0, 0.5, 1, 1.5, 10});
        assertEquals(0, chart.x().low());
        assertEquals(10, chart.x().high());
        List<Vector2> upper = ((Series.Band) chart.series().get(0)).upper();
        for (int bar = 0; bar < 5; bar++) {
            int count = bar == 0 ? 4 : bar == 4 ? 1 : 0;
            assertEquals(new Vector2(2.0 * bar, count), upper.get(2 * bar));
            assertEquals(new Vector2(2.0 * (bar + 1), count), upper.get(2 * bar + 1));
        }
    }

    @Test
    void theOutlineOfAHistogramBeginsAndEndsAtZero() {
        Chart chart = Histogram.chart("", "time (s)", "runs", new double[] {0, 10});
        List<Vector2> outline = ((Series.Line) chart.series().get(1)).points();
        assertEquals(List.of(new Vector2(0, 0), new Vector2(0, 1)), outline.subList(0, 2));
        assertEquals(List.of(new Vector2(10, 1), new Vector2(10, 0)), outline.subList(10, 12));
    }

    /** There are twice as many bars as the cube root of the number of values, rounded up, from 5 to 40. */
    @ParameterizedTest
    @CsvSource({"0, 5", "8, 5", "9, 5", "30, 7", "900, 20", "7900, 40", "100000, 40"})
    void aHistogramOfMoreValuesHasMoreBars(int values, int bars) {
        assertEquals(bars, Histogram.counts(Axis.linear("", 0, 1), new double[values]).length);
    }

    /** Of values that hardly differ, a twentieth of the greatest is shown, or 0.001. */
    @ParameterizedTest
    @CsvSource({"100, 95, 100", "-100, -105, -100", "0, 0, 0.001"})
    void aHistogramOfEqualValuesIsNotTooNarrow(double value, double low, double high) {
        Axis x = Histogram.chart("", "", "", new double[] {value, value}).x();
        assertEquals(low, x.low(), 1e-12);
        assertEquals(high, x.high(), 1e-12);
    }

    @Test
    void theFirstSixteenSeriesDifferInColourOrDashes() {
        assertEquals(
                16,
                IntStream.range(0, 16)
                        .mapToObj(ChartStyle.LIGHT::lineStyle)
                        .distinct()
                        .count());
    }

    @Test
    void aLiteralTextKeepsItsUnderscoresAndIsNoMarkup() {
        SvgSurface surface = new SvgSurface(10, 10);
        String name = "_my__speed_m fill=\"#123456\" </svg>";
        surface.drawText(TextStyle.literal(name), Vector2.ZERO, TextStyle.plain(12, Color.BLACK));
        assertTrue(
                surface.toSvg().contains(">_my__speed_m fill=&quot;#123456&quot; &lt;/svg&gt;</text>"), surface::toSvg);
    }

    @Test
    void anAxisWithoutLengthIsRejected() {
        assertThrows(IllegalArgumentException.class, () -> Axis.linear("", 1, 1));
        assertThrows(IllegalArgumentException.class, () -> new Axis("", 0, 1, true));
    }

    @Test
    void aLineIsClippedWhereItLeavesTheFrame() {
        List<List<Vector2>> pieces =
                LineClipper.clip(List.of(new Vector2(0, 0.5), new Vector2(0.5, 1.5), new Vector2(1, 0.5)));
        assertEquals(
                List.of(
                        List.of(new Vector2(0, 0.5), new Vector2(0.25, 1)),
                        List.of(new Vector2(0.75, 1), new Vector2(1, 0.5))),
                pieces);
    }

    @ParameterizedTest
    @CsvSource({"3, 0.5, 1, 0.5", "-3, 0.5, 0, 0.5", "0.5, 3, 0.5, 1", "0.5, -3, 0.5, 0"})
    void aLineEndsAtEachSideOfTheFrame(double x, double y, double endX, double endY) {
        Vector2 middle = new Vector2(0.5, 0.5);
        Vector2 outside = new Vector2(x, y);
        Vector2 end = new Vector2(endX, endY);
        assertEquals(List.of(List.of(middle, end)), LineClipper.clip(List.of(middle, outside)));
        assertEquals(List.of(List.of(end, middle)), LineClipper.clip(List.of(outside, middle)));
    }

    @Test
    void aLineThatOnlyTouchesACornerOfTheFrameIsNotDrawn() {
        assertEquals(List.of(), LineClipper.clip(List.of(new Vector2(-0.5, 0.5), new Vector2(0.5, 1.5))));
        assertEquals(List.of(), LineClipper.clip(List.of(new Vector2(-1, 1), new Vector2(-1, 0))));
    }

    @Test
    void aGapInTheDataIsAGapInTheLine() {
        List<Vector2> line = List.of(
                new Vector2(0, 0),
                new Vector2(0.2, 0),
                new Vector2(0.4, Double.NaN),
                new Vector2(0.6, 0),
                new Vector2(0.8, 0));
        assertEquals(2, LineClipper.clip(line).size());
    }

    @Test
    void reservedCharactersAreEscaped() {
        SvgSurface surface = new SvgSurface(10, 10, Color.WHITE);
        surface.drawText("a < b & c > d", Vector2.ZERO, TextStyle.plain(10, Color.BLACK));
        assertTrue(
                surface.toSvg(SvgTheme.LIGHT).contains(">a &lt; b &amp; c &gt; d</text>"),
                surface.toSvg(SvgTheme.LIGHT));
    }

    @Test
    void aSubscriptIsLoweredAndTheLineContinues() {
        SvgSurface surface = new SvgSurface(10, 10, Color.WHITE);
        surface.drawText("t_D = 1", Vector2.ZERO, TextStyle.plain(12, Color.BLACK));
        assertTrue(
                surface.toSvg(SvgTheme.LIGHT)
                        .contains(">t<tspan dy=\"3\" font-size=\"9\">D</tspan><tspan dy=\"-3\" "
                                + "dx=\"3.84\">= 1</tspan></text>"),
                surface.toSvg(SvgTheme.LIGHT));
    }

    @Test
    void aLongLastLabelIsNotCutOff() {
        SvgSurface surface = new SvgSurface(462, 200);
        Chart chart = new Chart("", Axis.linear("", 1_576_100, 1_576_108), Axis.linear("", 0, 1), List.of());
        ChartPainter.paint(surface, chart, new PixelRectangle(0, 0, 462, 200), ChartStyle.LIGHT);
        Matcher last =
                Pattern.compile("<text x=\"([0-9.]+)\"[^>]*>1576108</text>").matcher(surface.toSvg());
        assertTrue(last.find(), surface::toSvg);
        double right = Double.parseDouble(last.group(1))
                + TextStyle.plain(11, Color.BLACK).estimateWidth("1576108") / 2;
        assertTrue(right <= 462, () -> "it ends at " + right);
    }

    @Test
    void theFileIsTheSameInEveryLanguage() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.ROOT);
            String root = file();
            Locale.setDefault(Locale.forLanguageTag("ar-EG"));
            assertEquals(root, file());
        } finally {
            Locale.setDefault(before);
        }
    }

    private static String file() {
        SvgSurface surface = new SvgSurface(300, 200, Color.WHITE);
        ChartPainter.paint(surface, chart(), new PixelRectangle(0, 0, 300, 200), ChartStyle.LIGHT);
        return surface.toSvg(SvgTheme.LIGHT);
    }

    private static Chart chart() {
        List<Vector2> points = List.of(new Vector2(0, 0), new Vector2(0.5, 1), new Vector2(1, 0.25));
        return new Chart(
                "Title",
                Axis.linear("x (m)", 0, 1),
                Axis.linear("y (m)", 0, 1),
                List.of(
                        new Series.Cells(List.of("one", "two"), List.of(List.of(0, 1))),
                        new Series.Band("band", points, List.of(new Vector2(0, 0), new Vector2(1, 0)), 0),
                        new Series.Line("line", points, 1),
                        new Series.Points("points", points, 2),
                        new Series.Note("note", new Vector2(0.1, 0.9))));
    }

    @Test
    void aChartIsPaintedInBothThemes() {
        for (ChartStyle theme : List.of(ChartStyle.LIGHT, ChartStyle.DARK)) {
            BufferedImage image = new BufferedImage(300, 200, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            graphics.setColor(theme.palette().canvas());
            graphics.fillRect(0, 0, 300, 200);
            ChartPainter.paint(new GraphicsSurface(graphics), chart(), new PixelRectangle(0, 0, 300, 200), theme);
            graphics.dispose();
            // The right half of the plot is the second class, under all else.
            assertEquals(theme.classes().get(1).getRGB(), image.getRGB(275, 100));
        }
    }
}
