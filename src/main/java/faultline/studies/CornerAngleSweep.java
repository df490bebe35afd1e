package faultline.studies;

import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.SortedSample;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Fig. 6: the angles between the walls at which two sensors suffice, over many starts. */
final class CornerAngleSweep implements Figure {

    private static final double FIRST_ANGLE = 35;
    private static final double LAST_ANGLE = 145;
    private static final double ANGLE_STEP = 10;
    static final int STARTS = 31;
    /**
     * The styles of the selections: two sensors are emphasised, and four are drawn on top of those with the same
     * results.
     */
    private static final List<Integer> STYLES = List.of(2, 1, 3, 0);

    private static final String CAPTION =
            """
            Fig. 6, all angles. The distance error to the second wall of an inner corner when the robot has been \
            aligned with it, by the sensors that are on. Markers: medians of n\u00a0=\u00a0%d starts; shaded: from \
            the least to the greatest. Positive: too far from the wall; 0 is the wanted distance of 250 mm. Where a \
            marker is missing, no start was aligned.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("angle_deg", "sensors", "starts", "aligned", "median_mm", "min_mm", "max_mm");
        List<Series> series = new ArrayList<>();
        for (CornerRun.SensorSelection sensors : CornerRun.SensorSelection.values()) {
            addSeries(sensors, table, series);
        }
        Chart chart = new Chart(
                "Distance error after a corner: median and range of " + STARTS + " starts",
                Axis.linear("angle between the walls (degrees)", 30, 150),
                Axis.linear("distance error at the hand-over (mm)", -160, 40),
                series);
        folder.writeChart("fig6-angles", table, chart, 520, 380, String.format(Locale.ROOT, CAPTION, STARTS));
    }

    private static void addSeries(CornerRun.SensorSelection sensors, CsvTable table, List<Series> series) {
        List<Vector2> medians = new ArrayList<>();
        List<Vector2> low = new ArrayList<>();
        List<Vector2> high = new ArrayList<>();
        for (double degrees = FIRST_ANGLE; degrees <= LAST_ANGLE; degrees += ANGLE_STEP) {
            SortedSample errors = CornerRun.distanceErrors(degrees, sensors, STARTS);
            table.addRow(
                    degrees, sensors.fileName(), STARTS, errors.size(), errors.median(), errors.min(), errors.max());
            if (errors.size() > 0) {
                medians.add(new Vector2(degrees, errors.median()));
                low.add(new Vector2(degrees, errors.min()));
                high.add(new Vector2(degrees, errors.max()));
            }
        }
        int style = STYLES.get(sensors.ordinal());
        series.add(new Series.Band("", high, low, style));
        series.add(new Series.Line("", medians, style));
        series.add(new Series.Points(sensors.title(), medians, style));
    }
}
