package faultline.studies;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.robot.RobotSpec;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;

/** Fig. 3: the pose q = [x, y, theta] in the global frame, and the robot's own frame. */
final class PoseAndReferenceFrames implements Figure {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;
    private static final Pose POSE = new Pose(0.42, 0.28, StrictMath.toRadians(35));
    private static final double AXIS_LENGTH = 0.26;
    private static final LineStyle AXIS_STYLE = LineStyle.solid(FigureCanvas.FOREGROUND, 1.4);
    private static final LineStyle GUIDE = new LineStyle(FigureCanvas.FOREGROUND, 0.9, DashPattern.DASHED);

    private static final String CAPTION =
            """
            Fig. 3. The pose q = [x, y, \u03b8] of the robot in the global frame X_b, Y_b, and the robot's own frame \
            X_r, Y_r. Arrows v and \u03c9: the linear and the angular velocity of eq. (3) where they are positive. \
            The default robot, to scale.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        FigureCanvas canvas = new FigureCanvas(460, 380, CAPTION);
        PlanView plan =
                canvas.addPlan(new PixelRectangle(20, 14, 420, 352), new Rectangle2D.Double(-0.07, -0.06, 0.88, 0.68));
        plan.drawRobot(ROBOT, POSE, 1);
        globalFrame(plan);
        ownFrame(plan);
        coordinates(plan);
        velocities(plan);
        plan.drawScaleBar(0.1, 418, 340);
        folder.writeSvg("fig3-frames", canvas.surface());
    }

    private static void globalFrame(PlanView plan) {
        plan.drawArrow(Vector2.ZERO, new Vector2(0.76, 0), AXIS_STYLE);
        plan.drawArrow(Vector2.ZERO, new Vector2(0, 0.58), AXIS_STYLE);
        plan.drawLabel("X_b", new Vector2(0.76, 0), 6, 4, FigureCanvas.TEXT_STYLE);
        plan.drawLabel("Y_b", new Vector2(0, 0.58), -24, 4, FigureCanvas.TEXT_STYLE);
        plan.drawLabel("0", Vector2.ZERO, -14, 14, FigureCanvas.TEXT_STYLE);
    }

    private static void ownFrame(PlanView plan) {
        plan.drawArrow(POSE.position(), POSE.toParent(new Vector2(AXIS_LENGTH + 0.04, 0)), AXIS_STYLE);
        plan.drawArrow(POSE.position(), POSE.toParent(new Vector2(0, AXIS_LENGTH)), AXIS_STYLE);
        plan.drawLabel("X_r (ahead)", POSE.toParent(new Vector2(AXIS_LENGTH + 0.04, 0)), 5, 2, FigureCanvas.TEXT_STYLE);
        plan.drawLabel("Y_r (left)", POSE.toParent(new Vector2(0, AXIS_LENGTH)), -22, -7, FigureCanvas.TEXT_STYLE);
    }

    private static void coordinates(PlanView plan) {
        Vector2 at = POSE.position();
        plan.drawLine(List.of(new Vector2(at.x(), 0), at), GUIDE);
        plan.drawLine(List.of(new Vector2(0, at.y()), at), GUIDE);
        plan.drawLine(List.of(at, at.plus(new Vector2(0.3, 0))), GUIDE);
        plan.drawLine(PlanView.arcPoints(at, 0.22, 0, POSE.heading()), AXIS_STYLE);
        plan.drawLabel(
                "\u03b8", at.plus(Vector2.direction(POSE.heading() / 2).times(0.22)), 7, 4, FigureCanvas.TEXT_STYLE);
        plan.drawLabel("x", new Vector2(at.x(), 0), -4, 18, FigureCanvas.TEXT_STYLE);
        plan.drawLabel("y", new Vector2(0, at.y()), -16, 4, FigureCanvas.TEXT_STYLE);
        plan.drawDot(at, 3);
    }

    private static void velocities(PlanView plan) {
        LineStyle pen = LineStyle.solid(FigureCanvas.THEME.series().get(1), 2);
        Vector2 nose = POSE.toParent(new Vector2(0.02, -0.135));
        plan.drawArrow(nose, nose.plus(Vector2.direction(POSE.heading()).times(0.15)), pen);
        plan.drawLabel(
                "v",
                nose.plus(Vector2.direction(POSE.heading()).times(0.15)),
                4,
                14,
                FigureCanvas.TEXT_STYLE.withBold());
        List<Vector2> turn = PlanView.arcPoints(POSE.position(), 0.19, POSE.heading() + 2.3, POSE.heading() + 3.4);
        plan.drawLine(turn, pen);
        plan.drawArrow(turn.get(turn.size() - 3), turn.get(turn.size() - 1), pen);
        plan.drawLabel("\u03c9", turn.get(turn.size() / 2), -16, 0, FigureCanvas.TEXT_STYLE.withBold());
    }
}
