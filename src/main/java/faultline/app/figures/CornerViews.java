package faultline.app.figures;

import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.paint.plot.TextStyle.Anchor;
import faultline.sensor.SensorSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;

/**
 * Fig. 6: corners of three angles, each with two sensors and with either third one, to one scale, and what it comes to in numbers. The cones
 * that look ahead are shown where the robot stops for the second wall.
 */
final class CornerViews implements Figure {

    private static final List<Double> ANGLES = List.of(45.0, 90.0, 135.0);
    private static final List<CornerRun.Sensors> ROWS = List.of(CornerRun.Sensors.TWO, CornerRun.Sensors.FRONT_RIGHT, CornerRun.Sensors.FRONT_LEFT);
    private static final Vec CORNER = new Vec(Alignment.WALL, Alignment.WALL);
    private static final double FIRST_WALL = 1.2;
    private static final double SECOND_WALL = 1.5;
    private static final double SHOWN_BEFORE = 0.6;
    private static final int COLUMN = 260;
    private static final int ROW = 218;
    private static final Area VIEW = new Area(12, 40, COLUMN - 24, 142);

    @Override
    public void make(FigureFolder folder) throws IOException {
        Sheet sheet = new Sheet(ANGLES.size() * COLUMN, ROWS.size() * ROW + 22);
        for (int column = 0; column < ANGLES.size(); column++) {
            for (int row = 0; row < ROWS.size(); row++) {
                draw(sheet, ANGLES.get(column), ROWS.get(row), COLUMN * column, ROW * row);
            }
        }
        plan(sheet, ANGLES.get(0), 0, ROW * (ROWS.size() - 1)).scaleBar(0.5, ANGLES.size() * COLUMN - VIEW.x() - 24, ROW - 20);
        folder.svg("fig6-corners", sheet.drawing());
    }

    private static void draw(Sheet sheet, double degrees, CornerRun.Sensors sensors, double x, double y) {
        Journey journey = CornerRun.of(degrees, sensors);
        Plan plan = plan(sheet, degrees, x, y);
        plan.line(List.of(CORNER.plus(firstWall(degrees)), CORNER, CORNER.plus(new Vec(SECOND_WALL, 0))),
                Pen.solid(Sheet.THEME.palette().obstacleOutline(), 3));
        List<Pose> shown = shown(journey);
        Pose stop = journey.poses().get(stop(journey));
        journey.setup().robot().sensors().stream().filter(sensor -> sensor.on() && !sensor.id().equals("left"))
                .forEach(sensor -> plan.cone(cone(stop, sensor), 1));
        plan.line(shown.stream().map(Pose::position).toList(), Sheet.PATH);
        plan.robot(journey.setup().robot(), shown.get(0), 0.4);
        plan.robot(journey.setup().robot(), shown.get(shown.size() - 1), 1);
        sheet.text(Numbers.text(degrees, 0) + "\u00b0, " + sensors.title(), x + COLUMN / 2.0, y + 18, Sheet.TEXT.inBold().anchored(Anchor.MIDDLE));
        sheet.lines(List.of(Numbers.text(250 + CornerRun.error(journey), 0) + " mm from the wall when aligned"), x + COLUMN / 2.0, y + ROW - 18);
    }

    /** Every plan has the same size, that of the most obtuse corner's, so that all have one scale. */
    private static Plan plan(Sheet sheet, double degrees, double x, double y) {
        double width = SECOND_WALL + FIRST_WALL / StrictMath.sqrt(2);
        double left = CORNER.x() + (Math.min(0, firstWall(degrees).x()) + SECOND_WALL - width) / 2;
        return sheet.plan(new Area(x + VIEW.x(), y + VIEW.y(), VIEW.width(), VIEW.height()),
                new Rectangle2D.Double(left, CORNER.y() - FIRST_WALL, width, FIRST_WALL));
    }

    private static Vec firstWall(double degrees) {
        return Vec.direction(-Degrees.toRadians(degrees)).times(FIRST_WALL);
    }

    /** The near half of a cone: all of it would cover its neighbours. */
    private static Sector cone(Pose at, SensorSpec sensor) {
        return Sector.of(at.toOuter(sensor.seat()), at.heading() + sensor.bearing(), sensor.cone(), sensor.range() / 2);
    }

    /** The tick at which the second wall is met: the spin that ends in the second hand-over begins. */
    private static int stop(Journey journey) {
        return journey.states().subList(0, journey.handOvers().get(1)).lastIndexOf("FOLLOW") + 1;
    }

    /** From shortly before the corner to where the second wall has been followed for a while. */
    private static List<Pose> shown(Journey journey) {
        int stop = stop(journey);
        int from = journey.states().indexOf("FOLLOW");
        while (journey.poses().get(from).position().distanceTo(journey.poses().get(stop).position()) > SHOWN_BEFORE) {
            from++;
        }
        int to = stop;
        while (journey.poses().get(to).x() < CORNER.x() + SECOND_WALL - 0.2) {
            to++;
        }
        return journey.poses().subList(from, to);
    }
}
