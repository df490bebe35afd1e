package faultline.app.figures;

import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Beside Fig. 6: where two sensors suffice, over all angles between the walls. */
final class CornerSweep implements Figure {

    private static final List<String> NAMES = List.of("left, front", "left, front, front-right", "left, front, both front corners");
    private static final double FIRST = 35;
    private static final double LAST = 150;
    private static final double STEP = 5;

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("angle_deg", "sensors", "error_mm", "distance_rms_mm", "collided");
        List<Mark> marks = new ArrayList<>();
        for (Set<String> sensors : List.of(CornerRun.TWO, CornerRun.THREE, CornerRun.FOUR)) {
            List<Vec> points = run(sensors, table);
            marks.add(new Mark.Line("", points, 4 - sensors.size()));
            marks.add(new Mark.Points(NAMES.get(sensors.size() - 2), points, 4 - sensors.size()));
        }
        Axis x = Axis.linear("angle between the walls (degrees)", 30, LAST);
        Chart chart = new Chart("Distance kept through a corner", x, Axis.linear("distance at the hand-over, error (mm)", -120, 20), marks);
        folder.svg("fig6-angles", Sheet.of(chart, 480, 360));
        folder.csv("fig6-angles", table);
    }

    private static List<Vec> run(Set<String> sensors, Table table) {
        List<Vec> points = new ArrayList<>();
        for (double degrees = FIRST; degrees <= LAST; degrees += STEP) {
            Journey journey = CornerRun.of(degrees, sensors);
            points.add(new Vec(degrees, CornerRun.error(journey)));
            table.row(degrees, sensors.size(), CornerRun.error(journey), 1000 * journey.result().distanceRms().orElse(Double.NaN),
                    journey.result().collision().isPresent());
        }
        return points;
    }
}
