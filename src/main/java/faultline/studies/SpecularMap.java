package faultline.studies;

import faultline.engine.SimulationSetup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.sensor.SensorSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.world.Obstacle;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Specular reflection: the slants and surfaces at which the robot detects a glossy wall in time. */
final class SpecularMap implements Figure {

    private static final int COLUMNS = 32;
    private static final int ROWS = 15;
    private static final Axis SLANT = Axis.linear("angle of approach from the wall's normal (degrees)", -64, 64);
    private static final Axis SPECULAR = Axis.linear("greatest angle of incidence sent back (degrees)", 0, 30);
    private static final List<String> OUTCOME_NAMES = List.of("aligned with it", "neither", "runs into it");
    private static final SimulationSetup BASE =
            StudyScenarios.load("studies/glossy-wall.xml").setup();

    private static final String CAPTION =
            """
            What becomes of a robot that drives at a glossy wall: n\u00a0=\u00a0%d runs, one a cell, over the angle \
            of approach and the greatest angle of incidence at which the surface sends light back. Above each line, a \
            cone (20\u00b0) of the front sensor or of a corner sensor reaches near enough to the normal of the wall \
            to see it.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("slant_deg", "specular_deg", "outcome");
        List<List<Integer>> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            List<Integer> outcomes = new ArrayList<>();
            for (int column = 0; column < COLUMNS; column++) {
                double slant = SLANT.valueAt((column + 0.5) / COLUMNS);
                double specular = SPECULAR.valueAt((row + 0.5) / ROWS);
                outcomes.add(outcome(slant, specular));
                table.addRow(slant, specular, OUTCOME_NAMES.get(outcomes.get(column)));
            }
            rows.add(outcomes);
        }
        List<Series> series = List.of(
                new Series.Cells(OUTCOME_NAMES, rows),
                visibleBoundary("front sensor sees it", 0, 1),
                visibleBoundary("a corner sensor sees it", 45, 0),
                visibleBoundary("", -45, 0));
        folder.writeChart(
                "specular-map",
                table,
                new Chart("Glossy walls", SLANT, SPECULAR, series),
                520,
                420,
                String.format(Locale.ROOT, CAPTION, COLUMNS * ROWS));
    }

    /**
     * Returns the boundary within which a sensor of a bearing sees the wall, that is, its cone contains an allowed
     * angle to the normal.
     */
    private static Series visibleBoundary(String name, double bearing, int style) {
        double half = StrictMath.toDegrees(SensorSpec.DEFAULT_CONE) / 2;
        return new Series.Line(
                name,
                List.of(
                        new Vector2(bearing - half - 90, 90),
                        new Vector2(bearing - half, 0),
                        new Vector2(bearing + half, 0),
                        new Vector2(bearing + half + 90, 90)),
                style);
    }

    private static int outcome(double slant, double specular) {
        Obstacle wall = SetupVariations.findObstacle(BASE, "wall");
        Pose start = new Pose(BASE.start().x(), BASE.start().y(), StrictMath.PI / 2 + Degrees.toRadians(slant));
        Obstacle glossy = wall.withSpecularAngle(Degrees.toRadians(specular));
        RunTrace trace = RunTrace.simulate(SetupVariations.with(BASE, glossy).withStart(start));
        if (trace.result().collision().isPresent()) {
            return 2;
        }
        return Math.abs(StrictMath.sin(trace.lastPose().heading())) < StrictMath.sin(Degrees.toRadians(2)) ? 0 : 1;
    }
}
