package faultline.app.figures;

import faultline.control.PdGains;
import faultline.geometry.Degrees;
import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.robot.MotorSpec;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** Which gains of the PD controller are good: the fate of the loop over kp and kd, and theory as lines. */
final class GainsMap implements Figure {

    private static final Axis KP = new Axis("k_p (rad/s per m)", 2, 2000, true);
    private static final Axis KD = new Axis("k_d (rad/s per m/s)", 1, 100, true);
    /** A hard start: at the wanted distance, but well on the way into the wall. */
    private static final double HEADING = Degrees.toRadians(45);
    private static final int COLUMNS = 48;
    private static final int ROWS = 36;
    /** From a decision to half way through the tick in which it acts. */
    private static final double DELAY = 1.5 * PdLoop.TICK;
    private static final List<String> NAMES = List.of("settles", "not yet after 12 s", "swings", "touches the wall");

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("kp", "kd", "fate");
        List<List<Integer>> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            rows.add(row(KD.at((row + 0.5) / ROWS), table));
        }
        PdGains chosen = PdGains.of(PdLoop.SPEED, MotorSpec.DEFAULT.timeConstant() + PdLoop.TICK);
        List<Mark> marks = List.of(new Mark.Cells(NAMES, rows),
                new Mark.Line("critically damped", line(kd -> PdLoop.SPEED * kd * kd / 4), 0),
                new Mark.Line("limit of stability", line(kd -> kd / (MotorSpec.DEFAULT.timeConstant() + DELAY)), 1),
                new Mark.Points("chosen", List.of(new Vec(chosen.proportional(), chosen.derivative())), 1));
        folder.csv("pd-gains", table);
        folder.svg("pd-gains", Sheet.of(new Chart("Gains of the PD controller at 0.3 m/s", KP, KD, marks), 520, 420));
    }

    private static List<Integer> row(double kd, Table table) {
        List<Integer> row = new ArrayList<>();
        for (int column = 0; column < COLUMNS; column++) {
            double kp = KP.at((column + 0.5) / COLUMNS);
            PdLoop.Fate fate = new PdLoop(PdGains.any(kp, kd, PdLoop.SPEED), 0, HEADING).fate();
            table.row(kp, kd, NAMES.get(fate.ordinal()));
            row.add(fate.ordinal());
        }
        return row;
    }

    private static List<Vec> line(DoubleUnaryOperator kpOfKd) {
        List<Vec> points = new ArrayList<>();
        for (int i = 0; i <= ROWS; i++) {
            double kd = KD.at((double) i / ROWS);
            points.add(new Vec(kpOfKd.applyAsDouble(kd), kd));
        }
        return points;
    }
}
