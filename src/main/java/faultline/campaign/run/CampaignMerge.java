package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.io.AtomicFile;
import faultline.io.Message;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/** Merges the parts of a campaign. The table is the same as that of a campaign that was not divided. */
public final class CampaignMerge {

    private final List<ShardFolder> parts;
    private final CampaignPlan plan;
    private final PlannedRows rows;
    /** The manifest of a part. */
    private final CampaignManifest manifest;

    /**
     * A table of a campaign.
     *
     * @param file the function that returns its place in a folder
     * @param header its first line
     * @param complete whether it must have a good row for each run
     */
    private record MergedTable(Function<CampaignFolder, Path> file, String header, boolean complete) {

        static final MergedTable TIMING = new MergedTable(CampaignFolder::timing, RunTable.TIMING_HEADER, false);

        static MergedTable runs(CampaignPlan plan) {
            return new MergedTable(CampaignFolder::runs, ResultColumns.header(plan), true);
        }
    }

    /** A folder that holds a part. */
    private record ShardFolder(CampaignFolder folder, Shard shard) {}

    /**
     * Reads and checks the parts.
     *
     * @param folders the folders of the parts, in any order
     * @throws IOException if they are not all parts of one campaign
     * @throws ScenarioException if the copy of the plan is not valid
     */
    public CampaignMerge(List<CampaignFolder> folders) throws IOException, ScenarioException {
        parts = new ArrayList<>();
        manifest = manifest(folders.get(0));
        for (CampaignFolder folder : folders) {
            CampaignManifest part = manifest(folder);
            if (!manifest.isSameCampaign(part)) {
                throw new IOException(folder + ": this is of another campaign than " + folders.get(0)
                        + ", or was made by another program or with another jar of a controller");
            }
            Shard shard = part.shard()
                    .orElseThrow(() -> new IOException(folder + ": campaign.json does not say which part this is"));
            parts.add(new ShardFolder(folder, shard));
        }
        plan = folders.get(0).readPlan();
        rows = new PlannedRows(plan);
        // A part without runs begins where the next one does, and comes before it.
        parts.sort(Comparator.<ShardFolder>comparingLong(part -> part.shard.firstRun(plan.runCount()))
                .thenComparingLong(part -> part.shard.endRun(plan.runCount())));
        checkWhole();
    }

    private static CampaignManifest manifest(CampaignFolder folder) throws IOException {
        return folder.readManifest().orElseThrow(() -> new IOException(folder + ": there is no campaign"));
    }

    /** Checks that every run is in exactly one part. */
    private void checkWhole() throws IOException {
        long next = 0;
        ShardFolder last = null;
        for (ShardFolder part : parts) {
            long first = part.shard.firstRun(plan.runCount());
            if (first < next && part.shard.equals(last.shard)) {
                boolean same = part.folder.toString().equals(last.folder.toString());
                throw new IOException(part.folder
                        + (same ? ": this folder is given twice" : ": this is the same part as " + last.folder));
            }
            if (first != next) {
                throw new IOException(part.folder + ": its runs begin with " + first + ", but run " + next
                        + (first > next ? " is in no part" : " comes next after the other parts"));
            }
            next = part.shard.endRun(plan.runCount());
            last = part;
        }
        if (next != plan.runCount()) {
            throw new IOException("the runs from " + next + " to " + (plan.runCount() - 1) + " are in no part");
        }
    }

    /**
     * Writes the whole campaign to a folder.
     *
     * @param out the folder, which must not contain a campaign
     * @return the number of runs, and the number of those that failed
     * @throws IOException if a part is not finished, or the folder cannot be used
     */
    public CampaignRunner.RunCounts writeTo(CampaignFolder out) throws IOException {
        FileChannel lock = out.lock();
        try (lock) {
            if (out.readManifest().isPresent()) {
                throw new IOException(out + ": there is a campaign already; expected another folder");
            }
            List<Path> inputs = new ArrayList<>();
            for (ShardFolder part : parts) {
                inputs.addAll(part.folder.files());
            }
            out.checkTables(inputs);
            for (ShardFolder part : parts) {
                requireWholeHeader(part);
                requireTimingHeader(part.folder.timing());
            }
            OtherFiles.requireNone(out, plan, mergedTables(out));
            long broken = write(out, MergedTable.runs(plan));
            write(out, MergedTable.TIMING);
            new WorstRuns(plan, out).writeReplays();
            out.writeMerged(plan, manifest);
            return new CampaignRunner.RunCounts(plan.runCount(), plan.runCount(), broken);
        }
    }

    /** Throws an exception if a part has no header: it may have been killed before it wrote one, or made its table. */
    private void requireWholeHeader(ShardFolder part) throws IOException {
        String header = ResultColumns.header(plan);
        String given = firstLine(part.folder.runs());
        RunTable.requireNoOther(header, given, part.folder.runs());
        if (!given.equals(header)) {
            throw new IOException(part.folder + ": part " + part.shard + " has no table; campaign with --shard "
                    + part.shard + " --resume makes it");
        }
    }

    /** Returns the first line of a table, empty if there is no table. */
    private static String firstLine(Path table) throws IOException {
        if (Files.notExists(table)) {
            return "";
        }
        try (LineReader in = new LineReader(table)) {
            return in.next();
        }
    }

    /** Throws an exception if a table of times has another header. Its rows may be lost: they are of no result. */
    private static void requireTimingHeader(Path table) throws IOException {
        RunTable.requireNoOther(RunTable.TIMING_HEADER, firstLine(table), table);
    }

    /** Returns the tables that an interrupted merge of these parts has written; each is complete. */
    private Set<Path> mergedTables(CampaignFolder out) throws IOException {
        Set<Path> merged = new HashSet<>();
        for (MergedTable table : List.of(MergedTable.runs(plan), MergedTable.TIMING)) {
            Path file = table.file.apply(out);
            if (Files.exists(file) && isMerged(file, table)) {
                merged.add(file);
            }
        }
        return merged;
    }

    private boolean isMerged(Path file, MergedTable table) throws IOException {
        try (FileComparison comparison = new FileComparison(file)) {
            concatenate(comparison, table);
            return comparison.isEqual();
        }
    }

    private long write(CampaignFolder target, MergedTable table) throws IOException {
        try (AtomicFile out = AtomicFile.create(table.file.apply(target))) {
            long broken = concatenate(out.stream(), table);
            out.commit();
            return broken;
        }
    }

    /** Writes the tables of the parts, one below the other, and returns the number of runs that failed. */
    private long concatenate(OutputStream out, MergedTable table) throws IOException {
        long broken = 0;
        out.write(table.header.getBytes(StandardCharsets.UTF_8));
        for (ShardFolder part : parts) {
            Path file = table.file.apply(part.folder);
            if (table.complete) {
                long first = part.shard.firstRun(plan.runCount());
                long end = part.shard.endRun(plan.runCount());
                broken += new TableCopy(file, out).copyChecked(rows, first, end, part);
            } else if (Files.exists(file)) {
                new TableCopy(file, out).copy();
            }
        }
        return broken;
    }

    /** Copies the rows of one table. */
    private record TableCopy(Path file, OutputStream out) {

        void copy() throws IOException {
            try (LineReader in = new LineReader(file)) {
                in.next();
                while (in.next().endsWith("\n")) {
                    out.write(in.bytes());
                }
            }
        }

        /** Copies the rows of all runs of a part, and returns the number of those that failed. */
        long copyChecked(PlannedRows rows, long first, long end, ShardFolder part) throws IOException {
            long next = first;
            long broken = 0;
            try (LineReader in = new LineReader(file)) {
                int outcome = Csv.cells(in.next().strip()).indexOf("outcome");
                for (String line = in.next(); line.endsWith("\n"); line = in.next()) {
                    List<String> cells = Csv.cells(line.stripTrailing());
                    if (next >= end) {
                        throw wrong(next - first, ResultsProblem.TOO_MANY_ROWS.with(end - first));
                    }
                    if (!in.isText()) {
                        throw wrong(next - first, ResultsProblem.NOT_TEXT.with());
                    }
                    Optional<Message> problem = rows.findProblem(cells, next);
                    if (problem.isPresent()) {
                        throw wrong(next - first, problem.get());
                    }
                    broken += cells.get(outcome).equals(Outcome.BROKEN) ? 1 : 0;
                    out.write(in.bytes());
                    next++;
                }
            }
            if (next != end) {
                throw new IOException(part.folder + ": part " + part.shard + " has " + (next - first) + " of "
                        + (end - first) + " runs; campaign with --shard " + part.shard + " --resume makes the rest");
            }
            return broken;
        }

        /** Returns an exception for a row, counted from 0 below the header. */
        private IOException wrong(long row, Message problem) {
            return new IOException(file + ":" + (row + 2) + ": " + problem);
        }
    }
}
