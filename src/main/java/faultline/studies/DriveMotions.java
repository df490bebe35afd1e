package faultline.studies;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Fig. 2: the motions of differential steering, computed by the model itself. */
final class DriveMotions implements Figure {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;
    private static final double SECONDS = 1;
    private static final int STEPS = 60;
    private static final int COLUMN_WIDTH = 190;
    private static final int ROW_HEIGHT = 246;

    private static final String CAPTION =
            """
            Fig. 2. Differential steering: eight moves of the default robot in 1 s, computed by the model from the \
            speeds of its wheels. Pale: the robot before; dark: after; line: the path of its centre. Arrows: what the \
            left and the right wheels roll in 0.5 s; a dot: they stand still. All panels have one scale.""";

    /** A motion: its name and the speeds of the left and the right wheels, metres per second. */
    private record DriveMotion(String name, double left, double right) {
        Velocity velocity() {
            return new WheelSpeeds(left, right).toVelocity(ROBOT.track());
        }

        Pose poseAfter(double seconds) {
            return DifferentialDrive.advance(new Pose(0, 0, StrictMath.PI / 2), velocity(), seconds);
        }
    }

    private static final List<DriveMotion> MOTIONS = List.of(
            new DriveMotion("ahead", 0.3, 0.3),
            new DriveMotion("bend to the left", 0.2, 0.36),
            new DriveMotion("bend to the right", 0.36, 0.2),
            new DriveMotion("about the left wheels", 0, 0.22),
            new DriveMotion("backwards", -0.3, -0.3),
            new DriveMotion("backwards in a bend", -0.2, -0.36),
            new DriveMotion("pivot to the left", -0.12, 0.12),
            new DriveMotion("pivot to the right", 0.12, -0.12));

    @Override
    public void write(FigureFolder folder) throws IOException {
        FigureCanvas canvas = new FigureCanvas(4 * COLUMN_WIDTH, 2 * ROW_HEIGHT + 6, CAPTION);
        for (int i = 0; i < MOTIONS.size(); i++) {
            draw(canvas, MOTIONS.get(i), COLUMN_WIDTH * (i % 4), ROW_HEIGHT * (i / 4));
        }
        folder.writeSvg("fig2-moves", canvas.surface());
    }

    private static void draw(FigureCanvas canvas, DriveMotion move, double x, double y) {
        double v = move.velocity().linear();
        double low = v > 0 ? -0.15 : v < 0 ? -0.48 : -0.315;
        PlanView plan = canvas.addPlan(
                new PixelRectangle(x, y + 26, COLUMN_WIDTH, 172), new Rectangle2D.Double(-0.35, low, 0.7, 0.63));
        plan.drawRobot(ROBOT, move.poseAfter(0), 0.35);
        plan.drawRobot(ROBOT, move.poseAfter(SECONDS), 1);
        plan.drawLine(path(move), FigureCanvas.PATH_LINE);
        drawWheelSpeed(plan, move, move.left(), ROBOT.track() / 2);
        drawWheelSpeed(plan, move, move.right(), -ROBOT.track() / 2);
        if (move.equals(MOTIONS.get(0))) {
            plan.drawScaleBar(0.1, COLUMN_WIDTH - 12, 160);
        }
        canvas.addPanelTitle(MOTIONS.indexOf(move), move.name(), x + COLUMN_WIDTH / 2.0, y + 18);
        canvas.addLines(captionLines(move), x + COLUMN_WIDTH / 2.0, y + 216);
    }

    private static List<Vector2> path(DriveMotion move) {
        List<Vector2> path = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            path.add(move.poseAfter(SECONDS * i / STEPS).position());
        }
        return path;
    }

    /**
     * Draws an arrow beside the wheels, of the length that they roll in half a second. It is outside the circle of the
     * body's corners.
     */
    private static void drawWheelSpeed(PlanView plan, DriveMotion move, double speed, double side) {
        Pose start = move.poseAfter(0);
        Vector2 from = new Vector2(0, 2.2 * side);
        if (speed == 0) {
            plan.drawDot(start.toParent(from), 2.5);
        } else {
            plan.drawArrow(
                    start.toParent(from),
                    start.toParent(from.plus(new Vector2(speed / 2, 0))),
                    LineStyle.solid(FigureCanvas.THEME.series().get(1), 2));
        }
    }

    private static List<String> captionLines(DriveMotion move) {
        return List.of(
                "left " + FigureNumbers.format(move.left(), 2) + ", right " + FigureNumbers.format(move.right(), 2)
                        + " m/s",
                "v " + FigureNumbers.format(move.velocity().linear(), 2) + " m/s, \u03c9 "
                        + FigureNumbers.format(move.velocity().angular(), 2) + " rad/s");
    }
}
