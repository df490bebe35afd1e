package faultline.gui.instrument;

import faultline.engine.recording.TraceLevel;
import faultline.io.DecimalText;
import java.util.List;
import java.util.stream.Collectors;

/** Formats the values of a strip chart as comma-separated text, at the finest resolution that is recorded. */
final class StripTable {

    private StripTable() {}

    /** Returns the table: the time, then the least and the greatest value of each line; empty where there is none. */
    static String format(StripContent content) {
        List<ChartLine> lines = content.signal().lines();
        StripData data = StripData.of(content.frame(), content.span(), Integer.MAX_VALUE / 4);
        boolean single = data.level().ticksPerBucket() == 1;
        StringBuilder out = new StringBuilder("t");
        lines.forEach(line -> out.append(single ? column(line, "") : column(line, " min") + column(line, " max")));
        out.append('\n');
        for (long bucket = data.from(); bucket < data.to(); bucket++) {
            out.append(DecimalText.format(data.timeOf(bucket)));
            for (ChartLine line : lines) {
                appendValues(out, data.level(), line, bucket, single);
            }
            out.append('\n');
        }
        return out.toString();
    }

    private static String column(ChartLine line, String suffix) {
        return ",\"" + line.name().replace("\"", "\"\"") + suffix + '"';
    }

    private static void appendValues(StringBuilder out, TraceLevel level, ChartLine line, long bucket, boolean single) {
        List<Float> values = single
                ? List.of(level.min(line.channel(), bucket))
                : List.of(level.min(line.channel(), bucket), level.max(line.channel(), bucket));
        out.append(values.stream()
                .map(value -> Float.isFinite(value) ? "," + value : ",")
                .collect(Collectors.joining()));
    }
}
