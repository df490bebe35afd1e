package faultline.app;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.run.CampaignFolder;
import faultline.campaign.run.CampaignMerge;
import faultline.campaign.run.CampaignRunner;
import faultline.campaign.run.Shard;
import faultline.io.ShutdownHooks;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;

/** {@code campaign} and {@code merge}: makes the runs of a plan, and puts the parts of a divided campaign together. */
final class CampaignCommand {

    private static final List<String> OPTION_NAMES = List.of("--out", "--jobs", "--shard", "--jar");

    /** The time for which the end of the process waits for the last rows, seconds. */
    private static final int STOP_SECONDS = 30;

    private final CommandOutput output;

    CampaignCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, OPTION_NAMES, List.of("--resume"));
        boolean resume = parsed.has("--resume");
        Path file = parsed.singleFile("campaign", "plan");
        Path folder = folder(parsed);
        int jobs = parsed.positive(
                "--jobs", CampaignRunner.MAX_JOBS, Runtime.getRuntime().availableProcessors());
        Shard shard = shard(parsed);
        ControllerOptions.addJar(parsed);
        CampaignPlan plan = PlanFiles.read(file);
        output.printNotes(plan.notes());
        CampaignRunner runner = new CampaignRunner(plan, new CampaignFolder(folder), shard, jobs);
        return run(runner, resume, folder);
    }

    private int run(CampaignRunner runner, boolean resume, Path folder) throws IOException {
        AtomicBoolean cancelled = new AtomicBoolean();
        CountDownLatch ended = new CountDownLatch(1);
        Thread hook = new Thread(() -> cancel(cancelled, ended));
        if (!ShutdownHooks.add(hook)) {
            cancelled.set(true);
        }
        try {
            return report(makeRuns(runner, resume, cancelled), folder);
        } finally {
            ended.countDown();
            ShutdownHooks.remove(hook);
        }
    }

    private CampaignRunner.RunCounts makeRuns(CampaignRunner runner, boolean resume, AtomicBoolean cancelled)
            throws IOException {
        try (TerminalProgress progress = TerminalProgress.on(output.err())) {
            return runner.run(resume, progress::update, cancelled::get);
        }
    }

    /** Waits until the rows in the table are on the disk, because the process ends after this. */
    private static void cancel(AtomicBoolean cancelled, CountDownLatch ended) {
        cancelled.set(true);
        try {
            ended.await(STOP_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private int report(CampaignRunner.RunCounts result, Path folder) {
        if (!result.isComplete()) {
            output.printError("faultline: stopped after " + result.made() + " of " + result.runs()
                    + " runs; --resume makes the rest");
            return ExitCode.RUN_FAILED;
        }
        output.println("campaign: " + folder);
        output.println("runs: " + result.runs());
        output.println("broken: " + result.broken());
        return result.broken() == 0 ? ExitCode.SUCCESS : ExitCode.RUN_FAILED;
    }

    int merge(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, List.of("--out", "--jar"));
        if (parsed.files().isEmpty()) {
            throw new UsageException("merge takes the folders of one or more parts, not none");
        }
        List<CampaignFolder> parts = new ArrayList<>();
        for (String file : parsed.files()) {
            parts.add(new CampaignFolder(Arguments.parsePath(file)));
        }
        Path folder = folder(parsed);
        ControllerOptions.addJar(parsed);
        return report(new CampaignMerge(parts).writeTo(new CampaignFolder(folder)), folder);
    }

    private static Path folder(Arguments parsed) throws UsageException {
        return parsed.fileOption("--out")
                .orElseThrow(() -> new UsageException("--out DIR is missing, the folder that the tables go to"));
    }

    private static Shard shard(Arguments arguments) throws UsageException {
        Optional<String> text = arguments.value("--shard");
        if (text.isEmpty()) {
            return Shard.ALL;
        }
        return Shard.parse(text.get())
                .orElseThrow(
                        () -> UsageException.ofValue("--shard", text.get(), "I/N with I from 1 to N, such as 2/4"));
    }
}
