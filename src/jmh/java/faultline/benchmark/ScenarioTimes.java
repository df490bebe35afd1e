package faultline.benchmark;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.scenario.Scenario;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;

/**
 * Prints the processor time of a tick in scenario files once the virtual machine is warm, from the start of the run.
 * The scenarios are measured in turn, so that all are disturbed alike.
 *
 * <p>Arguments: the simulated seconds of a run, and the files.
 */
public final class ScenarioTimes {

    private static final int WARM_UP = 5;
    private static final int PASSES = 15;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private ScenarioTimes() {}

    /**
     * Measures the scenarios.
     *
     * @param args the seconds, and the files
     * @throws Exception if a file cannot be read
     */
    public static void main(String[] args) throws Exception {
        double seconds = Double.parseDouble(args[0]);
        String[] files = Arrays.copyOfRange(args, 1, args.length);
        SimulationSetup[] setups = new SimulationSetup[files.length];
        for (int i = 0; i < files.length; i++) {
            setups[i] = Scenario.load(Path.of(files[i])).setup();
        }
        double[][] times = new double[files.length][PASSES];
        for (int pass = -WARM_UP; pass < PASSES; pass++) {
            for (int i = 0; i < files.length; i++) {
                double time = tickTime(setups[i], Math.round(seconds / setups[i].dt()));
                times[i][Math.max(0, pass)] = time;
            }
        }
        for (int i = 0; i < files.length; i++) {
            Arrays.sort(times[i]);
            System.out.println(String.format(
                    Locale.ROOT, "%-40s %8.3f us, least %.3f us", files[i], times[i][PASSES / 2], times[i][0]));
        }
    }

    /** Returns the mean time of the first ticks of a run, microseconds. */
    private static double tickTime(SimulationSetup setup, long ticks) {
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        simulation.stopRecordingPath();
        long before = THREADS.getCurrentThreadCpuTime();
        for (long tick = 0; tick < ticks; tick++) {
            simulation.tick();
        }
        return (THREADS.getCurrentThreadCpuTime() - before) / 1e3 / ticks;
    }
}
