package faultline.app.figures;

import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.paint.plot.TextStyle.Anchor;
import faultline.robot.DifferentialDrive;
import faultline.robot.RobotSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Fig. 2: the moves of differential steering, rolled by the model itself. */
final class DriveMoves implements Figure {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;
    private static final double SECONDS = 1;
    private static final int STEPS = 60;
    private static final int COLUMN = 190;
    private static final int ROW = 246;

    /** One move: its name and the speeds of the left and the right wheels, metres per second. */
    private record Move(String name, double left, double right) {
        Pose after(double seconds) {
            double omega = DifferentialDrive.angularVelocity(left, right, ROBOT.track());
            return DifferentialDrive.advance(new Pose(0, 0, StrictMath.PI / 2), DifferentialDrive.linearVelocity(left, right), omega, seconds);
        }
    }

    private static final List<Move> MOVES = List.of(
            new Move("ahead", 0.3, 0.3), new Move("bend to the left", 0.2, 0.36), new Move("bend to the right", 0.36, 0.2),
            new Move("about the left wheels", 0, 0.22), new Move("backwards", -0.3, -0.3), new Move("backwards in a bend", -0.2, -0.36),
            new Move("pivot to the left", -0.12, 0.12), new Move("pivot to the right", 0.12, -0.12));

    @Override
    public void make(FigureFolder folder) throws IOException {
        Sheet sheet = new Sheet(4 * COLUMN, 2 * ROW + 6);
        for (int i = 0; i < MOVES.size(); i++) {
            draw(sheet, MOVES.get(i), COLUMN * (i % 4), ROW * (i / 4));
        }
        folder.svg("fig2-moves", sheet.drawing());
    }

    private static void draw(Sheet sheet, Move move, double x, double y) {
        double v = DifferentialDrive.linearVelocity(move.left(), move.right());
        double low = v > 0 ? -0.15 : v < 0 ? -0.48 : -0.315;
        Plan plan = sheet.plan(new Area(x, y + 26, COLUMN, 172), new Rectangle2D.Double(-0.35, low, 0.7, 0.63));
        plan.robot(ROBOT, move.after(0), 0.35);
        plan.robot(ROBOT, move.after(SECONDS), 1);
        plan.line(path(move), Sheet.PATH);
        wheelSpeed(plan, move, move.left(), ROBOT.track() / 2);
        wheelSpeed(plan, move, move.right(), -ROBOT.track() / 2);
        sheet.text(move.name(), x + COLUMN / 2.0, y + 18, Sheet.TEXT.inBold().anchored(Anchor.MIDDLE));
        sheet.lines(numbers(move), x + COLUMN / 2.0, y + 216);
    }

    private static List<Vec> path(Move move) {
        List<Vec> path = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            path.add(move.after(SECONDS * i / STEPS).position());
        }
        return path;
    }

    /** An arrow beside the wheels, as long as they roll in half a second; farther out than a corner of the body can turn. */
    private static void wheelSpeed(Plan plan, Move move, double speed, double side) {
        Pose start = move.after(0);
        Vec from = new Vec(0, 2.2 * side);
        if (speed == 0) {
            plan.dot(start.toOuter(from), 2.5);
        } else {
            plan.arrow(start.toOuter(from), start.toOuter(from.plus(new Vec(speed / 2, 0))), Pen.solid(Sheet.THEME.series().get(1), 2));
        }
    }

    private static List<String> numbers(Move move) {
        double omega = DifferentialDrive.angularVelocity(move.left(), move.right(), ROBOT.track());
        return List.of("left " + Numbers.text(move.left(), 2) + ", right " + Numbers.text(move.right(), 2) + " m/s",
                "v " + Numbers.text(DifferentialDrive.linearVelocity(move.left(), move.right()), 2) + " m/s, \u03c9 "
                + Numbers.text(omega, 2) + " rad/s");
    }
}
