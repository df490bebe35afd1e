package faultline.app.figures;

import faultline.control.Timing;
import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.paint.plot.SvgDrawing;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;

/**
 * The heading error of eq. (4) against one quantity, all others as usual: every trial as a point, theory as a line through them, for both
 * timings.
 *
 * @param name of the files
 * @param title of the chart
 * @param label of the quantity, with its unit
 * @param values of the quantity as the chart shows them, ascending
 * @param variants how many trials there are at each value
 * @param trials makes a trial
 */
record Sweep(String name, String title, String label, List<Double> values, int variants, Trials trials) implements Figure {

    private static final int WIDTH = 480;
    private static final int HEIGHT = 360;

    /** Makes the trial at a value of the quantity. */
    interface Trials {
        Alignment at(double value, Timing timing, int variant);
    }

    private record Point(double value, Timing timing, int variant, Alignment.Outcome outcome, Theory theory) {
        double error() {
            return StrictMath.toDegrees(outcome.error());
        }

        Vec measured() {
            return new Vec(value, error());
        }

        Vec expected(double spreads) {
            return new Vec(value, StrictMath.toDegrees(theory.error() + spreads * theory.spread()));
        }
    }

    @Override
    public void make(FigureFolder folder) throws IOException {
        List<Point> points = new ArrayList<>();
        for (Timing timing : Timing.values()) {
            for (double value : values) {
                for (int variant = 0; variant < variants; variant++) {
                    measure(value, timing, variant).ifPresent(points::add);
                }
            }
        }
        folder.csv(name, table(points));
        folder.svg(name, picture(points));
    }

    private Optional<Point> measure(double value, Timing timing, int variant) {
        Alignment trial = trials.at(value, timing, variant);
        return trial.run().map(outcome -> new Point(value, timing, variant, outcome, Theory.of(trial, outcome.at())));
    }

    private Table table(List<Point> points) {
        Table table = new Table(name.replace('-', '_'), "timing", "trial", "error_deg", "theory_deg", "t_D_s", "distance_m");
        for (Point point : points) {
            table.row(point.value(), point.timing().fileName(), point.variant(), point.error(), point.expected(0).y(), point.outcome().tD(),
                    Alignment.WALL - point.outcome().at().y());
        }
        return table;
    }

    private SvgDrawing picture(List<Point> points) {
        List<Point> letter = points.stream().filter(point -> point.timing() == Timing.RANGE).toList();
        List<Point> equal = points.stream().filter(point -> point.timing() == Timing.EQUAL_READINGS).toList();
        List<Mark> marks = List.of(
                new Mark.Band("\u00b1 \u03c9T/2", means(letter, 1), means(letter, -1), 1),
                new Mark.Line("theory, to the letter", means(letter, 0), 1),
                new Mark.Points("to the letter", letter.stream().map(Point::measured).toList(), 1),
                new Mark.Line("theory, equal readings", means(equal, 0), 0),
                new Mark.Points("equal readings", equal.stream().map(Point::measured).toList(), 0));
        DoubleStream errors = DoubleStream.concat(DoubleStream.of(0.5, -1), points.stream().flatMapToDouble(
                point -> DoubleStream.of(point.error(), point.expected(1).y(), point.expected(-1).y())));
        Chart chart = new Chart(title, Axis.covering(label, values.stream().mapToDouble(value -> value)),
                Axis.covering("heading error (degrees)", errors), marks);
        return Sheet.of(chart, WIDTH, HEIGHT);
    }

    /** The theory at each value: the mean over its trials. */
    private List<Vec> means(List<Point> points, double spreads) {
        List<Vec> means = new ArrayList<>();
        for (double value : values) {
            points.stream().filter(point -> point.value() == value).mapToDouble(point -> point.expected(spreads).y()).average()
                    .ifPresent(mean -> means.add(new Vec(value, mean)));
        }
        return means;
    }
}
