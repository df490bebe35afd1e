package faultline.campaign.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.RobotPath;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ComparisonChartTest {

    private static final SimulationSetup ROOM =
            SimulationSetup.of(new WorldSpec(3, 2, true, 0, List.of()), new Pose(0.6, 1.2, 0));

    /** The start and the end along the axis of the bar of an interval, and of the frame of the chart. */
    private static final Pattern BAR =
            Pattern.compile("<path d=\"M([\\d.]+) [\\d.]+L([\\d.]+) [^\"]*\" fill=\"#0b4f79\" fill-opacity");

    private static final Pattern FRAME =
            Pattern.compile("<path d=\"M([\\d.]+) [\\d.]+L([\\d.]+) [^\"]*Z\" fill=\"none\" stroke=\"#1f2430\"");
    private static final Pattern CROSS_LINE =
            Pattern.compile("<path d=\"M([\\d.]+) [\\d.]+L([\\d.]+) [\\d.]+\" fill=\"none\" [^>]*linejoin=\"miter\"");
    private static final Pattern DOT = Pattern.compile("<circle cx=\"([\\d.]+)\"()");

    private static ControllerRuns.ComparedRun run(double seconds) {
        return run(ROOM.withDuration(seconds));
    }

    private static ControllerRuns.ComparedRun run(SimulationSetup setup) {
        AtomicReference<RobotPath> path = new AtomicReference<>();
        RunResult result = HeadlessRun.run(
                setup,
                ControllerMode.DIRECT,
                List.of(simulation -> path.set(simulation.frame().path())));
        return ControllerRuns.ComparedRun.of(result, path.get(), 0.3 * setup.duration(), ROOM);
    }

    private static List<double[]> places(Pattern pattern, String svg) {
        return pattern.matcher(svg).results().map(ComparisonChartTest::numbers).toList();
    }

    private static double[] numbers(MatchResult found) {
        return IntStream.rangeClosed(1, found.groupCount())
                .mapToObj(found::group)
                .filter(text -> !text.isEmpty())
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    @Test
    void theAxisCoversAnIntervalThatIsWiderThanTheRuns() {
        ControllerRuns runs = new ControllerRuns("wall-follower", List.of(run(2), run(3)), List.of());
        String svg = ComparisonChart.spread(Metric.PATH, List.of(runs));
        double[] values = Metric.PATH.values(runs.runs());
        Interval mean = Metric.PATH.interval(values);
        assertTrue(mean.low() < values[0] && mean.high() > values[1], "two runs make a wide interval");
        double[] bar = places(BAR, svg).get(0);
        double[] frame = places(FRAME, svg).get(0);
        List<double[]> dots = places(DOT, svg);
        double pixelsPerMetre = (dots.get(1)[0] - dots.get(0)[0]) / (values[1] - values[0]);
        // The bar of two runs is 12.7 times as long as the distance of their dots, which is known to 0.01 pixel.
        assertEquals((mean.high() - mean.low()) * pixelsPerMetre, bar[1] - bar[0], 0.13, "the whole interval is drawn");
        assertTrue(frame[0] <= bar[0] && bar[1] <= frame[1], () -> Arrays.toString(bar) + Arrays.toString(frame));
    }

    /** A run of a second does not reach a wall. */
    @Test
    void aNumberThatNoRunHasIsNoChart() {
        ControllerRuns runs = new ControllerRuns("wall-follower", List.of(run(1)), List.of());
        assertEquals(
                "<p>No data: the share of the wall that was followed.</p>\n",
                ComparisonChart.spread(Metric.COVERAGE, List.of(runs)));
    }

    @Test
    void onlyThePathOfTheFirstSeedIsThick() {
        SimulationSetup first = ROOM.withDuration(1);
        ControllerRuns.ComparedRun second = run(first.withSeed(first.seed() + 1));
        ControllerRuns whole = new ControllerRuns("whole", List.of(run(first), second), List.of());
        ControllerRuns failing = new ControllerRuns(
                "failing", List.of(second), List.of(new ControllerRuns.FailedRun(first.seed(), "it broke")));
        assertEquals(1, thickLines(ComparisonChart.paths(first, List.of(whole))));
        assertEquals(0, thickLines(ComparisonChart.paths(first, List.of(failing))), "its first seed has no path");
    }

    @Test
    void thePathsAreInAPlanOfTheWorldWithTheRobotAtItsStartAndEndInDots() {
        List<ControllerRuns> controllers = List.of(
                new ControllerRuns("whole", List.of(run(1), run(ROOM.withSeed(7).withDuration(1))), List.of()));
        Obstacle desk = new Obstacle("desk", new ObstacleShape.RectangleShape(0.4, 0.4), new Pose(2, 1, 0));
        String empty = ComparisonChart.paths(ROOM, controllers);
        WorldSpec furnished = new WorldSpec(3, 2, true, 0, List.of(desk));
        assertNotEquals(
                empty, ComparisonChart.paths(SimulationSetup.of(furnished, ROOM.start()), controllers), "the desk");
        assertNotEquals(
                empty,
                ComparisonChart.paths(SimulationSetup.of(ROOM.world(), new Pose(0.6, 1.2, 1)), controllers),
                "the robot");
        assertEquals(2, places(DOT, empty).size(), "the ends");
    }

    /** The world is 3 m by 2 m: the width of 900 pixels less two margins of 14 limits its scale. */
    @Test
    void thePlanFillsTheWidthOrTheHeight() {
        assertTrue(paths(3, 2).contains("width=\"900\" height=\"610\""), paths(3, 2));
        assertTrue(paths(2, 10).contains("width=\"175\" height=\"760\""), paths(2, 10));
    }

    private static String paths(double width, double height) {
        return ComparisonChart.paths(
                SimulationSetup.of(new WorldSpec(width, height, true, 0, List.of()), ROOM.start()), List.of());
    }

    /** A circle of the robot is no straight line. */
    @Test
    void aPathIsDrawnToAQuarterOfAPixel() {
        SimulationSetup circle =
                ROOM.withController(new ControllerSpec.Drive(1, 3)).withDuration(4);
        String svg =
                ComparisonChart.paths(circle, List.of(new ControllerRuns("circle", List.of(run(circle)), List.of())));
        String path = Pattern.compile("d=\"([^\"]*)\"[^>]*stroke-width=\"2.2\"")
                .matcher(svg)
                .results()
                .map(found -> found.group(1))
                .findFirst()
                .orElseThrow();
        assertTrue(path.chars().filter(letter -> letter == 'L').count() > 5, path);
    }

    /** There are two rows; the bar of an interval is 0.4 rows high, and the axis reaches the run without one at 2.7. */
    @Test
    void controllersHaveTheirRowsFromTheTop() {
        ControllerRuns far = new ControllerRuns("far", List.of(run(9)), List.of());
        ControllerRuns near = new ControllerRuns("near", List.of(run(1), run(1.5)), List.of());
        String svg = ComparisonChart.spread(Metric.PATH, List.of(far, near));
        String edges = "d=\"M[\\d.]+ ([\\d.]+)L[\\d.]+ [\\d.]+L[\\d.]+ ([\\d.]+)L[^\"]*Z\" ";
        double[] frame = places(Pattern.compile(edges + "fill=\"none\" stroke=\"#1f2430\""), svg)
                .get(0);
        double[] bar = places(Pattern.compile(edges + "fill=\"#[0-9a-f]{6}\" fill-opacity"), svg)
                .get(0);
        double height = frame[0] - frame[1];
        double dot = places(Pattern.compile("<circle cx=\"[\\d.]+\" cy=\"([\\d.]+)\""), svg)
                .get(0)[0];
        assertEquals(frame[1] + 0.25 * height, dot, 0.01);
        assertEquals(frame[1] + 0.65 * height, bar[0], 0.01);
        assertEquals(frame[1] + 0.85 * height, bar[1], 0.01);
        assertTrue(svg.contains(">2.5</text>"), svg);
    }

    @Test
    void theShareOfCollisionsIsShownFromNoneToAll() {
        ControllerRuns runs = new ControllerRuns("still", List.of(run(1), run(1.5)), List.of());
        String svg = ComparisonChart.spread(Metric.COLLISION, List.of(runs));
        double[] frame = places(FRAME, svg).get(0);
        double[] dots = places(DOT, svg).get(0);
        assertEquals(frame[0], dots[0], 0.01, "no collision");
        assertTrue(svg.contains(">0.8</text>"), svg);
        assertTrue(svg.contains(">" + Metric.COLLISION.meaning() + "</text>"), svg);
    }

    @Test
    void aRunWithACollisionEndsInACross() {
        SimulationSetup blind = SimulationSetup.of(new WorldSpec(3, 2, true, 0, List.of()), new Pose(2.6, 1, 0))
                .withController(new ControllerSpec.Drive(3, 3))
                .withDuration(3);
        ControllerRuns.ComparedRun collided = run(blind);
        assertTrue(collided.collided());
        String svg = ComparisonChart.paths(
                blind, List.of(new ControllerRuns("blind", List.of(collided, run(1)), List.of())));
        assertEquals(1, places(DOT, svg).size(), "the other run");
        assertEquals(2, places(CROSS_LINE, svg).size(), svg);
    }

    private static long thickLines(String svg) {
        return Pattern.compile("stroke-width=\"2.2\"").matcher(svg).results().count();
    }

    @Test
    void controllersHaveANumberEachAndHostileNamesAreNoMarkup() {
        List<ControllerRuns> controllers = List.of(
                new ControllerRuns("</code><script>", List.of(run(1)), List.of()),
                new ControllerRuns("a fill=\"#123456\"\u0000", List.of(run(1)), List.of()));
        String svg = ComparisonChart.spread(Metric.PATH, controllers);
        assertTrue(svg.contains(">1</text>") && svg.contains(">2</text>"), svg);
        String legend = ComparisonChart.legend(controllers);
        assertEquals(2, legend.split("<path d=\"M2 5L32 5\"", -1).length - 1, legend);
        assertTrue(legend.contains("<code>&lt;/code&gt;&lt;script&gt;</code>"), legend);
        assertTrue(Html.page("t", "", legend).contains("<code>a fill=&quot;#123456&quot;?</code>"), legend);
    }
}
