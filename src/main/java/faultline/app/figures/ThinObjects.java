package faultline.app.figures;

import faultline.engine.ControllerMode;
import faultline.engine.HeadlessRun;
import faultline.engine.RunResult;
import faultline.engine.Setup;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Thin objects: how often a pole that stands beside a wall is run into, by its thickness and the sensors' cones. */
final class ThinObjects implements Figure {

    private static final List<Double> DIAMETERS = List.of(0.5, 2.0, 5.0, 20.0, 50.0);
    private static final List<Double> CONES = List.of(20.0, 8.0, 2.0);
    private static final int PLACES = 25;
    private static final double NEAREST = 0.08;
    private static final double STEP = 0.02;
    private static final Setup BASE = Shipped.load("studies/pole.xml").setup();

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("cone_deg", "diameter_mm", "runs", "collisions");
        List<Mark> marks = new ArrayList<>();
        for (double cone : CONES) {
            List<Vec> points = new ArrayList<>();
            for (double diameter : DIAMETERS) {
                long hit = collisions(cone, diameter / 1000);
                table.row(cone, diameter, PLACES, hit);
                points.add(new Vec(diameter, 100.0 * hit / PLACES));
            }
            marks.add(new Mark.Line("", points, CONES.indexOf(cone)));
            marks.add(new Mark.Points("cones of " + Numbers.text(cone, 0) + " degrees", points, CONES.indexOf(cone)));
        }
        Chart chart = new Chart("A pole beside the wall", new Axis("diameter (mm)", 0.4, 60, true),
                Axis.linear("runs that end at it (%)", 0, 40), marks);
        folder.csv("thin-objects", table);
        folder.svg("thin-objects", Sheet.of(chart, 480, 360));
    }

    private static long collisions(double cone, double diameter) {
        long collisions = 0;
        for (int i = 0; i < PLACES; i++) {
            collisions += run(cone, diameter, NEAREST + i * STEP).collision().isPresent() ? 1 : 0;
        }
        return collisions;
    }

    /** A long wall is followed to a pole at a distance from it. */
    private static RunResult run(double cone, double diameter, double away) {
        Obstacle pole = Variation.obstacle(BASE, "pole");
        Pose place = new Pose(pole.pose().x(), Alignment.WALL - away - diameter / 2, 0);
        Setup varied = Variation.of(BASE, pole.shaped(new ObstacleShape.Circle(diameter / 2)).at(place));
        RobotSpec robot = BASE.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(sensor.withCone(Degrees.toRadians(cone)));
        }
        return HeadlessRun.run(Variation.of(varied, robot), ControllerMode.DIRECT, List.of());
    }
}
