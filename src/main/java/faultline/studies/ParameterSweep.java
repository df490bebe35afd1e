package faultline.studies;

import faultline.control.TimingRule;
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
import java.util.stream.DoubleStream;

/**
 * The heading error of eq. (4) over one quantity, with all others at their defaults. Every trial is a point and the
 * theory is a line, for both rules.
 *
 * @param name the name of the files
 * @param title the title of the chart
 * @param label the label of the quantity, with its unit
 * @param values the values of the quantity as in the chart, ascending
 * @param variants the number of trials at each value
 * @param trialFactory the factory of trials
 */
record ParameterSweep(
        String name, String title, String label, List<Double> values, int variants, TrialFactory trialFactory)
        implements Figure {

    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;

    private static final String CAPTION =
            """
            Eq. (4): the heading error at the hand-over to FOLLOW, one marker a trial (n\u00a0=\u00a0%d by the range \
            rule, %d by equal readings), all other quantities at their defaults. Positive: turned towards the wall. \
            Lines: the theory; shaded: half of what the robot turns in a control period T, since the range rule \
            sees each edge up to T late.""";
    private static final String MISSING = " In %d more trials there was no such hand-over.";

    /** Creates the trial at a value of the quantity from a trial with all quantities at their defaults. */
    interface TrialFactory {
        AlignmentTrial create(double value, AlignmentTrial standard, int variant);
    }

    private record TrialPoint(
            double value, TimingRule timing, int variant, AlignmentTrial.TrialResult outcome, AlignmentTheory theory) {
        double error() {
            return StrictMath.toDegrees(outcome.headingError());
        }

        Vector2 measured() {
            return new Vector2(value, error());
        }

        Vector2 expected(double spreads) {
            return new Vector2(value, StrictMath.toDegrees(theory.headingError() + spreads * theory.spread()));
        }
    }

    @Override
    public void write(FigureFolder folder) throws IOException {
        List<TrialPoint> points = new ArrayList<>();
        for (TimingRule timing : TimingRule.values()) {
            for (double value : values) {
                for (int variant = 0; variant < variants; variant++) {
                    measure(value, timing, variant).ifPresent(points::add);
                }
            }
        }
        writeChart(folder, points);
    }

    private Optional<TrialPoint> measure(double value, TimingRule timing, int variant) {
        AlignmentTrial trial = trialFactory.create(value, AlignmentTrial.standard(timing, variant), variant);
        return trial.run()
                .map(outcome ->
                        new TrialPoint(value, timing, variant, outcome, AlignmentTheory.of(trial, outcome.position())));
    }

    private CsvTable createTable(List<TrialPoint> points) {
        CsvTable table = new CsvTable(
                name.replace('-', '_'), "timing", "trial", "error_deg", "theory_deg", "t_D_s", "distance_m");
        for (TrialPoint point : points) {
            table.addRow(
                    point.value(),
                    point.timing().fileName(),
                    point.variant(),
                    point.error(),
                    point.expected(0).y(),
                    point.outcome().tD(),
                    AlignmentTrial.WALL_Y - point.outcome().position().y());
        }
        return table;
    }

    private void writeChart(FigureFolder folder, List<TrialPoint> points) throws IOException {
        List<TrialPoint> range = points.stream()
                .filter(point -> point.timing() == TimingRule.RANGE)
                .toList();
        List<TrialPoint> equal = points.stream()
                .filter(point -> point.timing() == TimingRule.EQUAL_READINGS)
                .toList();
        List<Series> series = List.of(
                new Series.Band("\u00b1 \u03c9T/2", means(range, 1), means(range, -1), 1),
                new Series.Line("theory, range rule", means(range, 0), 1),
                new Series.Points(
                        "range rule", range.stream().map(TrialPoint::measured).toList(), 1),
                new Series.Line("theory, equal readings", means(equal, 0), 0),
                new Series.Points(
                        "equal readings",
                        equal.stream().map(TrialPoint::measured).toList(),
                        0));
        DoubleStream errors = DoubleStream.concat(
                DoubleStream.of(0.5, -1),
                points.stream()
                        .flatMapToDouble(point -> DoubleStream.of(
                                point.error(),
                                point.expected(1).y(),
                                point.expected(-1).y())));
        Chart chart = new Chart(
                title,
                Axis.covering(label, values.stream().mapToDouble(value -> value)),
                Axis.covering("heading error (degrees)", errors),
                series);
        folder.writeChart(name, createTable(points), chart, WIDTH, HEIGHT, caption(range.size(), equal.size()));
    }

    private String caption(int range, int equal) {
        String caption = String.format(Locale.ROOT, CAPTION, range, equal);
        int missing = TimingRule.values().length * values.size() * variants - range - equal;
        return missing == 0 ? caption : caption + String.format(Locale.ROOT, MISSING, missing);
    }

    /** Returns the theory at each value: the mean over its trials. */
    private List<Vector2> means(List<TrialPoint> points, double spreads) {
        List<Vector2> means = new ArrayList<>();
        for (double value : values) {
            points.stream()
                    .filter(point -> point.value() == value)
                    .mapToDouble(point -> point.expected(spreads).y())
                    .average()
                    .ifPresent(mean -> means.add(new Vector2(value, mean)));
        }
        return means;
    }
}
