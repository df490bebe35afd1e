package faultline.studies;

import static faultline.studies.CornerRun.SensorSelection.FRONT_LEFT;
import static faultline.studies.CornerRun.SensorSelection.FRONT_RIGHT;
import static faultline.studies.CornerRun.SensorSelection.TWO;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.FollowerState;
import faultline.geometry.Angles;
import faultline.studies.figure.SortedSample;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What docs/results.md says in words and numbers is what the tables beside it say. */
class ResultsTextTest {

    private static final Pattern ROW =
            Pattern.compile("(?m)^\\|[^|]*\\(results/(eq4-[a-z-]+)\\.csv\\)[^|]*\\|([^|]*)\\|([^|]*)\\|");
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?");

    private static String text;

    @BeforeAll
    static void read() throws IOException {
        text = Files.readString(Path.of("docs/results.md")).replaceAll("\\s+", " ");
    }

    private static void assertSaid(String sentence, Object... numbers) {
        String said = String.format(Locale.ROOT, sentence, numbers);
        assertTrue(text.contains(said), () -> "the results should say: " + said);
    }

    @Test
    void everyRowOfEquationFourHasTheLeastAndTheGreatestErrorOfItsTable() throws IOException {
        Matcher row = ROW.matcher(Files.readString(Path.of("docs/results.md")));
        List<String> wrong = new ArrayList<>();
        int rows = 0;
        while (row.find()) {
            rows++;
            check(row.group(1), "range", row.group(2), wrong);
            check(row.group(1), "equal-readings", row.group(3), wrong);
        }
        assertEquals(List.of(), wrong);
        assertEquals(EquationFour.sweeps().size(), rows);
    }

    /** The trials without a hand-over have no row in the table. */
    @Test
    void everyCaptionOfEquationFourCountsAllTrials() throws IOException {
        for (ParameterSweep sweep : EquationFour.sweeps()) {
            String words = Files.readString(Path.of("docs/results/" + sweep.name() + ".svg"))
                    .replaceAll("<[^>]*>", " ")
                    .replaceAll("[\\s\u00a0]+", " ");
            List<MatchResult> counts = Pattern.compile(
                            "n = (\\d+) by the range rule, (\\d+) by equal|In (\\d+) more trials")
                    .matcher(words)
                    .results()
                    .toList();
            int sum = counts.stream()
                    .flatMap(count -> IntStream.rangeClosed(1, 3).mapToObj(count::group))
                    .filter(Objects::nonNull)
                    .mapToInt(Integer::parseInt)
                    .sum();
            assertEquals(2 * sweep.values().size() * sweep.variants(), sum, sweep.name());
        }
    }

    /** Both ends of the range are named, to the decimals that are given; where they are alike, once. */
    private static void check(String table, String timing, String cell, List<String> wrong) {
        double[] errors = ResultsTable.of(table)
                .where("timing", timing)
                .numbers("error_deg")
                .sorted()
                .toArray();
        double least = errors[0];
        double greatest = errors[errors.length - 1];
        List<String> numbers = NUMBER.matcher(cell.replaceAll("from \\d+ degrees on", ""))
                .results()
                .map(MatchResult::group)
                .toList();
        boolean named = List.of(least, greatest).stream()
                .allMatch(end -> numbers.stream().anyMatch(number -> rounds(end, number)));
        if (!named || numbers.stream().anyMatch(number -> !rounds(least, number) && !rounds(greatest, number))) {
            wrong.add(String.format(
                    Locale.ROOT, "%s %s: %s, but is %.3f to %.3f", table, timing, cell.strip(), least, greatest));
        }
    }

    private static boolean rounds(double value, String number) {
        int decimals = number.contains(".") ? number.length() - number.indexOf('.') - 1 : 0;
        return Math.abs(value - Double.parseDouble(number)) <= 0.5 * Math.pow(10, -decimals) + 1e-9;
    }

    @Test
    void theNumberOfTrialsAndHowFarTheoryIsOff() {
        List<String> tables =
                EquationFour.sweeps().stream().map(ParameterSweep::name).toList();
        assertSaid(
                "%d trials; theory and trial differ by no more than the band and 0.3 degrees, except with noise",
                tables.stream()
                        .mapToInt(name -> ResultsTable.of(name).rows().size())
                        .sum());
        for (String name : tables) {
            ResultsTable equal = ResultsTable.of(name).where("timing", "equal-readings");
            double off = equal.rows().stream()
                    .mapToDouble(row -> Math.abs(
                            Double.parseDouble(row.get("error_deg")) - Double.parseDouble(row.get("theory_deg"))))
                    .max()
                    .orElseThrow();
            assertTrue(name.equals("eq4-noise") || off <= 0.3, name + " " + off);
        }
    }

    /** The sweeps beside one long wall, without noise, with a sensor whose axis passes through the centre. */
    @Test
    void theAlignmentBesideOneLongWallWithEqualReadings() {
        double near = 0;
        double all = 0;
        int trials = 0;
        for (String quantity : List.of("cone", "distance", "motor", "period", "position-along", "range", "spin-rate")) {
            ResultsTable table = ResultsTable.of("eq4-" + quantity).where("timing", "equal-readings");
            trials += table.rows().size();
            all = Math.max(all, largestError(table));
            double most =
                    switch (quantity) {
                        case "distance" -> 0.72;
                        case "motor" -> 60;
                        case "period" -> 50;
                        default -> Double.POSITIVE_INFINITY;
                    };
            String column = "eq4_" + quantity.replace('-', '_');
            near = Math.max(near, largestError(table.between(column, Double.NEGATIVE_INFINITY, most)));
        }
        assertSaid(
                "with equal readings to within %.2f degrees, or %.1f if the wall is at the limit of the range, the time"
                        + " constant of the motors exceeds 60 ms or the period 50 ms (n = %d for each rule), and to"
                        + " within %.2f degrees in a [hypercube]",
                near, all, trials, largestError(ResultsTable.of("eq4-hypercube").where("timing", "equal-readings")));
    }

    private static double largestError(ResultsTable table) {
        return table.numbers("error_deg").map(Math::abs).max().orElseThrow();
    }

    @Test
    void thePositioningBesideTheWall() {
        ResultsTable moments = ResultsTable.of("fig4-positioning");
        double f3 = moments.where("frame", "F3").number("t_s");
        double f4 = moments.where("frame", "F4").number("t_s");
        assertSaid(
                "F3 is at %.2f s and F4 at %.2f s, so t_D = %.2f s and t_p = %.2f s; "
                        + "the robot ends %.1f degrees short of parallel",
                f3, f4, f4 - f3, (f4 - f3) / 2, -moments.where("frame", "P").number("heading_deg"));
    }

    @Test
    void betweenF3AndF4TheRobotTurnsByOneAndTheSameAngleEveryTick() {
        RunTrace trace =
                RunTrace.simulate(StudyScenarios.load("beside-a-wall.xml").setup());
        for (int tick = trace.states().indexOf(FollowerState.MEASURE);
                tick < trace.states().indexOf(FollowerState.ALIGN);
                tick++) {
            double turned = trace.poses().get(tick - 1).heading()
                    - trace.poses().get(tick).heading();
            assertEquals(0.600, StrictMath.toDegrees(Angles.normalize(turned)), 0.0005);
        }
        assertSaid("0.600 degrees every 10 ms from F3 to F4");
    }

    private static String corner(int degrees, CornerRun.SensorSelection sensors) {
        ResultsTable row = ResultsTable.of("fig6-angles")
                .where("angle_deg", Integer.toString(degrees))
                .where("sensors", sensors.fileName());
        return String.format(
                Locale.ROOT,
                "%.0f mm (%.0f to %.0f)",
                250 + row.number("median_mm"),
                250 + row.number("min_mm"),
                250 + row.number("max_mm"));
    }

    @Test
    void theCorners() {
        assertSaid("%s at 45 degrees, %s at 35. (A few starts", corner(45, TWO), corner(35, TWO));
        assertSaid("The front-right sensor makes that %s.", corner(45, FRONT_RIGHT));
        assertSaid("%s without it at 135 degrees, %s with it", corner(135, TWO), corner(135, FRONT_LEFT));
        ResultsTable table = ResultsTable.of("fig6-angles");
        ResultsTable square = table.where("sensors", TWO.fileName()).between("angle_deg", 75, 105);
        double worst = DoubleStream.concat(square.numbers("min_mm"), square.numbers("max_mm"))
                .map(Math::abs)
                .max()
                .orElseThrow();
        assertSaid("degrees two sensors are within %d mm", (int) Math.ceil(worst));
        assertTrue(table.numbers("starts").allMatch(starts -> starts >= 30));
    }

    @Test
    void theHeadingErrorsWithNoise() {
        ResultsTable slow = ResultsTable.of("eq4-noise-seeds")
                .where("timing", "range")
                .where("spin_rate_deg_s", "15")
                .where("noise_mm", "8");
        assertSaid("at 15 degrees/s and 8 mm %.0f of %.0f alignments", slow.number("gross"), slow.number("n"));
        ResultsTable.of("eq4-noise-seeds")
                .rows()
                .forEach(row -> assertSaid(
                        "| %s | %s | %.2f | %.2f to %.2f |",
                        row.get("period_ms"),
                        row.get("noise_mm"),
                        Double.parseDouble(row.get("rms_deg")),
                        Double.parseDouble(row.get("q05_deg")),
                        Double.parseDouble(row.get("q95_deg"))));
    }

    @Test
    void theHypercube() {
        ResultsTable table = ResultsTable.of("eq4-hypercube");
        assertEquals(400, table.rows().size(), "every trial aligns");
        assertSaid("differ by at most %.2f degrees with equal readings", largestResidual(table, "equal-readings"));
        assertSaid("by the range rule by at most %.2f degrees more", largestResidual(table, "range"));
    }

    private static double largestResidual(ResultsTable table, String timing) {
        return table.where("timing", timing).rows().stream()
                .mapToDouble(row ->
                        Math.abs(Double.parseDouble(row.get("error_deg")) - Double.parseDouble(row.get("theory_deg")))
                                - Double.parseDouble(row.get("spread_deg")))
                .max()
                .orElseThrow();
    }

    @Test
    void theOtherSensors() {
        ResultsTable cases =
                ResultsTable.of("eq4-other-sensors").where("failed_sensor", sensor -> !sensor.equals("none"));
        assertSaid("the same to the last bit in all %d cases", cases.rows().size());
        assertTrue(cases.cells("same_bits").allMatch("true"::equals));
        assertEquals(
                List.of("front"),
                cases.where("same_bits_from_the_start", "false")
                        .cells("failed_sensor")
                        .distinct()
                        .toList());
    }

    @Test
    void thePoles() {
        assertEquals(
                0,
                ResultsTable.of("thin-objects")
                        .where("cone_deg", "20")
                        .numbers("collisions")
                        .sum());
        assertEquals(1 / 7.0, share("8"), 0.02, "one in seven");
        assertEquals(1 / 3.0, share("2"), 0.02, "one in three");
    }

    private static double share(String cone) {
        ResultsTable runs = ResultsTable.of("thin-objects").where("cone_deg", cone);
        return runs.numbers("collisions").sum() / runs.numbers("runs").sum();
    }

    @Test
    void theNoise() {
        ResultsTable runs = ResultsTable.of("noise-following");
        long below = runs.rows().stream()
                .filter(row ->
                        Double.parseDouble(row.get("distance_rms_mm")) < Double.parseDouble(row.get("noise_mm")) / 2)
                .count();
        assertSaid("stays below half of the noise in %d of 144 noisy runs", below);
        assertTrue(runs.cells("collided").noneMatch("true"::equals));
        assertSaid(
                "%.1f mm RMS on straight walls without noise, %.1f mm with noise of 4 mm",
                runs.where("noise_mm", "0").numbers("distance_rms_mm").max().orElseThrow(),
                runs.where("noise_mm", "4").numbers("distance_rms_mm").max().orElseThrow());
    }

    @Test
    void theNoiseInRandomRooms() {
        ResultsTable rooms = ResultsTable.of("noise-rooms");
        assertTrue(rooms.cells("collided").noneMatch("true"::equals));
        for (String noise : List.of("0", "1", "4", "10")) {
            ResultsTable runs = rooms.where("noise_mm", noise);
            SortedSample straight = SortedSample.of(runs.numbers("straight_rms_mm"));
            SortedSample follow = SortedSample.of(runs.numbers("follow_rms_mm"));
            assertEquals(60, straight.size());
            assertSaid(
                    "| %s | 60 | %s | %.1f, %.1f | %s | %.1f | 0 |",
                    noise, median(straight), straight.quantile(0.9), straight.max(), median(follow), follow.max());
        }
        assertSaid("without noise the largest is %.1f mm", worstRoom(rooms, "0"));
        assertSaid("after it (%.1f mm)", worstRoom(rooms, "4"));
    }

    private static double worstRoom(ResultsTable rooms, String noise) {
        return rooms.where("noise_mm", noise).numbers("straight_rms_mm").max().orElseThrow();
    }

    /** The median of 60 values, and the 22nd of them from either end: that many coins show heads with 95 %. */
    private static String median(SortedSample sample) {
        return String.format(
                Locale.ROOT,
                "%.1f (%.1f to %.1f)",
                sample.median(),
                sample.quantile(21 / 59.0),
                sample.quantile(38 / 59.0));
    }

    @Test
    void theSpecularWalls() {
        ResultsTable hits = ResultsTable.of("specular-map").where("outcome", "runs into it");
        assertTrue(hits.numbers("specular_deg").max().orElseThrow() <= 12);
        assertTrue(
                hits.numbers("slant_deg").map(Math::abs).allMatch(slant -> slant >= 10 && slant <= 35 || slant > 55));
    }
}
