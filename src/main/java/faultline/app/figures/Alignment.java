package faultline.app.figures;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.Timing;
import faultline.engine.ControllerMode;
import faultline.engine.Setup;
import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.List;
import java.util.Optional;

/**
 * One trial of eq. (4) in the whole simulator: the robot drives to a wall, spins, times the wall, turns back, and hands over to FOLLOW. The
 * wall in question lies on y = {@link #WALL}; parallel to it, with the wall on the left, is heading 0. Five ticks a control period: between
 * two looks the robot moves as smoothly as a real one.
 *
 * @param setup what is run
 * @param handOver which alignment counts: 1 for the first
 */
record Alignment(Setup setup, int handOver) {

    /** Where the wall in question lies in all files of the studies, metres. */
    static final double WALL = 10;

    /** The file that the trials start from. */
    static final Setup BASE = Shipped.load("studies/eq4-wall.xml").setup();

    /**
     * What came of a trial.
     *
     * @param error how far the robot is turned from parallel at the first FOLLOW tick, radians, positive towards the wall
     * @param at where it stands then
     * @param tD the time between F3 and F4, seconds
     */
    record Outcome(double error, Vec at, double tD) {
    }

    /** The file's robot, with sensors of a range and cone, a spin rate and motors of a time constant. */
    static RobotSpec robot(double range, double cone, double rate, double tau) {
        RobotSpec usual = BASE.robot();
        List<SensorSpec> sensors = usual.sensors().stream().map(sensor -> sensor.withRange(range).withCone(cone)).toList();
        MotorSpec motor = new MotorSpec(tau, usual.motor().speedConstant(), usual.motor().maxVoltage());
        return new RobotSpec(usual.length(), usual.width(), usual.track(), usual.speed(), rate, motor, sensors);
    }

    /** The file's robot and control before its long wall. */
    static Alignment usual(Timing timing, int variant) {
        Setup before = Walls.endless(BASE, control(BASE).distance(), variant);
        return new Alignment(before.withSeed(variant + 1L), 1).timed(timing);
    }

    private static WallFollowing control(Setup setup) {
        return (WallFollowing) setup.controller();
    }

    private Alignment controlled(double distance, double period, Timing timing) {
        return new Alignment(Variation.of(setup, new WallFollowing(distance, control(setup).hand(), period, timing)), handOver);
    }

    private Alignment timed(Timing timing) {
        return controlled(control(setup).distance(), period(), timing);
    }

    Alignment with(RobotSpec robot) {
        return new Alignment(Variation.of(setup, robot), handOver);
    }

    /** The same robot, control and seed elsewhere. */
    Alignment in(Setup place) {
        Setup there = Variation.of(Variation.of(place, setup.robot()), setup.controller());
        return new Alignment(there.withSeed(setup.seed()), handOver);
    }

    Alignment holding(double distance) {
        return controlled(distance, period(), timing());
    }

    Alignment deciding(double period) {
        return controlled(control(setup).distance(), period, timing());
    }

    Alignment counting(int newHandOver) {
        return new Alignment(setup, newHandOver);
    }

    RobotSpec robot() {
        return setup.robot();
    }

    /** The period of its control, seconds. */
    double period() {
        return control(setup).period();
    }

    /** Which moments are F3 and F4. */
    Timing timing() {
        return control(setup).timing();
    }

    /** Runs the trial; empty where the robot never hands over. */
    Optional<Outcome> run() {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            int handOvers = 0;
            String before = "";
            while (simulation.time() < setup.duration() && simulation.collision().isEmpty()) {
                simulation.tick();
                Telemetry now = simulation.telemetry();
                if (now.state().equals(FollowerState.FOLLOW.name()) && before.equals(FollowerState.ALIGN.name()) && ++handOvers == handOver) {
                    Pose pose = simulation.pose();
                    return Optional.of(new Outcome(Angles.normalize(pose.heading()), pose.position(), now.tF4() - now.tF3()));
                }
                before = now.state();
            }
            return Optional.empty();
        }
    }
}
