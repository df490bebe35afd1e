package faultline.studies;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;

/** The noise study: following with noisy sensors in the room of a shipped scenario. */
final class NoiseWhileFollowing implements Figure {

    private static final String SCENARIO = "noisy-sensors.xml";
    private static final int STEPS = 13;
    private static final int SEEDS = 12;

    private static final String CAPTION =
            """
            The distance error on straight walls of scenarios/%s with noise on all sensors; n\u00a0=\u00a0%d runs, \
            one a marker for each seed from 1 to %d. Dashed: half of the noise.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("noise_mm", "seed", "distance_rms_mm", "coverage", "collided");
        List<Vector2> errors = new ArrayList<>();
        for (int millimetres = 0; millimetres < STEPS; millimetres++) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                RunResult result = HeadlessRun.run(
                        withNoise(millimetres / 1000.0).withSeed(seed), ControllerMode.DIRECT, List.of());
                double rms = 1000 * result.distanceRms().orElse(Double.NaN);
                table.addRow(
                        millimetres,
                        seed,
                        rms,
                        result.coverage().orElse(Double.NaN),
                        result.collision().isPresent());
                errors.add(new Vector2(millimetres, rms));
            }
        }
        Axis y = Axis.covering(
                "distance error, RMS (mm)",
                DoubleStream.concat(DoubleStream.of(0), errors.stream().mapToDouble(Vector2::y)));
        Chart chart = new Chart(
                "Following with noisy sensors",
                Axis.linear("standard deviation of the noise (mm)", 0, STEPS - 1),
                y,
                List.of(
                        new Series.Line("half of the noise", List.of(Vector2.ZERO, new Vector2(STEPS, STEPS / 2.0)), 1),
                        new Series.Points("runs", errors, 0)));
        folder.writeChart(
                "noise-following",
                table,
                chart,
                480,
                360,
                String.format(Locale.ROOT, CAPTION, SCENARIO, errors.size(), SEEDS));
    }

    private static SimulationSetup withNoise(double deviation) {
        SimulationSetup setup = StudyScenarios.load(SCENARIO).setup();
        return SetupVariations.withNoise(SetupVariations.withoutDiagnosis(setup), deviation);
    }
}
