package faultline.studies;

import faultline.control.FollowerState;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.sensor.SensorSpec;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

/**
 * Fig. 6: corners of three angles, each with two sensors and with either of the third sensors, at the same scale, with
 * the median distance over many starts. The forward cones are shown where the robot stops for the second wall.
 */
final class CornerPlans implements Figure {

    private static final List<Double> ANGLES = List.of(45.0, 90.0, 135.0);
    private static final List<CornerRun.SensorSelection> ROWS = List.of(
            CornerRun.SensorSelection.TWO, CornerRun.SensorSelection.FRONT_RIGHT, CornerRun.SensorSelection.FRONT_LEFT);
    private static final Vector2 CORNER = new Vector2(AlignmentTrial.WALL_Y, AlignmentTrial.WALL_Y);
    private static final double FIRST_WALL = 1.2;
    private static final double SECOND_WALL = 1.5;
    private static final double LENGTH_BEFORE = 0.6;
    private static final int COLUMN_WIDTH = 260;
    private static final int ROW_HEIGHT = 218;
    private static final PixelRectangle VIEW_AREA = new PixelRectangle(12, 40, COLUMN_WIDTH - 24, 142);

    private static final String CAPTION =
            """
            Fig. 6. Inner corners of three angles with all sensors off but left and front (a to c), these and \
            front-right (d to f), or these and front-left (g to i). Line: the path of one start; pale and dark robot: \
            before the corner and after it; triangles: the forward cones where the robot stops for the second wall, \
            to half their length. Below each panel: the median distance over n\u00a0=\u00a0%d starts; 250 mm are \
            wanted. All panels have one scale.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        FigureCanvas canvas = new FigureCanvas(
                ANGLES.size() * COLUMN_WIDTH,
                ROWS.size() * ROW_HEIGHT + 22,
                String.format(Locale.ROOT, CAPTION, CornerAngleSweep.STARTS));
        for (int column = 0; column < ANGLES.size(); column++) {
            for (int row = 0; row < ROWS.size(); row++) {
                draw(canvas, ANGLES.get(column), ROWS.get(row), COLUMN_WIDTH * column, ROW_HEIGHT * row);
            }
        }
        plan(canvas, ANGLES.get(0), 0, ROW_HEIGHT * (ROWS.size() - 1))
                .drawScaleBar(0.5, ANGLES.size() * COLUMN_WIDTH - VIEW_AREA.x() - 24, ROW_HEIGHT - 20);
        folder.writeSvg("fig6-corners", canvas.surface());
    }

    private static void draw(
            FigureCanvas canvas, double degrees, CornerRun.SensorSelection sensors, double x, double y) {
        RunTrace trace = CornerRun.run(degrees, sensors);
        PlanView plan = plan(canvas, degrees, x, y);
        plan.drawLine(
                List.of(CORNER.plus(firstWall(degrees)), CORNER, CORNER.plus(new Vector2(SECOND_WALL, 0))),
                LineStyle.solid(FigureCanvas.THEME.palette().obstacleOutline(), 3));
        List<Pose> shown = shownPoses(trace);
        Pose stop = trace.poses().get(secondWallTick(trace));
        trace.setup().robot().sensors().stream()
                .filter(sensor -> sensor.on() && !sensor.id().equals("left"))
                .forEach(sensor -> plan.drawCone(
                        nearCone(stop, sensor), trace.setup().robot().indexOf(sensor.id())));
        plan.drawLine(shown.stream().map(Pose::position).toList(), FigureCanvas.PATH_LINE);
        plan.drawRobot(trace.setup().robot(), shown.get(0), 0.4);
        plan.drawRobot(trace.setup().robot(), shown.get(shown.size() - 1), 1);
        canvas.addPanelTitle(
                ANGLES.size() * ROWS.indexOf(sensors) + ANGLES.indexOf(degrees),
                FigureNumbers.format(degrees, 0) + "\u00b0, " + sensors.title(),
                x + COLUMN_WIDTH / 2.0,
                y + 18);
        canvas.addLines(
                List.of(FigureNumbers.format(250 + median(degrees, sensors), 0) + " mm from the wall when aligned"),
                x + COLUMN_WIDTH / 2.0,
                y + ROW_HEIGHT - 18);
    }

    /** Returns the median distance error over many starts, millimetres; the path is that of one start. */
    private static double median(double degrees, CornerRun.SensorSelection sensors) {
        return CornerRun.distanceErrors(degrees, sensors, CornerAngleSweep.STARTS)
                .median();
    }

    /** Returns a plan of the size of the most obtuse corner, so that all have the same scale. */
    private static PlanView plan(FigureCanvas canvas, double degrees, double x, double y) {
        double width = SECOND_WALL + FIRST_WALL / StrictMath.sqrt(2);
        double left = CORNER.x() + (Math.min(0, firstWall(degrees).x()) + SECOND_WALL - width) / 2;
        return canvas.addPlan(
                new PixelRectangle(x + VIEW_AREA.x(), y + VIEW_AREA.y(), VIEW_AREA.width(), VIEW_AREA.height()),
                new Rectangle2D.Double(left, CORNER.y() - FIRST_WALL, width, FIRST_WALL));
    }

    private static Vector2 firstWall(double degrees) {
        return Vector2.direction(-Degrees.toRadians(degrees)).times(FIRST_WALL);
    }

    /** Returns the near half of a cone, because the whole cone would cover its neighbours. */
    private static Sector nearCone(Pose at, SensorSpec sensor) {
        return Sector.of(
                at.toParent(sensor.mountPosition()),
                at.heading() + sensor.bearing(),
                sensor.cone(),
                sensor.range() / 2);
    }

    /** Returns the tick at which the robot reaches the second wall, when the spin before the second FOLLOW begins. */
    private static int secondWallTick(RunTrace trace) {
        return trace.states().subList(0, trace.handOvers().get(1)).lastIndexOf(FollowerState.FOLLOW) + 1;
    }

    /** Returns the poses from shortly before the corner to a position along the second wall. */
    private static List<Pose> shownPoses(RunTrace trace) {
        int stop = secondWallTick(trace);
        int from = trace.states().indexOf(FollowerState.FOLLOW);
        while (trace.poses()
                        .get(from)
                        .position()
                        .distanceTo(trace.poses().get(stop).position())
                > LENGTH_BEFORE) {
            from++;
        }
        int to = stop;
        while (trace.poses().get(to).x() < CORNER.x() + SECOND_WALL - 0.2) {
            to++;
        }
        return trace.poses().subList(from, to);
    }
}
