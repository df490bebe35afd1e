package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import faultline.campaign.plan.PlannedRun;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.CarryOnMetrics;
import faultline.engine.metrics.DiagnosisMetrics;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.engine.metrics.WallCircuit;
import faultline.scenario.xml.ScenarioException;
import faultline.world.WorldSpec;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/** Makes single runs of a plan; safe on any thread. */
final class RunMaker {

    private static final int MAX_CIRCUITS = 16;
    private static final double NANOS_PER_SECOND = 1e9;

    private final CampaignPlan plan;
    private final Map<CircuitKey, WallCircuit> circuits = new LinkedHashMap<>(MAX_CIRCUITS, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<CircuitKey, WallCircuit> eldest) {
            return size() > MAX_CIRCUITS;
        }
    };

    private record CircuitKey(WorldSpec world, double distance) {}

    /**
     * A run that was made.
     *
     * @param index of the run
     * @param row of {@code runs.csv}
     * @param broken whether the run broke
     * @param ticks how many it made
     * @param seconds how long it took
     */
    record MadeRun(long index, String row, boolean broken, long ticks, double seconds) {}

    RunMaker(CampaignPlan plan) {
        this.plan = plan;
    }

    /** Makes a run. One that breaks gives a row that says why. */
    MadeRun make(long index) {
        PlannedRun run = plan.run(index);
        long start = System.nanoTime();
        try {
            SimulationSetup setup = plan.scenario(run).setup();
            CarryOnMetrics carry = new CarryOnMetrics(setup, circuit(setup));
            DiagnosisMetrics diagnosis = new DiagnosisMetrics(setup);
            boolean untilVerdict = plan.header().untilVerdict();
            RunResult result = HeadlessRun.run(
                    setup, ControllerMode.DIRECT, List.of(carry, diagnosis), () -> untilVerdict && carry.isDecided());
            String row = ResultColumns.row(run, result, carry, diagnosis);
            return new MadeRun(index, row, false, result.ticks(), secondsSince(start));
        } catch (ScenarioException e) {
            return broken(run, e.problems().get(0).toString(), start);
        } catch (RuntimeException e) {
            return broken(run, String.valueOf(e.getMessage()), start);
        }
    }

    private static MadeRun broken(PlannedRun run, String why, long start) {
        return new MadeRun(run.index(), ResultColumns.brokenRow(run, why), true, 0, secondsSince(start));
    }

    private static double secondsSince(long start) {
        return (System.nanoTime() - start) / NANOS_PER_SECOND;
    }

    private WallCircuit circuit(SimulationSetup setup) {
        OptionalDouble wanted = CarryOnMetrics.wantedDistance(setup);
        if (wanted.isEmpty()) {
            return WallCircuit.empty();
        }
        double distance = wanted.getAsDouble();
        CircuitKey key = new CircuitKey(setup.world(), distance);
        synchronized (circuits) {
            WallCircuit known = circuits.get(key);
            if (known != null) {
                return known;
            }
        }
        WallCircuit circuit = new WallCircuit(setup.world(), distance);
        synchronized (circuits) {
            circuits.put(key, circuit);
        }
        return circuit;
    }
}
