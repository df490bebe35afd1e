package faultline.app.figures;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.control.Hand;
import faultline.control.Telemetry;
import faultline.control.Timing;
import faultline.engine.ControllerMode;
import faultline.engine.Setup;
import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;

/**
 * One trial of eq. (4) in the whole simulator: the robot drives to a wall, spins, times the wall, turns back, and hands over to FOLLOW. The wall in question
 * lies on y = {@link #WALL}; parallel to it, with the wall on the left, is heading 0.
 *
 * @param robot as built
 * @param place where it starts and what stands there
 * @param distance that it is to hold, metres
 * @param period of its control, seconds
 * @param timing which moments are F3 and F4
 * @param seed of the noise
 * @param handOver which alignment counts: 1 for the first
 */
record Alignment(RobotSpec robot, Place place, double distance, double period, Timing timing, long seed, int handOver) {

    /** Where the wall in question lies, metres. */
    static final double WALL = 10;

    private static final double SIZE = 2 * WALL;
    /** Five ticks a control period: between two looks the robot moves as smoothly as a real one. */
    private static final double DT = 0.002;
    private static final double MOST_SECONDS = 45;

    /** What stands there and where the robot starts. */
    record Place(WorldSpec world, Pose start) {

        /** An obstacle list as a world without a fence. */
        static Place of(List<faultline.world.Obstacle> obstacles, Pose start) {
            return new Place(new WorldSpec(SIZE, SIZE, false, 0, obstacles), start);
        }
    }

    /**
     * What came of a trial.
     *
     * @param error how far the robot is turned from parallel at the first FOLLOW tick, radians, positive towards the wall
     * @param at where it stands then
     * @param tD the time between F3 and F4, seconds
     */
    record Outcome(double error, Vec at, double tD) {
    }

    /** The robot of the study: as shipped, its sensors of a range and cone. */
    static RobotSpec robot(double range, double cone, double rate, double tau) {
        RobotSpec usual = RobotSpec.DEFAULT;
        List<SensorSpec> sensors = usual.sensors().stream().map(sensor -> sensor.withRange(range).withCone(cone)).toList();
        return new RobotSpec(usual.length(), usual.width(), usual.track(), usual.speed(), rate, new MotorSpec(tau, 0.1, 6), sensors);
    }

    /** The usual robot and control before a long wall. */
    static Alignment usual(Timing timing, int variant) {
        return new Alignment(robot(0.8, Degrees.toRadians(20), Degrees.toRadians(60), 0.05), Walls.endless(0.25, variant), 0.25, 0.01, timing, variant + 1, 1);
    }

    Alignment with(RobotSpec other) {
        return new Alignment(other, place, distance, period, timing, seed, handOver);
    }

    Alignment in(Place other) {
        return new Alignment(robot, other, distance, period, timing, seed, handOver);
    }

    Alignment holding(double newDistance) {
        return new Alignment(robot, place, newDistance, period, timing, seed, handOver);
    }

    Alignment deciding(double newPeriod) {
        return new Alignment(robot, place, distance, newPeriod, timing, seed, handOver);
    }

    Alignment counting(int newHandOver) {
        return new Alignment(robot, place, distance, period, timing, seed, newHandOver);
    }

    Setup setup() {
        return new Setup(place.world(), robot, place.start(), new WallFollowing(distance, Hand.LEFT, period, timing), List.of(), DT, seed, MOST_SECONDS);
    }

    /** Runs the trial; empty where the robot never hands over. */
    Optional<Outcome> run() {
        try (Simulation simulation = new Simulation(setup(), ControllerMode.DIRECT)) {
            int handOvers = 0;
            String before = "";
            while (simulation.time() < MOST_SECONDS && simulation.collision().isEmpty()) {
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
