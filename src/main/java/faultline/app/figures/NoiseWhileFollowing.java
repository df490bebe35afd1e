package faultline.app.figures;

import faultline.engine.ControllerMode;
import faultline.engine.HeadlessRun;
import faultline.engine.RunResult;
import faultline.engine.Setup;
import faultline.geometry.Vec;
import faultline.paint.plot.Axis;
import faultline.paint.plot.Chart;
import faultline.paint.plot.Mark;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/** Noise: what it does to following, in the room of a shipped scenario. */
final class NoiseWhileFollowing implements Figure {

    private static final String SCENARIO = "noisy-sensors.xml";
    private static final int STEPS = 13;
    private static final int SEEDS = 12;

    @Override
    public void make(FigureFolder folder) throws IOException {
        Table table = new Table("noise_mm", "seed", "distance_rms_mm", "coverage", "collided");
        List<Vec> errors = new ArrayList<>();
        for (int millimetres = 0; millimetres < STEPS; millimetres++) {
            for (int seed = 1; seed <= SEEDS; seed++) {
                RunResult result = HeadlessRun.run(noisy(millimetres / 1000.0).withSeed(seed), ControllerMode.DIRECT, List.of());
                double rms = 1000 * result.distanceRms().orElse(Double.NaN);
                table.row(millimetres, seed, rms, result.coverage().orElse(Double.NaN), result.collision().isPresent());
                errors.add(new Vec(millimetres, rms));
            }
        }
        Axis y = Axis.covering("distance error, RMS (mm)", DoubleStream.concat(DoubleStream.of(0), errors.stream().mapToDouble(Vec::y)));
        Chart chart = new Chart("Following with noisy sensors", Axis.linear("standard deviation of the noise (mm)", 0, STEPS - 1), y,
                List.of(new Mark.Line("half of the noise", List.of(Vec.ZERO, new Vec(STEPS, STEPS / 2.0)), 1),
                        new Mark.Points("runs", errors, 0)));
        folder.csv("noise-following", table);
        folder.svg("noise-following", Sheet.of(chart, 480, 360));
    }

    private static Setup noisy(double deviation) {
        Setup setup = Shipped.load(SCENARIO).setup();
        RobotSpec robot = setup.robot();
        for (SensorSpec sensor : robot.sensors()) {
            robot = robot.withSensor(new SensorSpec(sensor.id(), sensor.seat(), sensor.bearing(), sensor.range(), sensor.cone(),
                    sensor.on(), deviation));
        }
        return new Setup(setup.world(), robot, setup.start(), setup.controller(), setup.timeline(), setup.dt(), setup.seed(), setup.duration());
    }
}
