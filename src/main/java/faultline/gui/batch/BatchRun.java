package faultline.gui.batch;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.report.CampaignCell;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.ResultColumns;
import faultline.campaign.run.Shard;
import faultline.gui.document.TaskProgress;
import faultline.io.AtomicFolder;
import faultline.io.TemporaryFolder;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;

/**
 * Makes the runs of a batch in a temporary folder. {@link #make} is called on a background thread; everything else is
 * safe on any thread.
 */
final class BatchRun {

    /** The cells are computed again at most this often, and for at most a tenth of the time, nanoseconds. */
    private static final long CELL_INTERVAL = 400_000_000;

    private static final int CELL_COST_FACTOR = 10;

    private final BatchPlan batch;
    private final int jobs;
    private volatile TaskProgress progress = new TaskProgress();
    private final Queue<List<String>> newRows = new ConcurrentLinkedQueue<>();
    /** The cells of the header and of the rows. */
    private final List<List<String>> lines = new ArrayList<>();

    private volatile TemporaryFolder temporary;
    private volatile Path folder;
    private volatile CampaignPlan plan;
    private volatile List<CampaignCell> cells = List.of();
    private volatile long repeatCount;
    private volatile Completion completion = new Completion(0, 0, 0);
    /** The time at which the cells are computed next, on the clock of {@link System#nanoTime}. */
    private long nextCells = System.nanoTime();

    /**
     * The number of runs in the table, the total number, 0 while it is unknown, and the seconds since the first run
     * began.
     */
    record Completion(long made, long runs, double seconds) {

        /** Returns the seconds that the rest will take if it is as fast as the runs so far, NaN before the first. */
        double secondsLeft() {
            return made == 0 ? Double.NaN : seconds / made * (runs - made);
        }
    }

    BatchRun(BatchPlan batch, int jobs) {
        this.batch = batch;
        this.jobs = jobs;
    }

    /** Returns the progress, by which the batch is cancelled. */
    TaskProgress progress() {
        return progress;
    }

    /** Lets the next call of {@link #make} make the other runs of a batch that has been cancelled and has ended. */
    void prepareToContinue() {
        progress = new TaskProgress();
    }

    /** Returns the plan; null until it has been read. */
    CampaignPlan planOrNull() {
        return plan;
    }

    Completion completion() {
        return completion;
    }

    /** Returns the newest cells. */
    List<CampaignCell> cells() {
        return cells;
    }

    /** Returns the number of runs that repeat an earlier one with another seed; 0 until the batch has ended. */
    long repeatCount() {
        return repeatCount;
    }

    /**
     * Returns the cells of the next row that has not been taken yet; null if there is none now. If an earlier row was
     * of the same run, this one replaces it, and all rows after it are void: they were not in the table any more when
     * the batch was continued.
     */
    List<String> takeRow() {
        return newRows.poll();
    }

    /** Thrown if a batch cannot be continued, because its controllers or the program have changed. */
    static final class ChangedException extends IOException {
        ChangedException() {
            super("the program or a controller has changed");
        }
    }

    /**
     * Makes the runs that have not been made; if the batch is cancelled, the rows in the table are kept.
     *
     * @throws ScenarioException with everything that is wrong with the plan
     * @throws ChangedException if the runs that have been made are those of other controllers or another program
     * @throws IOException if the temporary folder cannot be used
     */
    CampaignRunner.RunCounts make() throws IOException, ScenarioException {
        boolean resume = plan != null;
        if (!resume) {
            prepare();
        }
        CampaignFolder made = new CampaignFolder(results());
        if (resume && Files.exists(made.runs()) && !made.isOfThisProgram(plan)) {
            throw new ChangedException();
        }
        CampaignRunner runner = new CampaignRunner(plan, made, Shard.ALL, jobs);
        CampaignRunner.RunCounts result = runner.run(resume, new RowCollector(), () -> !progress.isActive());
        keepRows(result.made());
        cells = BatchResults.cellsOf(plan, lines);
        repeatCount = CampaignCell.repeatCount(plan, lines);
        return result;
    }

    private void prepare() throws IOException, ScenarioException {
        temporary = TemporaryFolder.create("faultline-batch-");
        folder = temporary.path();
        CampaignPlan read = batch.prepare(folder);
        lines.add(ResultColumns.of(read).stream().map(column -> column.name()).toList());
        completion = new Completion(0, read.runCount(), 0);
        plan = read;
    }

    /** Forgets all rows but the first ones. After a disk was full, for example, rows can be missing in the table. */
    private void keepRows(long count) {
        if (count < lines.size() - 1) {
            lines.subList((int) count + 1, lines.size()).clear();
        }
    }

    /** Returns the folder of the tables. */
    Path results() {
        return folder.resolve("results");
    }

    /** Collects the rows as they are written. */
    private final class RowCollector implements CampaignRunner.Progress {
        /** The time at which the first run would have begun if all had been made at once. */
        private final long start = System.nanoTime() - Math.round(completion.seconds() * 1e9);

        @Override
        public void rowAdded(List<String> cells) {
            keepRows(Long.parseLong(cells.get(0)));
            lines.add(cells);
            newRows.add(cells);
        }

        @Override
        public void update(long made, long runs) {
            long now = System.nanoTime();
            completion = new Completion(made, runs, (now - start) / 1e9);
            if (now - nextCells >= 0) {
                cells = BatchResults.cellsOf(plan, lines);
                long end = System.nanoTime();
                nextCells = end + Math.max(CELL_INTERVAL, CELL_COST_FACTOR * (end - now));
            }
        }
    }

    /**
     * Copies the tables, the plan and the replays to a folder, which is there only with all of them. The batch must
     * have ended.
     *
     * @throws IOException if a file cannot be written
     */
    void saveResults(Path target) throws IOException {
        List<Path> files = new CampaignFolder(results()).files();
        AtomicFolder.copy(results(), files.stream().filter(Files::exists).toList(), target);
    }

    /** Deletes the temporary folder, after the batch has ended. */
    void delete() throws IOException {
        if (temporary != null) {
            temporary.delete();
        }
    }
}
