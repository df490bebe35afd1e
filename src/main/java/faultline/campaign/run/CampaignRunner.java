package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.engine.RunFailedException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;

/** Makes a part of a campaign. Several threads make the runs, and the calling thread writes the rows in order. */
public final class CampaignRunner {

    /** The maximum number of threads that a user may ask for. */
    public static final int MAX_JOBS = 1024;

    /** The number of runs per thread that may be finished before the next one in the table. */
    private static final int RUNS_AHEAD = 16;

    /** The longest interval between two checks for cancellation, milliseconds. */
    private static final long CANCEL_INTERVAL = 50;

    /** The minimum time between two times at which rows are forced to the disk, nanoseconds. */
    private static final long FORCE_INTERVAL = 200_000_000;

    private final CampaignPlan plan;
    private final CampaignFolder folder;
    private final Shard shard;
    private final int jobs;

    /**
     * The result of a part of a campaign.
     *
     * @param made the number of its runs in the table
     * @param runs the number of its runs
     * @param broken the number of failed runs in the table
     */
    public record RunCounts(long made, long runs, long broken) {

        /** {@return whether every run is in the table} */
        public boolean isComplete() {
            return made == runs;
        }
    }

    /** A listener that is called for each row that is written. */
    public interface Progress {

        /**
         * Called on the thread that writes.
         *
         * @param made the number of runs in the table
         * @param runs the number of runs of this part
         */
        void update(long made, long runs);

        /**
         * Called on the thread that writes, before {@link #update}, with each new row of {@code runs.csv}.
         *
         * @param cells the cells of the row
         */
        default void rowAdded(List<String> cells) {}
    }

    /**
     * Creates a runner.
     *
     * @param plan the plan
     * @param folder the folder of the tables
     * @param shard the part of the campaign
     * @param jobs the number of threads, at least 1
     */
    public CampaignRunner(CampaignPlan plan, CampaignFolder folder, Shard shard, int jobs) {
        this.plan = plan;
        this.folder = folder;
        this.shard = shard;
        this.jobs = jobs;
    }

    /**
     * Makes all runs that are not in the table yet.
     *
     * @param resume whether the folder may contain a partial campaign
     * @param progress the listener, called for each row
     * @param cancelled whether to stop; polled between runs and while waiting for one. If true, the rows reported so
     *     far are written, and all other runs are stopped. Of these, some may have ended before the next one in the
     *     table; they are made again when the campaign is resumed
     * @return the state of the table
     * @throws IOException if the folder cannot be used
     */
    public RunCounts run(boolean resume, Progress progress, BooleanSupplier cancelled) throws IOException {
        long first = shard.firstRun(plan.runCount());
        long end = shard.endRun(plan.runCount());
        FileChannel lock = folder.lock();
        try (lock) {
            folder.prepare(plan, shard, resume);
            RunTable.RowRule rule = new PlannedRows(plan)::findProblem;
            try (RunTable table = new RunTable(folder, ResultColumns.header(plan), rule, first, end)) {
                makeRuns(table, first, end, progress, cancelled);
                table.force();
                RunCounts result = new RunCounts(table.next() - first, end - first, table.broken());
                if (result.isComplete()) {
                    new WorstRuns(plan, folder).writeReplays();
                }
                return result;
            }
        }
    }

    private void makeRuns(RunTable table, long first, long end, Progress progress, BooleanSupplier cancelled)
            throws IOException {
        RunMaker maker = new RunMaker(plan);
        ExecutorService pool = Executors.newFixedThreadPool(jobs, CampaignRunner::newDaemonThread);
        Deque<Future<RunMaker.MadeRun>> ahead = new ArrayDeque<>();
        long submitted = table.next();
        long forced = System.nanoTime();
        try {
            while (table.next() < end && !cancelled.getAsBoolean()) {
                while (submitted < end && ahead.size() < jobs * RUNS_AHEAD) {
                    long index = submitted++;
                    ahead.add(pool.submit(() -> maker.make(index)));
                }
                boolean waiting = !ahead.peek().isDone();
                if (waiting) {
                    table.flush();
                }
                if (waiting && System.nanoTime() - forced > FORCE_INTERVAL) {
                    table.force();
                    forced = System.nanoTime();
                }
                if (waiting && !endsSoon(ahead.peek())) {
                    continue;
                }
                RunMaker.MadeRun made = get(ahead.poll());
                table.add(made);
                progress.rowAdded(Csv.cells(made.row().stripTrailing()));
                progress.update(table.next() - first, end - first);
            }
        } finally {
            pool.shutdownNow();
        }
    }

    private static Thread newDaemonThread(Runnable task) {
        Thread thread = new Thread(task, "campaign");
        thread.setDaemon(true);
        return thread;
    }

    /** Waits for a run until the next check for cancellation; returns whether the run has ended. */
    private static boolean endsSoon(Future<RunMaker.MadeRun> run) {
        try {
            run.get(CANCEL_INTERVAL, TimeUnit.MILLISECONDS);
            return true;
        } catch (TimeoutException e) {
            return false;
        } catch (ExecutionException e) {
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return true;
        }
    }

    private static RunMaker.MadeRun get(Future<RunMaker.MadeRun> run) {
        try {
            return run.get();
        } catch (ExecutionException e) {
            if (e.getCause() instanceof OutOfMemoryError error) {
                throw error;
            }
            if (e.getCause() instanceof RunFailedException failed) {
                throw failed;
            }
            throw new IllegalStateException("a run could not be made: " + e.getCause(), e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the campaign was interrupted", e);
        }
    }
}
