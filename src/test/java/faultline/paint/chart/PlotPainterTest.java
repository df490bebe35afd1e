package faultline.paint.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.RecordingSurface;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** Where charts draw their lines, texts and samples. */
class PlotPainterTest {

    private static final ChartStyle STYLE = ChartStyle.LIGHT;
    private static final TextStyle TEXT = TextStyle.plain(10, Color.BLACK);

    /** Values from 0 to 2 are 100 pixels apart, and from 0 to 1 upwards. */
    private static final Plot PLOT =
            new Plot(new PixelRectangle(100, 10, 200, 100), Axis.linear("", 0, 2), Axis.linear("", 0, 1));

    private final RecordingSurface drawn = new RecordingSurface();
    private final PlotPainter painter = new PlotPainter(drawn, PLOT);

    private List<String> texts(String start) {
        return drawn.texts().stream().filter(text -> text.startsWith(start)).toList();
    }

    @Test
    void theGridHasALineAtEachTickOfBothAxes() {
        painter.paintGrid(LineStyle.solid(Color.GRAY, 1));
        assertEquals(
                List.of(
                        "100.0,110.0 100.0,10.0",
                        "150.0,110.0 150.0,10.0",
                        "200.0,110.0 200.0,10.0",
                        "250.0,110.0 250.0,10.0",
                        "300.0,110.0 300.0,10.0",
                        "100.0,110.0 300.0,110.0",
                        "100.0,90.0 300.0,90.0",
                        "100.0,70.0 300.0,70.0",
                        "100.0,50.0 300.0,50.0",
                        "100.0,30.0 300.0,30.0",
                        "100.0,10.0 300.0,10.0"),
                drawn.shapes());
    }

    @Test
    void ticksHaveMarksOutsideThePlotAndLabelsBesideThem() {
        painter.paintTicks(new TickStyle(TEXT, 4, 8, 17, "s"));
        assertEquals(List.of("0.5s at 150.0,127.0 MIDDLE"), texts("0.5"));
        assertEquals(List.of("0.2 at 92.0,94.0 END"), texts("0.2"));
        assertEquals(5 + 6, drawn.texts().size());
        assertTrue(drawn.shapes().contains("150.0,110.0 150.0,114.0"), drawn.shapes()::toString);
        assertTrue(drawn.shapes().contains("100.0,90.0 96.0,90.0"), drawn.shapes()::toString);
        assertEquals(5 + 6, drawn.shapes().size());
    }

    @Test
    void ticksWithoutMarksHaveOnlyLabels() {
        painter.paintTicks(new TickStyle(TEXT, 0, 8, 17, ""));
        assertEquals(List.of(), drawn.shapes());
    }

    @Test
    void labelsForWhichThereIsNoRoomAreOmittedOnBothAxes() {
        Plot narrow = new Plot(new PixelRectangle(0, 0, 40, 25), Axis.linear("", 0, 2), Axis.linear("", 0, 1));
        new PlotPainter(drawn, narrow).paintTicks(new TickStyle(TEXT, 4, 8, 17, ""));
        // "0.5" is 15.6 pixels wide, for 10 between two ticks; a line is 10 pixels high, for 5 between two ticks.
        assertEquals(
                List.of("0 at 0.0,42.0 MIDDLE", "1 at 20.0,42.0 MIDDLE", "2 at 40.0,42.0 MIDDLE"),
                drawn.texts().subList(0, 3));
        assertEquals(
                List.of("0 at -8.0,29.0 END", "0.4 at -8.0,19.0 END", "0.8 at -8.0,9.0 END"),
                drawn.texts().subList(3, 6));
        assertEquals(6, drawn.texts().size());
    }

    @Test
    void aLineIsDrawnOnlyInThePlot() {
        painter.paintLine(
                List.of(new Vector2(0, 0.5), new Vector2(1, 0.5), new Vector2(1, 3)), LineStyle.solid(Color.RED, 1));
        assertEquals(List.of("100.0,60.0 200.0,60.0 200.0,10.0"), drawn.shapes());
    }

    @Test
    void aBandLiesBetweenItsLinesAndEndsAtThePlot() {
        painter.paintBand(
                List.of(new Vector2(0, 1), new Vector2(2, 0.9)),
                List.of(new Vector2(0, 0.5), new Vector2(2, -1)),
                Color.RED);
        assertEquals(List.of("fill 100.0,10.0 300.0,20.0 300.0,110.0 100.0,60.0 closed"), drawn.shapes());
    }

    @Test
    void pointsOutsideThePlotHaveNoMarkers() {
        List<Vector2> points = List.of(
                new Vector2(1, 0.5),
                new Vector2(2, 1),
                new Vector2(2.01, 1),
                new Vector2(1, -0.01),
                new Vector2(Double.NaN, 0.5));
        painter.paintMarkers(points, 1, STYLE);
        assertEquals(
                List.of(
                        "197.0,57.0 203.0,57.0 203.0,63.0 197.0,63.0 closed",
                        "297.0,7.0 303.0,7.0 303.0,13.0 297.0,13.0 closed"),
                drawn.shapes());
    }

    @Test
    void fourMarkersDifferInTheirShapesAroundThePoint() {
        List<String> markers = new ArrayList<>();
        for (int index = 0; index < 8; index++) {
            drawn.clear();
            MarkerPainter.paint(drawn, new Vector2(50, 50), index, STYLE);
            markers.add(String.join(" and ", drawn.shapes()));
        }
        assertEquals(markers.subList(0, 4), markers.subList(4, 8));
        assertEquals(4, new HashSet<>(markers).size());
        assertTrue(markers.get(0).startsWith("fill 52.7,50.0 "), markers.get(0));
        assertEquals("50.0,46.0 53.6,53.0 46.4,53.0 closed", markers.get(2));
        assertEquals("47.0,47.0 53.0,53.0 and 47.0,53.0 53.0,47.0", markers.get(3));
    }

    @Test
    void aMapHasItsFirstRowBelow() {
        Series.Cells cells = new Series.Cells(List.of("good", "bad"), List.of(List.of(0, 1), List.of(1, 1)));
        new SeriesPainter(painter, STYLE).paint(cells);
        assertEquals(
                List.of(
                        "fill 100.0,110.0 200.0,110.0 200.0,60.0 100.0,60.0 closed",
                        "fill 200.0,110.0 300.0,110.0 300.0,60.0 200.0,60.0 closed",
                        "fill 100.0,60.0 200.0,60.0 200.0,10.0 100.0,10.0 closed",
                        "fill 200.0,60.0 300.0,60.0 300.0,10.0 200.0,10.0 closed"),
                drawn.shapes());
    }

    /** The plot is 62 pixels from the left, 16 from the right, 46 from below, and below title and legend. */
    @Test
    void aChartHasItsTitleLegendFrameAndLabelsInTheirPlaces() {
        Chart chart = new Chart(
                "title",
                Axis.linear("across", 0, 2),
                Axis.linear("up", 0, 1),
                List.of(
                        new Series.Line("line", List.of(new Vector2(0, 0), new Vector2(2, 1)), 0),
                        new Series.Points("points", List.of(new Vector2(1, 0)), 2),
                        new Series.Line("", List.of(new Vector2(0, 1), new Vector2(2, 1)), 1),
                        new Series.Note("note", new Vector2(1, 1))));
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 400, 300), STYLE);
        assertEquals(List.of("title at 62.0,17.0 START"), texts("title"));
        assertEquals(List.of("across at 223.0,290.0 MIDDLE"), texts("across"));
        assertEquals(List.of("up at 14.0,150.0 MIDDLE up"), texts("up"));
        assertEquals(List.of("note at 223.0,46.0 START"), texts("note"), "20 pixels for the legend");
        assertTrue(drawn.shapes().contains("62.0,254.0 384.0,254.0 384.0,46.0 62.0,46.0 closed"));
        assertTrue(drawn.shapes().contains("62.0,254.0 384.0,46.0"), "the line");
        assertTrue(drawn.shapes().contains("62.0,32.0 88.0,32.0"), "its sample");
        double points = 62 + 26 + 5 + TextStyle.plain(11, Color.BLACK).estimateWidth("line") + 14;
        assertEquals(List.of("line at 93.0,36.0 START"), texts("line"));
        assertEquals(List.of("points at " + Math.round((points + 31) * 10) / 10.0 + ",36.0 START"), texts("points"));
    }

    @Test
    void aChartOfRowsHasRoomForTheirNamesAndALineAtZero() {
        Chart chart = new Chart("", Axis.linear("", -1, 1), Axis.rows(List.of("long name", "b")), List.of());
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 400, 300), STYLE);
        double left = 16 + TextStyle.plain(11, Color.BLACK).estimateWidth("long name");
        assertEquals(left, ChartPainter.leftMargin(List.of("b", "long name")));
        String zero = tenths((left + 384) / 2) + ",";
        assertEquals(
                List.of(zero + "254.0 " + zero + "10.0"), shapes(STYLE.palette().muted()));
        assertEquals(1, texts("long name").size());
    }

    private static String tenths(double number) {
        return Double.toString(Math.round(number * 10) / 10.0);
    }

    private List<String> shapes(Color colour) {
        return drawn.shapes(colour).stream()
                .map(RecordingSurface.DrawnShape::toString)
                .toList();
    }

    /** Returns the frame of a chart, the last polygon of its text colour. */
    private Rectangle2D frame() {
        List<RecordingSurface.DrawnShape> closed = drawn.shapes(STYLE.palette().text()).stream()
                .filter(shape -> shape.toString().endsWith("closed"))
                .toList();
        return closed.get(closed.size() - 1).shape().getBounds2D();
    }

    @Test
    void aChartOfNumbersHasAGridAndNoLineAtZero() {
        Chart chart = new Chart("", Axis.linear("", -1, 1), Axis.linear("", -1, 1), List.of());
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 400, 300), STYLE);
        assertEquals(List.of(), shapes(STYLE.palette().muted()));
        List<String> grid = shapes(STYLE.grid());
        assertEquals(5 + 5, grid.size(), "at every half");
        assertEquals("62.0,254.0 62.0,10.0", grid.get(0));
        assertEquals("62.0,132.0 384.0,132.0", grid.get(5 + 2));
    }

    /** The label has twelve digits, and its tick is 0.1 of 8.1 before the end of the axis, which is 322 pixels long. */
    @Test
    void thePlotEndsWhereHalfOfTheLastLabelHasRoomBesideIt() {
        double start = 100_000_000_000.0;
        Chart chart = new Chart("", Axis.linear("", start, start + 8.1), Axis.linear("", 0, 1), List.of());
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 400, 300), STYLE);
        double half = TextStyle.plain(11, Color.BLACK).estimateWidth("100000000008") / 2;
        assertTrue(half > 30, () -> "more than the usual margin: " + half);
        assertEquals(400 - (half - 322 * 0.1 / 8.1), frame().getMaxX(), 0.01);
    }

    @Test
    void theLegendOfAChartIsAsWideAsItsPlot() {
        List<Series> lines =
                List.of(new Series.Line("first name", List.of(), 0), new Series.Line("other name", List.of(), 1));
        TextStyle text = TextStyle.plain(11, Color.BLACK);
        double needed = 31 + text.estimateWidth("first name") + 14 + 31 + text.estimateWidth("other name");
        Chart chart = new Chart("", Axis.linear("", 0, 1), Axis.linear("", 0, 1), lines);
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 62 + needed + 0.5 + 16, 300), STYLE);
        assertEquals(10 + 16 + 4, frame().getMinY(), 1e-9, "one row");
        drawn.clear();
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 62 + needed - 0.5 + 16, 300), STYLE);
        assertEquals(10 + 2 * 16 + 4, frame().getMinY(), 1e-9, "two rows");
    }

    /** The middle of the legend is at 16, and a sample is 26 pixels wide and 10 high. */
    @Test
    void everyKindOfSeriesIsDrawnAndHasASampleInItsColour() {
        Chart chart = new Chart(
                "",
                Axis.linear("", 0, 2),
                Axis.linear("", 0, 1),
                List.of(
                        new Series.Cells(List.of("one", "two"), List.of(List.of(0, 1))),
                        new Series.Band(
                                "band",
                                List.of(new Vector2(0, 1), new Vector2(2, 1)),
                                List.of(new Vector2(0, 0.5), new Vector2(2, 0.5)),
                                1),
                        new Series.Points("points", List.of(new Vector2(1, 0.5)), 2)));
        ChartPainter.paint(drawn, chart, new PixelRectangle(0, 0, 400, 300), STYLE);
        TextStyle text = TextStyle.plain(11, Color.BLACK);
        double two = 62 + 31 + text.estimateWidth("one") + 14;
        double band = two + 31 + text.estimateWidth("two") + 14;
        double points = band + 31 + text.estimateWidth("band") + 14;
        assertEquals(
                List.of(sample(62), "fill 62.0,254.0 223.0,254.0 223.0,30.0 62.0,30.0 closed"),
                shapes(STYLE.classes().get(0)));
        assertEquals(
                List.of(sample(two), "fill 223.0,254.0 384.0,254.0 384.0,30.0 223.0,30.0 closed"),
                shapes(STYLE.classes().get(1)));
        assertTrue(shapes(STYLE.palette().text()).contains(sample(two).replace("fill ", "")), "its border");
        assertEquals(
                List.of(sample(band), "fill 62.0,30.0 384.0,30.0 384.0,142.0 62.0,142.0 closed"),
                shapes(ChartStyle.withOpacity(STYLE.series(1), 0.2)));
        assertEquals(List.of(triangle(points + 13, 16), triangle(223, 142)), shapes(STYLE.series(2)));
    }

    private static String sample(double left) {
        String from = tenths(left) + ",";
        String to = tenths(left + 26) + ",";
        return "fill " + from + "11.0 " + to + "11.0 " + to + "21.0 " + from + "21.0 closed";
    }

    private static String triangle(double x, double y) {
        return tenths(x) + "," + tenths(y - 4) + " " + tenths(x + 3.6) + "," + tenths(y + 3) + " " + tenths(x - 3.6)
                + "," + tenths(y + 3) + " closed";
    }

    @Test
    void theRowsOfALegendAreOneBelowTheOther() {
        List<Vector2> samples = new ArrayList<>();
        LegendRows.of(List.of("a", "b", "c"), name -> name, name -> 10, 96)
                .paint(
                        drawn,
                        TextStyle.plain(11, Color.BLACK),
                        new Vector2(5, 7),
                        16,
                        (name, left) -> samples.add(left));
        assertEquals(List.of(new Vector2(5, 15), new Vector2(60, 15), new Vector2(5, 31)), samples);
        assertEquals(List.of("a at 36.0,19.0 START", "b at 91.0,19.0 START", "c at 36.0,35.0 START"), drawn.texts());
    }

    @Test
    void aLegendIsBrokenWhereTheNextEntryDoesNotFit() {
        List<String> names = List.of("a", "b", "c");
        LegendRows<String> rows = LegendRows.of(names, name -> name, name -> 10, 96);
        assertEquals(List.of(List.of("a", "b"), List.of("c")), rows.rows(), "31 pixels and a name, twice, and a gap");
        assertEquals(96, rows.width());
        assertEquals(List.of(List.of("a", "b")), rows.first(1).rows());
        assertEquals(rows, rows.first(5));
        assertEquals(
                3, LegendRows.of(names, name -> name, name -> 10, 95.9).rows().size());
    }

    @Test
    void theValueAtAPositionIsTheOneThatIsThere() {
        assertEquals(3, Axis.linear("", 2, 6).valueAt(0.25));
        Axis logarithmic = new Axis("", 10, 1000, true);
        assertEquals(100, logarithmic.valueAt(0.5), 1e-9);
        assertEquals(0.5, logarithmic.fractionOf(100), 1e-12);
    }

    @Test
    void anAxisOfBothSignsEndsAtNiceValues() {
        Axis axis = Axis.covering("", DoubleStream.of(-30, 50.5));
        assertEquals(-40, axis.low(), "in steps of 20, at most eight");
        assertEquals(60, axis.high());
    }
}
