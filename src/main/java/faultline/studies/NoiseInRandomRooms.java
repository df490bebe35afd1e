package faultline.studies;

import faultline.campaign.RandomRoom;
import faultline.engine.SimulationSetup;
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

/** Following with noisy sensors in random rooms: the distance error, coverage and collisions. */
final class NoiseInRandomRooms implements Figure {

    private static final List<Integer> NOISE_MM = List.of(0, 1, 4, 10);
    private static final int ROOMS = 60;
    private static final long FIRST_ROOM = 5001;
    private static final double SECONDS = 60;
    private static final SimulationSetup BASE = SetupVariations.withoutDiagnosis(
            StudyScenarios.load("noisy-sensors.xml").setup());

    private static final String CAPTION =
            """
            The distance error on straight walls with noise on all sensors: %d random rooms, each with noise of 0, 1, \
            4 and 10 mm, followed for 60 s; n\u00a0=\u00a0%d runs, one a marker. Dashed: half of the noise.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("noise_mm", "room", "straight_rms_mm", "follow_rms_mm", "coverage", "collided");
        List<Vector2> errors = new ArrayList<>();
        for (int noise : NOISE_MM) {
            for (long room = FIRST_ROOM; room < FIRST_ROOM + ROOMS; room++) {
                RunTrace trace = run(room, noise / 1000.0);
                double straight = 1000 * trace.result().distanceRms().orElse(Double.NaN);
                table.addRow(
                        noise,
                        room,
                        straight,
                        1000 * trace.result().followRmsOrNaN(),
                        trace.result().coverage().orElse(Double.NaN),
                        trace.result().collision().isPresent());
                errors.add(new Vector2(noise, straight));
            }
        }
        Chart chart = new Chart(
                "Following in " + ROOMS + " random rooms",
                Axis.linear("standard deviation of the noise (mm)", 0, 10),
                Axis.covering(
                        "distance error on straight walls, RMS (mm)",
                        DoubleStream.concat(DoubleStream.of(0), errors.stream().mapToDouble(Vector2::y))),
                List.of(
                        new Series.Line("half of the noise", List.of(Vector2.ZERO, new Vector2(10, 5)), 1),
                        new Series.Points("runs", errors, 0)));
        folder.writeChart(
                "noise-rooms", table, chart, 480, 360, String.format(Locale.ROOT, CAPTION, ROOMS, errors.size()));
    }

    private static RunTrace run(long seed, double noise) {
        RandomRoom room = RandomRoom.ofSeed(seed);
        return RunTrace.simulate(SetupVariations.withNoise(BASE, noise)
                .withWorld(room.world())
                .withStart(room.start())
                .withSeed(seed)
                .withDuration(SECONDS));
    }
}
