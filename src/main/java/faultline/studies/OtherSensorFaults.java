package faultline.studies;

import faultline.control.FollowerState;
import faultline.control.TimingRule;
import faultline.engine.SimulationSetup;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.world.Command;
import java.io.IOException;
import java.util.List;

/**
 * The paper's claim that t_D does not depend on other sensors: every other sensor fails in four ways, once from the
 * beginning of the spin, and once from the start of the run, where the robot may stop at another place.
 */
final class OtherSensorFaults implements Figure {

    private static final List<FaultKind> KINDS =
            List.of(FaultKind.OFF, FaultKind.STUCK, FaultKind.BIAS, FaultKind.DROPOUT);

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable(
                "timing",
                "failed_sensor",
                "fault",
                "t_D_s",
                "same_bits",
                "t_D_s_failed_from_the_start",
                "same_bits_from_the_start");
        for (TimingRule timing : TimingRule.values()) {
            AlignmentTrial trial = AlignmentTrial.standard(timing, 0);
            double sound = trial.run().orElseThrow().tD();
            table.addRow(timing.fileName(), "none", "none", sound, true, sound, true);
            trial.robot().sensors().stream()
                    .filter(sensor -> !sensor.id().equals("left"))
                    .forEach(sensor -> addRows(table, trial, sound, sensor));
        }
        folder.writeCsv("eq4-other-sensors", table);
    }

    private static void addRows(CsvTable table, AlignmentTrial trial, double sound, SensorSpec sensor) {
        double spin = alignmentStart(trial.setup());
        for (FaultKind kind : KINDS) {
            Command fault = new Command.InjectFault(sensor.id(), kind.createFault(kind.defaultValue()));
            double late = measureTD(withFault(trial.setup(), spin, fault));
            double early = measureTD(withFault(trial.setup(), 0, fault));
            table.addRow(
                    trial.timing().fileName(),
                    sensor.id(),
                    kind.fileName(),
                    late,
                    isSame(late, sound),
                    early,
                    isSame(early, sound));
        }
    }

    private static boolean isSame(double value, double sound) {
        return !Double.isNaN(value) && Double.doubleToLongBits(value) == Double.doubleToLongBits(sound);
    }

    private static SimulationSetup withFault(SimulationSetup setup, double at, Command fault) {
        return setup.withTimeline(List.of(new SimulationSetup.TimedCommand(at, fault)));
    }

    private static double alignmentStart(SimulationSetup setup) {
        RunTrace trace = RunTrace.simulate(setup.withDuration(10));
        return trace.states().indexOf(FollowerState.TURN) * setup.dt();
    }

    /** Returns the time between F3 and F4 at the end of ALIGN, NaN if it never ends. */
    private static double measureTD(SimulationSetup setup) {
        return new AlignmentTrial(setup, 1)
                .run()
                .map(AlignmentTrial.TrialResult::tD)
                .orElse(Double.NaN);
    }
}
