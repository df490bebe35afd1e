package faultline.app.figures;

import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vec;
import faultline.paint.plot.Area;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.paint.plot.Pen;
import faultline.paint.plot.Plan;
import faultline.paint.plot.TextStyle.Anchor;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import faultline.sensor.SensorSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Fig. 4: the positioning beside a wall, in frames at their measured times. The paper names F3 and F4; F1 is taken as the moment when the
 * front sensor first sees the wall, F2 as the one when the robot begins to spin.
 */
final class WallFrames implements Figure {

    private static final String SCENARIO = "beside-a-wall.xml";
    private static final int COLUMN = 160;
    private static final double SECONDS = 8;
    /** How much of the wall a frame shows, metres. */
    private static final double SHOWN = 1.3;

    /** A frame: its name, what happens, and its tick. */
    private record Moment(String name, String what, int tick) {
    }

    @Override
    public void make(FigureFolder folder) throws IOException {
        Scenario scenario = Shipped.load(SCENARIO);
        Journey journey = Journey.of(scenario.setup());
        ScenarioRun run = scenario.run();
        List<Moment> moments = moments(journey, run);
        Sheet sheet = new Sheet(5 * COLUMN, 540);
        for (int i = 0; i < moments.size(); i++) {
            draw(sheet, journey, moments.get(i), COLUMN * i);
        }
        sheet.chart(chart(journey, run, moments), new Area(0, 272, 5 * COLUMN, 264));
        folder.svg("fig4-positioning", sheet.drawing());
        folder.csv("fig4-positioning", table(journey, moments));
    }

    private static List<Moment> moments(Journey journey, ScenarioRun run) {
        double dt = journey.setup().dt();
        int sees = IntStream.range(0, journey.poses().size()).filter(tick ->
                run.reading("front", tick * dt).distance().isPresent()).findFirst().orElseThrow();
        List<String> states = journey.states();
        return List.of(new Moment("F1", "front sees the wall", sees), new Moment("F2", "spin begins", states.indexOf("TURN")),
                new Moment("F3", "left comes to the wall", states.indexOf("MEASURE") - 1),
                new Moment("F4", "left leaves the wall", states.indexOf("ALIGN") - 1),
                new Moment("P", "turned back", states.indexOf("FOLLOW")));
    }

    private static void draw(Sheet sheet, Journey journey, Moment moment, double x) {
        Pose pose = journey.poses().get(moment.tick());
        SensorSpec sensor = journey.setup().robot().sensor(moment.name().equals("F1") ? "front" : "left").orElseThrow();
        Sector cone = Sector.of(pose.toOuter(sensor.seat()), pose.heading() + sensor.bearing(), sensor.cone(), sensor.range());
        // Robot and cone in the middle, so that neither reaches into the neighbouring frame.
        double left = (pose.x() + cone.apex().plus(cone.axis().times(cone.range())).x() - SHOWN) / 2;
        Plan plan = sheet.plan(new Area(x + 6, 26, COLUMN - 12, 205), new Rectangle2D.Double(left, 1.25, SHOWN, 1.85));
        plan.line(List.of(new Vec(left, 2.5), new Vec(left + SHOWN, 2.5)), Pen.solid(Sheet.THEME.palette().obstacleOutline(), 3));
        plan.cone(cone, 1);
        plan.robot(journey.setup().robot(), pose, 1);
        double middle = x + COLUMN / 2.0;
        sheet.text(moment.name(), middle, 18, Sheet.TEXT.inBold().anchored(Anchor.MIDDLE));
        sheet.lines(List.of(moment.what(), "t = " + Numbers.text(moment.tick() * journey.setup().dt(), 2) + " s, heading "
                + heading(pose)), middle, 240);
    }

    private static String heading(Pose pose) {
        return Numbers.text(degrees(pose), 1) + "\u00b0";
    }

    private static double degrees(Pose pose) {
        return StrictMath.toDegrees(Angles.normalize(pose.heading()));
    }

    private static Chart chart(Journey journey, ScenarioRun run, List<Moment> moments) {
        double dt = journey.setup().dt();
        List<Vec> readings = IntStream.range(0, (int) (SECONDS / dt)).mapToObj(
                tick -> new Vec(tick * dt, run.reading("left", tick * dt).distance().orElse(Double.NaN))).toList();
        List<Mark> marks = new ArrayList<>();
        for (Moment moment : moments) {
            double t = moment.tick() * dt;
            marks.add(new Mark.Line("", List.of(new Vec(t, 0), new Vec(t, 1)), 2));
            marks.add(new Mark.Note(moment.name(), new Vec(t + 0.04, 0.92)));
        }
        marks.add(new Mark.Line("reading of the left sensor", readings, 0));
        double tD = (moments.get(3).tick() - moments.get(2).tick()) * dt;
        String title = "t_D = " + Numbers.text(tD, 2) + " s, t_p = t_D/2 = " + Numbers.text(tD / 2, 2) + " s; parallel but for "
                + Numbers.text(degrees(journey.poses().get(moments.get(4).tick())), 1) + " degrees";
        return new Chart(title, Axis.linear("time (s)", 0, SECONDS), Axis.linear("reading (m)", 0, 1), marks);
    }

    private static Table table(Journey journey, List<Moment> moments) {
        Table table = new Table("frame", "what", "t_s", "x_m", "y_m", "heading_deg");
        for (Moment moment : moments) {
            Pose pose = journey.poses().get(moment.tick());
            table.row(moment.name(), moment.what(), moment.tick() * journey.setup().dt(), pose.x(), pose.y(), degrees(pose));
        }
        return table;
    }
}
