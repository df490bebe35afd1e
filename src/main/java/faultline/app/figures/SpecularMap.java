package faultline.app.figures;

import faultline.engine.Setup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Specular reflection: which glossy walls, met at which slant, the robot finds in time. */
final class SpecularMap implements Figure {

    private static final int COLUMNS = 32;
    private static final int ROWS = 15;
    private static final Axis SLANT = Axis.linear("angle of approach from the wall's normal (degrees)", -64, 64);
    private static final Axis SPECULAR = Axis.linear("greatest angle of incidence sent back (degrees)", 0, 30);
    private static final List<String> NAMES = List.of("aligned with it", "neither", "runs into it");
    private static final Setup BASE = Shipped.load("studies/glossy-wall.xml").setup();

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("slant_deg", "specular_deg", "outcome");
        List<List<Integer>> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            List<Integer> outcomes = new ArrayList<>();
            for (int column = 0; column < COLUMNS; column++) {
                double slant = SLANT.at((column + 0.5) / COLUMNS);
                double specular = SPECULAR.at((row + 0.5) / ROWS);
                outcomes.add(outcome(slant, specular));
                table.row(slant, specular, NAMES.get(outcomes.get(column)));
            }
            rows.add(outcomes);
        }
        List<Mark> marks = List.of(new Mark.Cells(NAMES, rows), seen("front sensor sees it", 0, 1),
                seen("a corner sensor sees it", 45, 0), seen("", -45, 0));
        folder.csv("specular-map", table);
        folder.svg("specular-map", Sheet.of(new Chart("Glossy walls", SLANT, SPECULAR, marks), 520, 420));
    }

    /** Where a sensor of a bearing sees the wall: its cone reaches to within the angle of the normal. */
    private static Mark seen(String name, double bearing, int style) {
        double half = StrictMath.toDegrees(SensorSpec.DEFAULT_CONE) / 2;
        return new Mark.Line(name, List.of(new Vec(bearing - half - 90, 90), new Vec(bearing - half, 0), new Vec(bearing + half, 0),
                new Vec(bearing + half + 90, 90)), style);
    }

    private static int outcome(double slant, double specular) {
        Obstacle wall = Variation.obstacle(BASE, "wall");
        Pose start = new Pose(BASE.start().x(), BASE.start().y(), StrictMath.PI / 2 + Degrees.toRadians(slant));
        Obstacle glossy = new Obstacle(wall.id(), wall.shape(), wall.pose(), wall.motion(), Degrees.toRadians(specular));
        Journey journey = Journey.of(Variation.of(BASE, glossy).withStart(start));
        if (journey.result().collision().isPresent()) {
            return 2;
        }
        return Math.abs(StrictMath.sin(journey.last().heading())) < StrictMath.sin(Degrees.toRadians(2)) ? 0 : 1;
    }
}
