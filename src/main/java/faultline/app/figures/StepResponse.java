package faultline.app.figures;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.PdGains;
import faultline.engine.Setup;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** How an error of the distance dies out: the PD law alone with several lengths, and the whole follower when its wall is moved. */
final class StepResponse implements Figure {

    private static final List<Double> LENGTHS = List.of(0.06, 0.015, 0.12, 0.24);
    private static final double SECONDS = 5;
    private static final Setup BASE = Shipped.load("studies/moved-wall.xml").setup();
    private static final double MOVED_BY = 0.055;
    private static final double TICK = 0.01;
    private static final Axis DISTANCE_ERROR = Axis.linear("distance error (m)", -0.06, 0.06);

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("what", "t_s", "error_m");
        Sheet sheet = new Sheet(920, 360);
        sheet.chart(lawAlone(table), new Area(0, 4, 460, 352));
        sheet.chart(follower(table), new Area(460, 4, 460, 352));
        folder.svg("pd-step", sheet.drawing());
        folder.csv("pd-step", table);
    }

    private static Chart lawAlone(Table table) {
        List<Mark> marks = new ArrayList<>();
        for (double length : LENGTHS) {
            List<Double> errors = new PdLoop(PdGains.dyingOutOn(length, PdLoop.SPEED), MOVED_BY, 0).errors();
            String name = "l = " + Numbers.text(1000 * length, 0) + " mm";
            marks.add(line(name + (marks.isEmpty() ? " (chosen)" : ""), errors.subList(0, (int) Math.min(errors.size(), SECONDS / TICK)),
                    marks.size(), table));
        }
        return new Chart("PD law and motors alone", Axis.linear("time (s)", 0, SECONDS), DISTANCE_ERROR, marks);
    }

    private static Chart follower(Table table) {
        List<Mark> marks = List.of(
                line("wall moved away: taken for its end, ROUND", moved(MOVED_BY), 0, table),
                line("wall moved nearer", moved(-MOVED_BY), 1, table));
        return new Chart("The whole follower, its wall moved by 55 mm", Axis.linear("time (s)", 0, SECONDS),
                DISTANCE_ERROR, marks);
    }

    private static Mark line(String name, List<Double> errors, int style, Table table) {
        IntStream.range(0, errors.size()).filter(i -> i % 5 == 0).forEach(i -> table.row(name, i * TICK, errors.get(i)));
        return new Mark.Line(name, IntStream.range(0, errors.size()).mapToObj(i -> new Vec(i * TICK, errors.get(i))).toList(), style);
    }

    private static List<Double> moved(double away) {
        Setup.Timed jump = BASE.timeline().get(0);
        Command move = new Command.MoveObstacle("wall", new Pose(0, away, 0));
        Journey journey = Journey.of(Variation.of(BASE, List.of(new Setup.Timed(jump.at(), move))));
        int from = (int) Math.round(jump.at() / TICK);
        double line = Alignment.WALL + away - RobotSpec.DEFAULT.width() / 2 - WallFollowing.DEFAULT.distance();
        return journey.poses().subList(from, journey.poses().size()).stream().map(pose -> line - pose.y()).toList();
    }
}
