package faultline.app.figures;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Dash;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.robot.RobotSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;

/** Fig. 3: the pose q = [x, y, theta] in the global frame, and the robot's own frame. */
final class PoseAndFrames implements Figure {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;
    private static final Pose POSE = new Pose(0.42, 0.28, StrictMath.toRadians(35));
    private static final double REACH = 0.26;
    private static final Pen AXIS = Pen.solid(Sheet.INK, 1.4);
    private static final Pen HELP = new Pen(Sheet.INK, 0.9, Dash.DASHED);

    @Override
    public void make(FigureFolder folder) throws IOException {
        Sheet sheet = new Sheet(460, 380);
        Plan plan = sheet.plan(new Area(20, 14, 420, 352), new Rectangle2D.Double(-0.07, -0.06, 0.88, 0.68));
        plan.robot(ROBOT, POSE, 1);
        globalFrame(plan);
        ownFrame(plan);
        coordinates(plan);
        velocities(plan);
        folder.svg("fig3-frames", sheet.drawing());
    }

    private static void globalFrame(Plan plan) {
        plan.arrow(Vec.ZERO, new Vec(0.76, 0), AXIS);
        plan.arrow(Vec.ZERO, new Vec(0, 0.58), AXIS);
        plan.label("X_b", new Vec(0.76, 0), 6, 4, Sheet.TEXT);
        plan.label("Y_b", new Vec(0, 0.58), -24, 4, Sheet.TEXT);
        plan.label("0", Vec.ZERO, -14, 14, Sheet.TEXT);
    }

    private static void ownFrame(Plan plan) {
        plan.arrow(POSE.position(), POSE.toOuter(new Vec(REACH + 0.04, 0)), AXIS);
        plan.arrow(POSE.position(), POSE.toOuter(new Vec(0, REACH)), AXIS);
        plan.label("X_r (ahead)", POSE.toOuter(new Vec(REACH + 0.04, 0)), 5, 2, Sheet.TEXT);
        plan.label("Y_r (left)", POSE.toOuter(new Vec(0, REACH)), -22, -7, Sheet.TEXT);
    }

    private static void coordinates(Plan plan) {
        Vec at = POSE.position();
        plan.line(List.of(new Vec(at.x(), 0), at), HELP);
        plan.line(List.of(new Vec(0, at.y()), at), HELP);
        plan.line(List.of(at, at.plus(new Vec(0.3, 0))), HELP);
        plan.line(Plan.arc(at, 0.22, 0, POSE.heading()), AXIS);
        plan.label("\u03b8", at.plus(Vec.direction(POSE.heading() / 2).times(0.22)), 7, 4, Sheet.TEXT);
        plan.label("x", new Vec(at.x(), 0), -4, 18, Sheet.TEXT);
        plan.label("y", new Vec(0, at.y()), -16, 4, Sheet.TEXT);
        plan.dot(at, 3);
    }

    private static void velocities(Plan plan) {
        Pen pen = Pen.solid(Sheet.THEME.series().get(1), 2);
        Vec nose = POSE.toOuter(new Vec(0.02, -0.135));
        plan.arrow(nose, nose.plus(Vec.direction(POSE.heading()).times(0.15)), pen);
        plan.label("v", nose.plus(Vec.direction(POSE.heading()).times(0.15)), 4, 14, Sheet.TEXT.inBold());
        List<Vec> turn = Plan.arc(POSE.position(), 0.19, POSE.heading() + 2.3, POSE.heading() + 3.4);
        plan.line(turn, pen);
        plan.arrow(turn.get(turn.size() - 3), turn.get(turn.size() - 1), pen);
        plan.label("\u03c9", turn.get(turn.size() / 2), -16, 0, Sheet.TEXT.inBold());
    }
}
