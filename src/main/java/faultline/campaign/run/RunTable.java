package faultline.campaign.run;

import faultline.campaign.plan.Column;
import faultline.io.Message;
import faultline.io.MessageException;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The two tables of a campaign in progress. Rows are appended in the order of the runs, so the file is always the
 * beginning of the finished table, except for an incomplete last row of a killed process, or zeros that a crash of the
 * machine has left where blocks were not written. Opening a partial table removes them, with what is below. A table
 * with a wrong row, with other zeros or with more rows than runs is refused: people and other programs may have changed
 * it, and its rows can take days to make.
 */
final class RunTable implements Closeable {

    /** The columns of {@code timing.csv}. */
    static final List<Column> TIMING_COLUMNS = List.of(
            new Column("run", "", "number of the run in the plan"),
            new Column("wall_s", "s", "time that the run took on this machine"),
            new Column("ticks", "", "ticks that it made"),
            new Column("ticks_per_s", "1/s", "ticks per second of the clock"));

    /** The first line of {@code timing.csv}. */
    static final String TIMING_HEADER =
            Csv.row(TIMING_COLUMNS.stream().map(Column::name).toList());

    /** The rule for a row. */
    interface RowRule {

        /** Returns the error in the cells of a row that must be that of a run; empty if there is none. */
        Optional<Message> findProblem(List<String> cells, long run);
    }

    private final Table runs;
    private final Table timing;
    private final ByteArrayOutputStream pendingRuns = new ByteArrayOutputStream();
    private final ByteArrayOutputStream pendingTiming = new ByteArrayOutputStream();
    private long next;
    private long broken;
    private boolean dirty;

    /**
     * Opens the tables of a folder for this part, which ends before the run {@code end}; the header and the rule are
     * those of {@code runs.csv}.
     */
    RunTable(CampaignFolder folder, String header, RowRule rule, long first, long end) throws IOException {
        next = first;
        long length = recover(folder.runs(), header, rule, end);
        runs = Table.open(folder.runs(), length, header);
        try {
            timing = Table.open(folder.timing(), recoverTiming(folder.timing(), first), TIMING_HEADER);
        } catch (IOException | RuntimeException e) {
            try (runs) {
                throw e;
            }
        }
    }

    /** Determines the number of valid bytes of a table, and the next run. */
    private long recover(Path file, String header, RowRule rule, long end) throws IOException {
        if (Files.notExists(file)) {
            return 0;
        }
        int outcome = Csv.cells(header.strip()).indexOf("outcome");
        long first = next;
        try (LineReader in = new LineReader(file)) {
            String given = in.next();
            if (!given.equals(header)) {
                requireNoOther(header, given, file);
                return 0;
            }
            long length = in.length();
            long row = 2;
            String line = in.next();
            for (; next < end && line.endsWith("\n") && !in.isTooLong() && !hasZero(line); line = in.next()) {
                List<String> cells = Csv.cells(line.stripTrailing());
                Optional<Message> problem =
                        in.isText() ? rule.findProblem(cells, next) : Optional.of(ResultsProblem.NOT_TEXT.with());
                if (problem.isPresent()) {
                    throw wrongRow(file + ":" + row, problem.get());
                }
                row++;
                broken += cells.get(outcome).equals(Outcome.BROKEN) ? 1 : 0;
                length += in.length();
                next++;
            }
            for (; next == end && line.isBlank() && !line.isEmpty(); line = in.next()) {
                row++;
            }
            requireUnfinished(in, line, file + ":" + row);
            if (next == end && !line.isEmpty() && !hasZero(line)) {
                throw new MessageException(file + ":" + row, ResultsProblem.TOO_MANY_ROWS.with(end - first), null);
            }
            return length;
        }
    }

    /** Throws an exception if neither a killed process nor a crash of the machine leaves this line below the rows. */
    private static void requireUnfinished(LineReader in, String line, String place) throws IOException {
        if (hasZero(line) && !in.hasZerosOfCrash()) {
            throw wrongRow(place, ResultsProblem.ZERO_BYTE.with());
        }
        if (!hasZero(line) && in.isTooLong()) {
            throw wrongRow(place, ResultsProblem.LONG_ROW.with());
        }
    }

    private static boolean hasZero(String line) {
        return line.indexOf('\0') >= 0;
    }

    private static MessageException wrongRow(String place, Message problem) {
        return new MessageException(place, ResultsProblem.WRONG_ROW.with(problem), null);
    }

    /**
     * Throws an exception if a table begins with neither the expected header nor a part of it: another program may have
     * changed all rows. A killed process leaves an incomplete header, and a crash of the machine zeros.
     */
    static void requireNoOther(String header, String given, Path file) throws IOException {
        int zero = given.indexOf('\0');
        String written = zero < 0 ? given : given.substring(0, zero);
        boolean isBeginning = header.startsWith(written)
                && given.chars().skip(written.length()).allMatch(c -> c == 0);
        if (!isBeginning) {
            throw new IOException(file + ":1: this is not the header of the campaign; restore the table, or remove it");
        }
    }

    /** Determines the number of bytes of the timing table that belong to runs in the other table. */
    private long recoverTiming(Path file, long first) throws IOException {
        if (Files.notExists(file)) {
            return 0;
        }
        try (LineReader in = new LineReader(file)) {
            if (!in.next().equals(TIMING_HEADER)) {
                return 0;
            }
            long length = in.length();
            long least = first;
            for (String line = in.next(); line.endsWith("\n"); line = in.next()) {
                String cell = Csv.cells(line).get(0);
                if (!cell.matches("\\d{1,18}") || Long.parseLong(cell) < least || Long.parseLong(cell) >= next) {
                    return length;
                }
                least = Long.parseLong(cell) + 1;
                length += in.length();
            }
            return length;
        }
    }

    long next() {
        return next;
    }

    /** Returns the number of failed runs in the table. */
    long broken() {
        return broken;
    }

    /** Adds the next run. */
    void add(RunMaker.MadeRun run) {
        if (run.index() != next) {
            throw new IllegalStateException("run " + run.index() + " came before run " + next);
        }
        pendingRuns.writeBytes(run.row().getBytes(StandardCharsets.UTF_8));
        pendingTiming.writeBytes(timingRow(run).getBytes(StandardCharsets.UTF_8));
        broken += run.broken() ? 1 : 0;
        next++;
        dirty = true;
    }

    private static String timingRow(RunMaker.MadeRun run) {
        double rate = run.seconds() > 0 ? run.ticks() / run.seconds() : 0;
        return String.format(Locale.ROOT, "%d,%.6f,%d,%.0f\n", run.index(), run.seconds(), run.ticks(), rate);
    }

    /**
     * Writes all rows to the operating system; they then survive the end of this process. Rows that cannot be written
     * are not tried a second time, because a part of them may be in the file.
     */
    void flush() throws IOException {
        byte[] times = pendingTiming.toByteArray();
        byte[] rows = pendingRuns.toByteArray();
        pendingTiming.reset();
        pendingRuns.reset();
        timing.write(times);
        runs.write(rows);
    }

    /** Forces all rows to the disk; they then survive a crash of the machine. */
    void force() throws IOException {
        flush();
        if (dirty) {
            timing.force();
            runs.force();
            dirty = false;
        }
    }

    @Override
    public void close() throws IOException {
        try (timing;
                runs) {
            force();
        }
    }

    /** One of the two files. */
    private record Table(Path file, FileChannel channel) implements Closeable {

        static Table open(Path file, long length, String header) throws IOException {
            Table table = new Table(file, FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE));
            try {
                table.start(length, header);
                return table;
            } catch (IOException | RuntimeException e) {
                try (table) {
                    throw e;
                }
            }
        }

        private void start(long length, String header) throws IOException {
            channel.truncate(length);
            channel.position(length);
            if (length == 0) {
                write(header.getBytes(StandardCharsets.UTF_8));
                channel.force(true);
            }
        }

        void write(byte[] bytes) throws IOException {
            ByteBuffer buffer = ByteBuffer.wrap(bytes);
            try {
                while (buffer.hasRemaining()) {
                    channel.write(buffer);
                }
            } catch (IOException e) {
                throw MessageException.ofWriting(file, e);
            }
        }

        /** Also fails if the file has been deleted, because the rows would be lost at the end. */
        void force() throws IOException {
            try {
                channel.force(false);
                if (Files.notExists(file)) {
                    throw new NoSuchFileException(file.toString());
                }
            } catch (IOException e) {
                throw MessageException.ofWriting(file, e);
            }
        }

        @Override
        public void close() throws IOException {
            channel.close();
        }
    }
}
