package faultline.app.figures;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.paint.plot.TextStyle.Anchor;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;
import java.util.Set;

/** Fig. 6: corners of three angles, each with two sensors and with the third one, and what it comes to in numbers. */
final class CornerViews implements Figure {

    private static final List<Double> ANGLES = List.of(45.0, 90.0, 135.0);
    private static final Vec CORNER = new Vec(Alignment.WALL, Alignment.WALL);
    private static final double SHOWN = 1.5;
    private static final int COLUMN = 250;
    private static final int ROW = 236;

    @Override
    public void make(FigureFolder folder) throws IOException {
        Sheet sheet = new Sheet(3 * COLUMN, 2 * ROW);
        for (int i = 0; i < ANGLES.size(); i++) {
            draw(sheet, ANGLES.get(i), CornerRun.TWO, COLUMN * i, 0);
            draw(sheet, ANGLES.get(i), CornerRun.THREE, COLUMN * i, ROW);
        }
        folder.svg("fig6-corners", sheet.drawing());
    }

    private static void draw(Sheet sheet, double degrees, Set<String> sensors, double x, double y) {
        Journey journey = CornerRun.of(degrees, sensors);
        Vec first = Vec.direction(-Degrees.toRadians(degrees)).times(SHOWN);
        Rectangle2D bounds = new Rectangle2D.Double(CORNER.x() + Math.min(0, first.x()), CORNER.y() + first.y(),
                SHOWN - Math.min(0, first.x()), -first.y());
        Plan plan = sheet.plan(new Area(x + 14, y + 32, COLUMN - 28, 168), bounds);
        plan.line(List.of(CORNER.plus(first), CORNER, CORNER.plus(new Vec(SHOWN, 0))), Pen.solid(Sheet.THEME.palette().obstacleOutline(), 3));
        List<Pose> shown = shown(journey);
        plan.line(shown.stream().map(Pose::position).toList(), Sheet.PATH);
        plan.robot(journey.setup().robot(), shown.get(0), 0.4);
        plan.robot(journey.setup().robot(), shown.get(shown.size() - 1), 1);
        String count = sensors.size() == 2 ? "two sensors" : "three sensors";
        sheet.text(Numbers.text(degrees, 0) + " degrees, " + count, x + COLUMN / 2.0, y + 18, Sheet.TEXT.inBold().anchored(Anchor.MIDDLE));
        sheet.lines(List.of(Numbers.text(250 + CornerRun.error(journey), 0) + " mm from the wall when aligned"), x + COLUMN / 2.0, y + 222);
    }

    /** From the first alignment to where the second wall has been followed for a while. */
    private static List<Pose> shown(Journey journey) {
        int from = journey.states().indexOf("FOLLOW");
        int to = from;
        while (journey.poses().get(to).x() < CORNER.x() + SHOWN - 0.2 || journey.poses().get(to).y() < CORNER.y() - 0.5) {
            to++;
        }
        return journey.poses().subList(from, to);
    }
}
