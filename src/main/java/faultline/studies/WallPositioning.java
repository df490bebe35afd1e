package faultline.studies;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.paint.scene.PlanView;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioRun;
import faultline.sensor.SensorSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureCanvas;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * Fig. 4: the positioning beside a wall, in frames at their measured times. The paper does not define the frames. By
 * the range rule, F3 is the first sample that sees the wall, and F4 the first sample that no longer sees it; F1 is
 * taken as the moment when the front sensor first sees the wall, F2 as the beginning of the spin.
 */
final class WallPositioning implements Figure {

    private static final String SCENARIO = "beside-a-wall.xml";
    private static final int COLUMN_WIDTH = 160;
    private static final double SECONDS = 8;
    /** The length of the wall that a frame shows, metres. */
    private static final double SHOWN_LENGTH = 1.3;

    private static final String CAPTION =
            """
            Fig. 4. Positioning beside a wall by the range rule, in scenarios/%s, seed %d (n\u00a0=\u00a01 \
            run). (a) to (e): the wall, the robot and the cone of the sensor that decides, at five moments and to one \
            scale; a heading of 0\u00b0 is parallel to the wall, a positive one points towards it. (f): the readings \
            of the left sensor; where the line is broken, it sees nothing. Dotted lines: the five moments.""";

    /** A frame: its name, its event, and its tick. */
    private record KeyMoment(String name, String what, int tick) {}

    @Override
    public void write(FigureFolder folder) throws IOException {
        Scenario scenario = StudyScenarios.load(SCENARIO);
        RunTrace trace = RunTrace.simulate(scenario.setup());
        ScenarioRun run = scenario.run();
        List<KeyMoment> moments = keyMoments(trace, run);
        FigureCanvas canvas = new FigureCanvas(
                5 * COLUMN_WIDTH,
                540,
                String.format(Locale.ROOT, CAPTION, SCENARIO, scenario.setup().seed()));
        for (int i = 0; i < moments.size(); i++) {
            draw(canvas, trace, moments.get(i), i);
        }
        canvas.addChart(chart(trace, run, moments), new PixelRectangle(0, 272, 5 * COLUMN_WIDTH, 264));
        folder.writeSvg("fig4-positioning", canvas.surface());
        folder.writeCsv("fig4-positioning", table(trace, moments));
    }

    private static List<KeyMoment> keyMoments(RunTrace trace, ScenarioRun run) {
        double dt = trace.setup().dt();
        int sees = IntStream.range(0, trace.poses().size())
                .filter(tick -> run.reading("front", tick * dt).distance().isPresent())
                .findFirst()
                .orElseThrow();
        List<ControllerState> states = trace.states();
        return List.of(
                new KeyMoment("F1", "front sees the wall", sees),
                new KeyMoment("F2", "spin begins", states.indexOf(FollowerState.TURN)),
                new KeyMoment("F3", "left comes to the wall", states.indexOf(FollowerState.MEASURE) - 1),
                new KeyMoment("F4", "left leaves the wall", states.indexOf(FollowerState.ALIGN) - 1),
                new KeyMoment("P", "turned back", states.indexOf(FollowerState.FOLLOW)));
    }

    private static void draw(FigureCanvas canvas, RunTrace trace, KeyMoment moment, int index) {
        double x = COLUMN_WIDTH * index;
        Pose pose = trace.poses().get(moment.tick());
        SensorSpec sensor = trace.setup()
                .robot()
                .sensor(moment.name().equals("F1") ? "front" : "left")
                .orElseThrow();
        Sector cone = Sector.of(
                pose.toParent(sensor.mountPosition()),
                pose.heading() + sensor.bearing(),
                sensor.cone(),
                sensor.range());
        // Robot and cone are centred together, so that neither overlaps the neighbouring frame.
        double left =
                (pose.x() + cone.apex().plus(cone.axis().times(cone.range())).x() - SHOWN_LENGTH) / 2;
        PlanView plan = canvas.addPlan(
                new PixelRectangle(x + 6, 26, COLUMN_WIDTH - 12, 205),
                new Rectangle2D.Double(left, 1.25, SHOWN_LENGTH, 1.85));
        plan.drawLine(
                List.of(new Vector2(left, 2.5), new Vector2(left + SHOWN_LENGTH, 2.5)),
                LineStyle.solid(FigureCanvas.THEME.palette().obstacleOutline(), 3));
        plan.drawCone(cone, trace.setup().robot().indexOf(sensor.id()));
        plan.drawRobot(trace.setup().robot(), pose, 1);
        double middle = x + COLUMN_WIDTH / 2.0;
        if (moment.name().equals("F1")) {
            plan.drawScaleBar(0.5, COLUMN_WIDTH - 24, 24);
        }
        canvas.addPanelTitle(index, moment.name(), middle, 18);
        canvas.addLines(
                List.of(
                        moment.what(),
                        "t = "
                                + FigureNumbers.format(
                                        moment.tick() * trace.setup().dt(), 2) + " s, heading " + heading(pose)),
                middle,
                240);
    }

    private static String heading(Pose pose) {
        return FigureNumbers.format(degrees(pose), 1) + "\u00b0";
    }

    private static double degrees(Pose pose) {
        return StrictMath.toDegrees(Angles.normalize(pose.heading()));
    }

    private static Chart chart(RunTrace trace, ScenarioRun run, List<KeyMoment> moments) {
        double dt = trace.setup().dt();
        List<Vector2> readings = IntStream.range(0, (int) (SECONDS / dt))
                .mapToObj(tick -> new Vector2(
                        tick * dt, run.reading("left", tick * dt).distance().orElse(Double.NaN)))
                .toList();
        List<Series> series = new ArrayList<>();
        for (KeyMoment moment : moments) {
            double t = moment.tick() * dt;
            series.add(new Series.Line("", List.of(new Vector2(t, 0), new Vector2(t, 1)), 2));
            series.add(new Series.Note(moment.name(), new Vector2(t + 0.04, 0.92)));
        }
        series.add(new Series.Line("reading of the left sensor", readings, 0));
        double tD = (moments.get(3).tick() - moments.get(2).tick()) * dt;
        String title = "t_D = " + FigureNumbers.format(tD, 2) + " s, t_p = t_D/2 = " + FigureNumbers.format(tD / 2, 2)
                + " s; parallel but for "
                + FigureNumbers.format(degrees(trace.poses().get(moments.get(4).tick())), 1) + " degrees";
        return new Chart(
                FigureCanvas.panelTitle(moments.size(), title),
                Axis.linear("time (s)", 0, SECONDS),
                Axis.linear("reading (m)", 0, 1),
                series);
    }

    private static CsvTable table(RunTrace trace, List<KeyMoment> moments) {
        CsvTable table = new CsvTable("frame", "what", "t_s", "x_m", "y_m", "heading_deg");
        for (KeyMoment moment : moments) {
            Pose pose = trace.poses().get(moment.tick());
            table.addRow(
                    moment.name(),
                    moment.what(),
                    moment.tick() * trace.setup().dt(),
                    pose.x(),
                    pose.y(),
                    degrees(pose));
        }
        return table;
    }
}
