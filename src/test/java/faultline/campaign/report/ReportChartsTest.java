package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The places of dots and intervals in the charts of a report, as shares of the frame from its lower left corner. */
class ReportChartsTest {

    private static final Pattern FRAME =
            Pattern.compile("d=\"M([\\d.]+) ([\\d.]+)L([\\d.]+) [\\d.]+L[\\d.]+ ([\\d.]+)L");
    static final Pattern DOT = Pattern.compile("<circle cx=\"([\\d.]+)\" cy=\"([\\d.]+)\"");
    private static final Pattern INTERVAL =
            Pattern.compile("d=\"M([\\d.]+) ([\\d.]+)L([\\d.]+) ([\\d.]+)\" fill=\"none\" [^>]* stroke-width=\"1.8\"");

    private static double[] numbers(MatchResult found) {
        return IntStream.rangeClosed(1, found.groupCount())
                .mapToDouble(group -> Double.parseDouble(found.group(group)))
                .toArray();
    }

    /** Asserts the x and y coordinates that a pattern finds in a chart. */
    static void assertPlaces(String svg, Pattern pattern, double... expected) {
        double[] frame = FRAME.matcher(svg)
                .results()
                .map(ReportChartsTest::numbers)
                .findFirst()
                .orElseThrow();
        double[] pixels = pattern.matcher(svg)
                .results()
                .flatMapToDouble(found -> Arrays.stream(numbers(found)))
                .toArray();
        double[] places = IntStream.range(0, pixels.length)
                .mapToDouble(i -> (pixels[i] - frame[i % 2]) / (frame[2 + i % 2] - frame[i % 2]))
                .toArray();
        assertArrayEquals(expected, places, 0.001, () -> Arrays.toString(places));
    }

    /** The axes are from 20 to 30 and from 0 to 100 %. */
    @Test
    void sharesAreAtTheirPositionsWithTheirIntervals() {
        String svg = ReportCharts.shares(
                "title",
                "label",
                20,
                30,
                List.of(
                        new ReportCharts.Estimate(21, 0.25, new Interval(0.2, 0.5)),
                        new ReportCharts.Estimate(28, 1, new Interval(0.6, 1))));
        assertPlaces(svg, DOT, 0.1, 0.25, 0.8, 1);
        assertPlaces(svg, INTERVAL, 0.1, 0.2, 0.1, 0.5, 0.8, 0.6, 0.8, 1);
    }

    /** The axis is from -50 to 50 percentage points, and there are two rows of equal height. */
    @Test
    void differencesAreInTheRowsOfTheirNamesFromTheTop() {
        String svg = ReportCharts.differences(
                "title",
                List.of("first", "second"),
                List.of(
                        new Comparison.Difference(0.2, new Interval(-0.1, 0.5), 9),
                        new Comparison.Difference(-0.3, new Interval(-0.4, -0.2), 9)));
        assertPlaces(svg, DOT, 0.7, 0.75, 0.2, 0.25);
        assertPlaces(svg, INTERVAL, 0.4, 0.75, 1, 0.75, 0.1, 0.25, 0.3, 0.25);
        assertTrue(Pattern.compile(" y=\"24\"[^>]*>first<").matcher(svg).find(), svg);
        assertTrue(Pattern.compile(" y=\"44\"[^>]*>second<").matcher(svg).find(), svg);
    }

    /** A share of 0 is at 2 and one of 1 at 62 pixels. */
    @Test
    void aBarShowsAShareAndItsInterval() {
        String svg = ReportCharts.intervalBar(new Survival(1, 4, new Interval(0.1, 0.75)));
        List<String> lines = Pattern.compile("d=\"(M[^\"]*)\"")
                .matcher(svg)
                .results()
                .map(found -> found.group(1))
                .toList();
        assertEquals(List.of("M2 4L62 4", "M8 4L47 4"), lines);
        assertTrue(svg.contains("<circle cx=\"17\" cy=\"4\""), svg);
    }

    @Test
    void theFrameOfRowsIsAsWideWhateverTheLengthOfTheirNames() {
        for (String name : List.of("a", "a long name of a group")) {
            String svg = ReportCharts.differences(
                    "title", List.of(name), List.of(new Comparison.Difference(0, new Interval(-0.1, 0.1), 9)));
            double[] frame = FRAME.matcher(svg)
                    .results()
                    .map(ReportChartsTest::numbers)
                    .findFirst()
                    .orElseThrow();
            assertEquals(440 - 16, frame[2] - frame[0], 1, svg);
        }
    }
}
