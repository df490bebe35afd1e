package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/**
 * Formats the values of a strip chart as comma-separated text, at the finest resolution that is recorded of the run. A
 * finer reference run has its least and greatest values in each row.
 */
final class StripTable {

    private static final double STEPS_PER_SECOND = 1e9;
    /** Less than this share of a bucket is due to rounding. */
    private static final double ROUNDING = 1e-6;

    private StripTable() {}

    /** A line of a run, with its name in the header. Each bucket of {@code rows}, maybe of another run, is a row. */
    private record LineColumn(String name, StripData.LineValues values, StripData run, StripData rows) {

        private boolean isFinerThanRows() {
            return run.bucketLength() < rows.bucketLength() * (1 - ROUNDING);
        }

        private boolean isSingle() {
            return run.level().ticksPerBucket() == 1 && !isFinerThanRows();
        }

        /** Returns one quoted name, or two where a row has several ticks. */
        String header(String unit) {
            List<String> suffixes = isSingle() ? List.of("") : List.of(" min", " max");
            return suffixes.stream()
                    .map(suffix -> "\"" + name.replace("\"", "\"\"") + suffix + " (" + unit + ")\"")
                    .collect(Collectors.joining(","));
        }

        /** Returns the least and the greatest value in a row as cells that are empty if there is none. */
        String cells(long row) {
            String low = cell(finite(row, values::min).min().orElse(Double.NaN));
            return isSingle()
                    ? low
                    : low + "," + cell(finite(row, values::max).max().orElse(Double.NaN));
        }

        private DoubleStream finite(long row, LongToDoubleFunction value) {
            return LongStream.range(Math.max(first(row), run.from()), Math.min(end(row), run.to()))
                    .mapToDouble(value)
                    .filter(Double::isFinite);
        }

        /** Returns the first bucket in a row; that at its time if a bucket is as long as a row, or longer. */
        private long first(long row) {
            return isFinerThanRows() ? firstCentred(row) : run.bucketOf(timeOf(rows, row));
        }

        private long end(long row) {
            return isFinerThanRows() ? firstCentred(row + 1) : first(row) + 1;
        }

        /** Returns the first bucket whose centre is not before a row, so that each bucket is in exactly one. */
        private long firstCentred(long row) {
            double start = rows.timeOf(row) - rows.bucketLength() / 2;
            return (long) Math.ceil((start - run.timeOf(0)) / run.bucketLength() - ROUNDING);
        }

        private static String cell(double value) {
            return Double.isNaN(value) ? "" : Float.toString((float) value);
        }
    }

    /** Returns the time of a row, seconds, without the errors of multiplication. */
    private static double timeOf(StripData rows, long row) {
        return Math.rint(rows.timeOf(row) * STEPS_PER_SECOND) / STEPS_PER_SECOND;
    }

    /** Returns the table: the time, then the values of each line, and those of the reference run if there is one. */
    static String format(StripContent content) {
        StripData data = StripData.of(content.frame(), content.span(), Integer.MAX_VALUE / 4);
        List<LineColumn> columns = new ArrayList<>();
        content.signal().lines().forEach(line -> data.valuesOf(line)
                .ifPresent(values -> columns.add(new LineColumn(line.name(), values, data, data))));
        Optional<StripData> referenceData = content.referenceData(Integer.MAX_VALUE / 4);
        referenceData.ifPresent(reference -> content.signal().lines().forEach(line -> reference
                .valuesOf(line)
                .ifPresent(values -> columns.add(new LineColumn(
                        Messages.get("signal.reference") + ", " + line.name(), values, reference, data)))));
        StringBuilder out = new StringBuilder("t (s)");
        columns.forEach(
                column -> out.append(',').append(column.header(content.signal().unit())));
        out.append('\n');
        long to = referenceData
                .map(reference -> Math.max(data.to(), data.bucketOf(reference.lastTime()) + 1))
                .orElse(data.to());
        LongStream.range(data.from(), to).forEach(row -> {
            out.append(DecimalText.format(timeOf(data, row)));
            columns.forEach(column -> out.append(',').append(column.cells(row)));
            out.append('\n');
        });
        return out.toString();
    }
}
