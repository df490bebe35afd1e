package faultline.studies;

import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Beside Fig. 6: where two sensors suffice, over all angles between the walls. */
final class CornerAngleSweep implements Figure {

    private static final double FIRST_ANGLE = 35;
    private static final double LAST_ANGLE = 150;
    private static final double ANGLE_STEP = 5;
    /** Two sensors stand out, and four lie on top of what they agree with. */
    private static final List<Integer> STYLES = List.of(2, 1, 3, 0);

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("angle_deg", "sensors", "error_mm", "distance_rms_mm", "collided");
        List<Series> marks = new ArrayList<>();
        for (CornerRun.SensorSelection sensors : CornerRun.SensorSelection.values()) {
            List<Vector2> points = runAll(sensors, table);
            marks.add(new Series.Line("", points, STYLES.get(sensors.ordinal())));
            marks.add(new Series.Points(sensors.title(), points, STYLES.get(sensors.ordinal())));
        }
        Axis x = Axis.linear("angle between the walls (degrees)", 30, LAST_ANGLE);
        Chart chart = new Chart(
                "Distance kept through a corner",
                x,
                Axis.linear("distance at the hand-over, error (mm)", -120, 20),
                marks);
        folder.writeSvg("fig6-angles", FigureCanvas.drawChart(chart, 480, 360));
        folder.writeCsv("fig6-angles", table);
    }

    private static List<Vector2> runAll(CornerRun.SensorSelection sensors, CsvTable table) {
        List<Vector2> points = new ArrayList<>();
        for (double degrees = FIRST_ANGLE; degrees <= LAST_ANGLE; degrees += ANGLE_STEP) {
            RunTrace journey = CornerRun.run(degrees, sensors);
            points.add(new Vector2(degrees, CornerRun.distanceError(journey)));
            table.addRow(
                    degrees,
                    sensors.fileName(),
                    CornerRun.distanceError(journey),
                    1000 * journey.result().distanceRms().orElse(Double.NaN),
                    journey.result().collision().isPresent());
        }
        return points;
    }
}
