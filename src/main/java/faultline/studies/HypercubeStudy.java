package faultline.studies;

import faultline.control.TimingRule;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/**
 * Eq. (4) with all quantities varied at once: a Latin hypercube, in which the range of each quantity is divided into as
 * many equal intervals as there are trials, with one value in each interval.
 */
final class HypercubeStudy implements Figure {

    private static final int TRIALS = 200;
    private static final long SEED = 20_261_122;

    private static final String CAPTION =
            """
            Eq. (4) with seven quantities drawn at once by a Latin hypercube: the measured heading error over that of \
            the theory, n\u00a0=\u00a0%d trials for each rule, one a marker. Negative: turned away from the \
            wall. Dotted: measured as by theory.""";

    /** The quantities, in the order of the columns. */
    private enum VariedQuantity {
        DISTANCE(0.1, 0.45),
        RANGE(0.7, 1.5),
        CONE(4, 50),
        RATE(20, 120),
        PERIOD_TICKS(1, 10),
        TIME_CONSTANT(0, 0.12),
        SLANT(-50, 50);

        private final double low;
        private final double high;

        VariedQuantity(double low, double high) {
            this.low = low;
            this.high = high;
        }
    }

    /** The values of all quantities in a trial, in their units: metres, degrees, degrees per second, ticks, seconds. */
    private record TrialDesign(double[] values) {

        double get(VariedQuantity quantity) {
            return values[quantity.ordinal()];
        }
    }

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable(
                "timing",
                "distance_m",
                "range_m",
                "cone_deg",
                "spin_rate_deg_s",
                "period_ms",
                "time_constant_ms",
                "slant_deg",
                "error_deg",
                "theory_deg",
                "spread_deg");
        List<TrialDesign> design = design();
        List<Series> series = new ArrayList<>();
        series.add(new Series.Line("theory", List.of(new Vector2(-18, -18), new Vector2(1, 1)), 2));
        for (TimingRule rule : TimingRule.values()) {
            List<Vector2> points = new ArrayList<>();
            for (TrialDesign values : design) {
                measure(rule, values, table).ifPresent(points::add);
            }
            boolean range = rule == TimingRule.RANGE;
            series.add(new Series.Points(range ? "range rule" : "equal readings", points, range ? 1 : 0));
        }
        Chart chart = new Chart(
                "All quantities at once (n = " + TRIALS + " for each rule)",
                Axis.linear("heading error by theory (degrees)", -18, 1),
                Axis.linear("heading error (degrees)", -18, 2),
                series);
        folder.writeChart("eq4-hypercube", table, chart, 480, 400, String.format(Locale.ROOT, CAPTION, TRIALS));
    }

    /** Returns the values of all quantities for each trial. */
    private static List<TrialDesign> design() {
        SplittableRandom random = new SplittableRandom(SEED);
        double[][] design = new double[TRIALS][VariedQuantity.values().length];
        for (VariedQuantity quantity : VariedQuantity.values()) {
            int[] order = permutation(random);
            for (int i = 0; i < TRIALS; i++) {
                double share = (order[i] + random.nextDouble()) / TRIALS;
                design[i][quantity.ordinal()] = quantity.low + share * (quantity.high - quantity.low);
            }
        }
        return Stream.of(design).map(TrialDesign::new).toList();
    }

    private static int[] permutation(SplittableRandom random) {
        int[] order = new int[TRIALS];
        for (int i = 0; i < TRIALS; i++) {
            int j = random.nextInt(i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        return order;
    }

    /** Runs a trial, adds its row, and returns theory and error in degrees; empty if the robot never aligns. */
    private static Optional<Vector2> measure(TimingRule rule, TrialDesign values, CsvTable table) {
        AlignmentTrial trial = trial(rule, values);
        return trial.run().map(result -> {
            AlignmentTheory theory = AlignmentTheory.of(trial, result.position());
            Vector2 point = new Vector2(
                    StrictMath.toDegrees(theory.headingError()), StrictMath.toDegrees(result.headingError()));
            table.addRow(
                    rule.fileName(),
                    values.get(VariedQuantity.DISTANCE),
                    values.get(VariedQuantity.RANGE),
                    values.get(VariedQuantity.CONE),
                    values.get(VariedQuantity.RATE),
                    1000 * trial.period(),
                    1000 * values.get(VariedQuantity.TIME_CONSTANT),
                    values.get(VariedQuantity.SLANT),
                    point.y(),
                    point.x(),
                    StrictMath.toDegrees(theory.spread()));
            return point;
        });
    }

    private static AlignmentTrial trial(TimingRule rule, TrialDesign values) {
        double away = values.get(VariedQuantity.DISTANCE) + 0.35;
        Pose start = new Pose(
                AlignmentTrial.WALL_Y,
                AlignmentTrial.WALL_Y - away,
                StrictMath.PI / 2 + Degrees.toRadians(values.get(VariedQuantity.SLANT)));
        double period = Math.rint(values.get(VariedQuantity.PERIOD_TICKS)) * AlignmentTrial.BASE.dt();
        return AlignmentTrial.standard(rule, 0)
                .withRobot(AlignmentTrial.robot(
                        values.get(VariedQuantity.RANGE),
                        Degrees.toRadians(values.get(VariedQuantity.CONE)),
                        Degrees.toRadians(values.get(VariedQuantity.RATE)),
                        values.get(VariedQuantity.TIME_CONSTANT)))
                .withDistance(values.get(VariedQuantity.DISTANCE))
                .withPeriod(period)
                .withSetup(AlignmentTrial.BASE.withStart(start));
    }
}
