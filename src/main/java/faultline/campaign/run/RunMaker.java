package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlanFiles;
import faultline.campaign.plan.PlannedRun;
import faultline.engine.ControllerMode;
import faultline.engine.RunFailedException;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.DiagnosisMetrics;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.engine.metrics.WallCircuits;
import faultline.scenario.xml.Problem;
import faultline.scenario.xml.ScenarioException;
import java.util.List;
import java.util.concurrent.CancellationException;

/** Makes single runs of a plan; safe on any thread. */
final class RunMaker {

    private static final double NANOS_PER_SECOND = 1e9;

    private final CampaignPlan plan;
    private final WallCircuits circuits = new WallCircuits();

    /**
     * A completed run: its index, its row of {@code runs.csv}, whether it failed, its number of ticks, and the elapsed
     * time, seconds.
     */
    record MadeRun(long index, String row, boolean broken, long ticks, double seconds) {}

    RunMaker(CampaignPlan plan) {
        this.plan = plan;
    }

    /**
     * Makes a run. If it fails, its row gives the reason.
     *
     * @throws RunFailedException if the controller runs out of memory
     * @throws CancellationException if this thread is interrupted during the run
     */
    MadeRun make(long index) {
        PlannedRun run = plan.run(index);
        long start = System.nanoTime();
        try {
            SimulationSetup setup = plan.scenario(run).setup();
            CarryOnMetrics carry = new CarryOnMetrics(setup, circuits.forCarryOn(setup));
            DiagnosisMetrics diagnosis = new DiagnosisMetrics(setup);
            boolean untilVerdict = plan.header().untilVerdict();
            RunResult result = HeadlessRun.run(
                    setup,
                    ControllerMode.DIRECT,
                    List.of(Simulation::stopRecordingPath, Simulation::stopRecordingDecisions, carry, diagnosis),
                    () -> untilVerdict && carry.isDecided()
                            || Thread.currentThread().isInterrupted());
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException();
            }
            String row = ResultColumns.row(run, result, carry, diagnosis);
            return new MadeRun(index, row, false, result.ticks(), secondsSince(start));
        } catch (ScenarioException e) {
            return broken(run, describe(run, e.problems().get(0)), start);
        } catch (CancellationException e) {
            throw e;
        } catch (RuntimeException e) {
            if (e.getCause() instanceof OutOfMemoryError error) {
                if (e instanceof RunFailedException failed && failed.isOfController()) {
                    throw failed;
                }
                throw error;
            }
            return broken(run, String.valueOf(e.getMessage()), start);
        }
    }

    /**
     * Describes a problem of a run with its location in the plan, if it has one. Names the plan as in its copy, so that
     * a row does not depend on the path under which the plan was read.
     */
    private String describe(PlannedRun run, Problem problem) {
        return plan.hasLocationOf(run, problem)
                ? new Problem(PlanFiles.COPY, problem.location(), problem.message()).toString()
                : problem.message().toString();
    }

    private static MadeRun broken(PlannedRun run, String why, long start) {
        return new MadeRun(run.index(), ResultColumns.brokenRow(run, why), true, 0, secondsSince(start));
    }

    private static double secondsSince(long start) {
        return (System.nanoTime() - start) / NANOS_PER_SECOND;
    }
}
