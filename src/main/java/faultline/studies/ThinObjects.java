package faultline.studies;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.chart.Axis;
import faultline.paint.chart.Chart;
import faultline.paint.chart.Series;
import faultline.robot.RobotSpec;
import faultline.studies.figure.CsvTable;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import faultline.studies.figure.FigureNumbers;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Thin objects: the number of collisions with a pole beside a wall, by its thickness and the cones of the sensors. */
final class ThinObjects implements Figure {

    private static final List<Double> DIAMETERS = List.of(0.5, 2.0, 5.0, 20.0, 50.0);
    private static final List<Double> CONES = List.of(20.0, 8.0, 2.0);
    private static final int POSITIONS = 25;
    private static final double MIN_DISTANCE = 0.08;
    private static final double STEP = 0.02;
    private static final SimulationSetup BASE =
            StudyScenarios.load("studies/pole.xml").setup();

    private static final String CAPTION =
            """
            The share of runs that end at a pole which stands 0.08 to 0.56 m beside a long wall, over its diameter, \
            for all cones of 20, 8 and 2 degrees; n\u00a0=\u00a0%d places for each marker.""";

    @Override
    public void write(FigureFolder folder) throws IOException {
        CsvTable table = new CsvTable("cone_deg", "diameter_mm", "runs", "collisions");
        List<Series> series = new ArrayList<>();
        for (double cone : CONES) {
            List<Vector2> points = new ArrayList<>();
            for (double diameter : DIAMETERS) {
                long hit = collisions(cone, diameter / 1000);
                table.addRow(cone, diameter, POSITIONS, hit);
                points.add(new Vector2(diameter, 100.0 * hit / POSITIONS));
            }
            series.add(new Series.Line("", points, CONES.indexOf(cone)));
            series.add(new Series.Points(
                    "cones of " + FigureNumbers.format(cone, 0) + " degrees", points, CONES.indexOf(cone)));
        }
        Chart chart = new Chart(
                "A pole beside the wall",
                new Axis("diameter (mm)", 0.4, 60, true),
                Axis.linear("runs that end at it (%)", 0, 40),
                series);
        folder.writeChart("thin-objects", table, chart, 480, 360, String.format(Locale.ROOT, CAPTION, POSITIONS));
    }

    private static long collisions(double cone, double diameter) {
        long collisions = 0;
        for (int i = 0; i < POSITIONS; i++) {
            collisions +=
                    run(cone, diameter, MIN_DISTANCE + i * STEP).collision().isPresent() ? 1 : 0;
        }
        return collisions;
    }

    /** Runs the robot along a long wall to a pole at a distance from it. */
    private static RunResult run(double cone, double diameter, double away) {
        Obstacle pole = SetupVariations.findObstacle(BASE, "pole");
        Pose place = new Pose(pole.pose().x(), AlignmentTrial.WALL_Y - away - diameter / 2, 0);
        SimulationSetup varied = SetupVariations.with(
                BASE,
                pole.withShape(new ObstacleShape.CircleShape(diameter / 2)).withPose(place));
        RobotSpec robot = SetupVariations.withSensors(BASE.robot(), sensor -> sensor.withCone(Degrees.toRadians(cone)));
        return HeadlessRun.run(varied.withRobot(robot), ControllerMode.DIRECT, List.of());
    }
}
