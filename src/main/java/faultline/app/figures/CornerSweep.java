package faultline.app.figures;

import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Beside Fig. 6: where two sensors suffice, over all angles between the walls. */
final class CornerSweep implements Figure {

    private static final double FIRST = 35;
    private static final double LAST = 150;
    private static final double STEP = 5;
    /** Two sensors stand out, and four lie on top of what they agree with. */
    private static final List<Integer> STYLES = List.of(2, 1, 3, 0);

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("angle_deg", "sensors", "error_mm", "distance_rms_mm", "collided");
        List<Mark> marks = new ArrayList<>();
        for (CornerRun.Sensors sensors : CornerRun.Sensors.values()) {
            List<Vec> points = run(sensors, table);
            marks.add(new Mark.Line("", points, STYLES.get(sensors.ordinal())));
            marks.add(new Mark.Points(sensors.title(), points, STYLES.get(sensors.ordinal())));
        }
        Axis x = Axis.linear("angle between the walls (degrees)", 30, LAST);
        Chart chart = new Chart("Distance kept through a corner", x, Axis.linear("distance at the hand-over, error (mm)", -120, 20), marks);
        folder.svg("fig6-angles", Sheet.of(chart, 480, 360));
        folder.csv("fig6-angles", table);
    }

    private static List<Vec> run(CornerRun.Sensors sensors, Table table) {
        List<Vec> points = new ArrayList<>();
        for (double degrees = FIRST; degrees <= LAST; degrees += STEP) {
            Journey journey = CornerRun.of(degrees, sensors);
            points.add(new Vec(degrees, CornerRun.error(journey)));
            table.row(degrees, sensors.fileName(), CornerRun.error(journey), 1000 * journey.result().distanceRms().orElse(Double.NaN),
                    journey.result().collision().isPresent());
        }
        return points;
    }
}
