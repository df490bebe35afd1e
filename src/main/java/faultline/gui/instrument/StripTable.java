package faultline.gui.instrument;

import faultline.gui.text.Messages;
import faultline.io.DecimalText;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** Formats the values of a strip chart as comma-separated text, at the finest resolution that is recorded. */
final class StripTable {

    private static final double STEPS_PER_SECOND = 1e9;

    private StripTable() {}

    /** A line of a run, with its name in the header. */
    private record LineColumn(String name, StripData.LineValues values, StripData run) {

        private boolean isSingle() {
            return run.level().ticksPerBucket() == 1;
        }

        /** Returns one quoted name, or two where a bucket has several ticks. */
        String header(String unit) {
            List<String> suffixes = isSingle() ? List.of("") : List.of(" min", " max");
            return suffixes.stream()
                    .map(suffix -> "\"" + name.replace("\"", "\"\"") + suffix + " (" + unit + ")\"")
                    .collect(Collectors.joining(","));
        }

        /** Returns the least and the greatest value at a time, seconds, as cells that are empty if there is none. */
        String cells(double time) {
            long bucket = run.bucketOf(time);
            boolean inside = bucket >= run.from() && bucket < run.to();
            String low = inside ? cell(values.min(bucket)) : "";
            String high = inside ? cell(values.max(bucket)) : "";
            return isSingle() ? low : low + "," + high;
        }

        private static String cell(float value) {
            return Float.isFinite(value) ? Float.toString(value) : "";
        }
    }

    /** Returns the table: the time, then the values of each line, and those of the reference run if there is one. */
    static String format(StripContent content) {
        StripData data = StripData.of(content.frame(), content.span(), Integer.MAX_VALUE / 4);
        List<LineColumn> columns = new ArrayList<>();
        content.signal().lines().forEach(line -> data.valuesOf(line)
                .ifPresent(values -> columns.add(new LineColumn(line.name(), values, data))));
        Optional<StripData> referenceData = content.referenceData(Integer.MAX_VALUE / 4);
        referenceData.ifPresent(reference -> content.signal().lines().forEach(line -> reference
                .valuesOf(line)
                .ifPresent(values -> columns.add(
                        new LineColumn(Messages.get("signal.reference") + ", " + line.name(), values, reference)))));
        StringBuilder out = new StringBuilder("t (s)");
        columns.forEach(
                column -> out.append(',').append(column.header(content.signal().unit())));
        out.append('\n');
        long to = referenceData
                .map(reference -> Math.max(data.to(), data.bucketOf(reference.lastTime()) + 1))
                .orElse(data.to());
        for (long bucket = data.from(); bucket < to; bucket++) {
            double time = Math.rint(data.timeOf(bucket) * STEPS_PER_SECOND) / STEPS_PER_SECOND;
            out.append(DecimalText.format(time));
            columns.forEach(column -> out.append(',').append(column.cells(time)));
            out.append('\n');
        }
        return out.toString();
    }
}
