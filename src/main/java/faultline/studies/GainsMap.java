package faultline.studies;

import faultline.control.PdGains;
import faultline.geometry.Degrees;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.robot.MotorSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.DoubleUnaryOperator;

/**
 * The response of the loop over k_p and k_d, with theory as lines. The limit of stability is an approximation that
 * neglects the limits of the turn rate.
 */
final class GainsMap implements Figure {

    private static final Axis KP = new Axis("k_p (rad/s per m)", 2, 2000, true);
    private static final Axis KD = new Axis("k_d (rad/s per m/s)", 1, 100, true);
    /** A difficult start: at the wanted distance, but heading towards the wall. */
    private static final double START_HEADING = Degrees.toRadians(45);

    private static final int COLUMNS = 48;
    private static final int ROWS = 36;
    /** The time from a decision to the middle of the tick in which it takes effect. */
    private static final double DELAY = 1.5 * PdLoop.TICK;

    private static final List<String> RESPONSE_NAMES =
            List.of("settles", "not yet after 12 s", "swings", "touches the wall");

    private static final String CAPTION =
            """
            What the PD law and the motors do within 12 s for each pair of gains, n\u00a0=\u00a0%d runs without noise \
            from the wanted distance, heading for the wall at 45\u00b0. Settles: within 1 mm for 2 s. Lines: theory; \
            the limit of stability is an approximation. Square: the gains that the follower has.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("kp", "kd", "fate");
        List<List<Integer>> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            rows.add(computeRow(KD.valueAt((row + 0.5) / ROWS), table));
        }
        PdGains chosen = PdGains.forSpeed(PdLoop.SPEED, MotorSpec.DEFAULT.timeConstant() + PdLoop.TICK);
        List<Series> series = List.of(
                new Series.Cells(RESPONSE_NAMES, rows),
                new Series.Line("critically damped", gainLine(kd -> PdLoop.SPEED * kd * kd / 4), 0),
                new Series.Line(
                        "limit of stability", gainLine(kd -> kd / (MotorSpec.DEFAULT.timeConstant() + DELAY)), 1),
                new Series.Points("chosen", List.of(new Vector2(chosen.proportional(), chosen.derivative())), 1));
        folder.writeChart(
                "pd-gains",
                table,
                new Chart("Gains of the PD controller at 0.3 m/s", KP, KD, series),
                520,
                420,
                String.format(Locale.ROOT, CAPTION, COLUMNS * ROWS));
    }

    private static List<Integer> computeRow(double kd, CsvTable table) {
        List<Integer> row = new ArrayList<>();
        for (int column = 0; column < COLUMNS; column++) {
            double kp = KP.valueAt((column + 0.5) / COLUMNS);
            PdLoop.LoopResponse fate =
                    new PdLoop(PdGains.withErrorLimit(kp, kd, PdLoop.SPEED), 0, START_HEADING).response();
            table.addRow(kp, kd, RESPONSE_NAMES.get(fate.ordinal()));
            row.add(fate.ordinal());
        }
        return row;
    }

    private static List<Vector2> gainLine(DoubleUnaryOperator kpOfKd) {
        List<Vector2> points = new ArrayList<>();
        for (int i = 0; i <= ROWS; i++) {
            double kd = KD.valueAt((double) i / ROWS);
            points.add(new Vector2(kpOfKd.applyAsDouble(kd), kd));
        }
        return points;
    }
}
