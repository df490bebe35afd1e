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
    /** The manifest of a part. */
    private final CampaignManifest manifest;

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
        for (ShardFolder part : parts) {
            long first = part.shard.firstRun(plan.runCount());
            if (first != next) {
                throw new IOException(part.folder + ": its runs begin with " + first + ", but run " + next
                        + (first > next ? " is in no part" : " comes next after the other parts"));
            }
            next = part.shard.endRun(plan.runCount());
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
            long broken = write(out.runs(), CampaignFolder::runs, true);
            write(out.timing(), CampaignFolder::timing, false);
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
        if (isMerged(out.runs(), CampaignFolder::runs, true)) {
            merged.add(out.runs());
        }
        if (isMerged(out.timing(), CampaignFolder::timing, false)) {
            merged.add(out.timing());
        }
        return merged;
    }

    private boolean isMerged(Path file, Function<CampaignFolder, Path> table, boolean complete) throws IOException {
        if (Files.notExists(file)) {
            return false;
        }
        try (FileComparison comparison = new FileComparison(file)) {
            concatenate(comparison, table, complete);
            return comparison.isEqual();
        }
    }

    private long write(Path target, Function<CampaignFolder, Path> table, boolean complete) throws IOException {
        try (AtomicFile out = AtomicFile.create(target)) {
            long broken = concatenate(out.stream(), table, complete);
            out.commit();
            return broken;
        }
    }

    private long concatenate(OutputStream out, Function<CampaignFolder, Path> table, boolean complete)
            throws IOException {
        long broken = 0;
        String header = complete ? ResultColumns.header(plan) : RunTable.TIMING_HEADER;
        out.write(header.getBytes(StandardCharsets.UTF_8));
        for (ShardFolder part : parts) {
            long first = part.shard.firstRun(plan.runCount());
            long end = part.shard.endRun(plan.runCount());
            Path file = table.apply(part.folder);
            if (complete || Files.exists(file)) {
                broken += new TableCopy(file, out).copy(first, end, complete, part);
            }
        }
        return broken;
    }

    /** Copies the rows of one table. */
    private record TableCopy(Path file, OutputStream out) {

        long copy(long first, long end, boolean complete, ShardFolder part) throws IOException {
            long next = first;
            long broken = 0;
            try (LineReader in = new LineReader(file)) {
                List<String> names = Csv.cells(in.next().strip());
                int outcome = names.indexOf("outcome");
                for (String line = in.next(); line.endsWith("\n"); line = in.next()) {
                    if (complete) {
                        List<String> cells = Csv.cells(line.stripTrailing());
                        requireGood(names, cells, next, next - first, end - first);
                        if (!in.isText()) {
                            throw wrong(next - first, ResultsProblem.NOT_TEXT.with().toString());
                        }
                        broken += cells.get(outcome).equals(Outcome.BROKEN) ? 1 : 0;
                    }
                    out.write(in.bytes());
                    next++;
                }
            }
            if (complete && next != end) {
                throw new IOException(part.folder + ": part " + part.shard + " has " + (next - first) + " of "
                        + (end - first) + " runs; campaign with --shard " + part.shard + " --resume makes the rest");
            }
            return broken;
        }

        private void requireGood(List<String> names, List<String> cells, long run, long row, long rows)
                throws IOException {
            if (row >= rows) {
                throw wrong(row, ResultsProblem.TOO_MANY_ROWS.with(rows).toString());
            }
            Optional<Message> problem = RowCheck.findProblem(names, cells, run);
            if (problem.isPresent()) {
                throw wrong(row, problem.get().toString());
            }
        }

        /** Returns an exception for a row, counted from 0 below the header. */
        private IOException wrong(long row, String problem) {
            return new IOException(file + ":" + (row + 2) + ": " + problem);
        }
    }
}
