package faultline.studies;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.PdGains;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.paint.surface.PixelRectangle;
import faultline.robot.RobotSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import faultline.world.Command;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The decay of a distance error: the PD law alone with several lengths, and the whole follower after its wall is moved.
 */
final class StepResponse implements Figure {

    private static final List<Double> LENGTHS = List.of(0.06, 0.015, 0.12, 0.24);
    private static final double SECONDS = 5;
    private static final SimulationSetup BASE =
            StudyScenarios.load("studies/moved-wall.xml").setup();
    private static final double WALL_DISPLACEMENT = 0.055;
    private static final double TICK = PdLoop.TICK;
    private static final Axis DISTANCE_ERROR = Axis.linear("distance error (m)", -0.06, 0.06);

    private static final String CAPTION =
            """
            The distance error after a step of 55 mm at time 0, without noise (n\u00a0=\u00a01 run a line); positive: \
            too far from the wall. (a) The PD law and the motors, for critically damped gains of four lengths l: k_p \
            = v/l\u00b2, k_d = 2/l. (b) The whole follower with the chosen gains, when the wall beside it jumps.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("what", "t_s", "error_m");
        FigureCanvas canvas = new FigureCanvas(920, 360, CAPTION);
        canvas.addChart(controllerChart(table), new PixelRectangle(0, 4, 460, 352));
        canvas.addChart(followerChart(table), new PixelRectangle(460, 4, 460, 352));
        folder.writeSvg("pd-step", canvas.surface());
        folder.writeCsv("pd-step", table);
    }

    private static Chart controllerChart(CsvTable table) {
        List<Series> series = new ArrayList<>();
        for (double length : LENGTHS) {
            List<Double> errors =
                    new PdLoop(PdGains.criticallyDamped(length, PdLoop.SPEED), WALL_DISPLACEMENT, 0).errors();
            String name = "l = " + FigureNumbers.format(1000 * length, 0) + " mm";
            series.add(addLine(
                    name + (series.isEmpty() ? " (chosen)" : ""),
                    errors.subList(0, (int) Math.min(errors.size(), SECONDS / TICK)),
                    series.size(),
                    table));
        }
        return new Chart(
                FigureCanvas.panelTitle(0, "PD law and motors alone"),
                Axis.linear("time (s)", 0, SECONDS),
                DISTANCE_ERROR,
                series);
    }

    private static Chart followerChart(CsvTable table) {
        List<Series> series = List.of(
                addLine("wall moved away: taken for its end, ROUND", displacedErrors(WALL_DISPLACEMENT), 0, table),
                addLine("wall moved nearer", displacedErrors(-WALL_DISPLACEMENT), 1, table));
        return new Chart(
                FigureCanvas.panelTitle(1, "The whole follower, its wall moved by 55 mm"),
                Axis.linear("time (s)", 0, SECONDS),
                DISTANCE_ERROR,
                series);
    }

    private static Series addLine(String name, List<Double> errors, int style, CsvTable table) {
        IntStream.range(0, errors.size())
                .filter(i -> i % 5 == 0)
                .forEach(i -> table.addRow(name, i * TICK, errors.get(i)));
        return new Series.Line(
                name,
                IntStream.range(0, errors.size())
                        .mapToObj(i -> new Vector2(i * TICK, errors.get(i)))
                        .toList(),
                style);
    }

    private static List<Double> displacedErrors(double away) {
        SimulationSetup.TimedCommand jump = BASE.timeline().get(0);
        Command move = new Command.MoveObstacle("wall", new Pose(0, away, 0));
        RunTrace trace =
                RunTrace.simulate(BASE.withTimeline(List.of(new SimulationSetup.TimedCommand(jump.time(), move))));
        int from = (int) Math.round(jump.time() / TICK);
        double line = AlignmentTrial.WALL_Y + away - RobotSpec.DEFAULT.width() / 2 - WallFollowing.DEFAULT.distance();
        return trace.poses().subList(from, trace.poses().size()).stream()
                .map(pose -> line - pose.y())
                .toList();
    }
}
