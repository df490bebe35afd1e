package faultline.studies;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.Telemetry;
import faultline.control.TimingRule;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import java.util.Optional;

/**
 * A trial of eq. (4) in the whole simulator: the robot drives to a wall, spins, measures t_D, turns back, and enters
 * FOLLOW. The wall lies on y = {@link #WALL_Y}; heading 0 is parallel to it with the wall on the left. A control period
 * has five ticks, so that the robot moves smoothly between two samples.
 *
 * @param setup the setup
 * @param handOver the number of the alignment that counts, from 1
 */
record AlignmentTrial(SimulationSetup setup, int handOver) {

    /** The y coordinate of the wall in all files of the studies, metres. */
    static final double WALL_Y = 10;

    /** The setup that the trials start from. */
    static final SimulationSetup BASE =
            StudyScenarios.load("studies/eq4-wall.xml").setup();

    /**
     * The result of a trial at the first FOLLOW tick: the deviation from parallel, radians, positive towards the wall;
     * the position; the time between F3 and F4, seconds; and the true reading of the left sensor, metres.
     */
    record TrialResult(double headingError, Vector2 position, double tD, double distance) {}

    /** Returns the file's robot with sensors of a range and cone, a spin rate and motors of a time constant. */
    static RobotSpec robot(double range, double cone, double rate, double tau) {
        RobotSpec usual = BASE.robot();
        MotorSpec motor =
                new MotorSpec(tau, usual.motor().speedConstant(), usual.motor().maxVoltage());
        return SetupVariations.withSensors(usual.withTurnRate(rate).withMotor(motor), sensor -> sensor.withRange(range)
                .withCone(cone));
    }

    /** Returns the file's robot and control before its long wall. */
    static AlignmentTrial standard(TimingRule timing, int variant) {
        SimulationSetup before = WallScenes.endless(BASE, controllerSpec(BASE).distance(), variant);
        return new AlignmentTrial(before.withSeed(variant + 1L), 1).withTiming(timing);
    }

    private static WallFollowing controllerSpec(SimulationSetup setup) {
        return (WallFollowing) setup.controller();
    }

    private AlignmentTrial withControl(double distance, double period, TimingRule timing) {
        return new AlignmentTrial(
                setup.withController(controllerSpec(setup)
                        .withDistance(distance)
                        .withPeriod(period)
                        .withTimingRule(timing)),
                handOver);
    }

    private AlignmentTrial withTiming(TimingRule timing) {
        return withControl(controllerSpec(setup).distance(), period(), timing);
    }

    AlignmentTrial withRobot(RobotSpec robot) {
        return new AlignmentTrial(setup.withRobot(robot), handOver);
    }

    /** Returns this trial with the same robot, control and seed in another world. */
    AlignmentTrial withSetup(SimulationSetup place) {
        SimulationSetup there = place.withRobot(setup.robot()).withController(setup.controller());
        return new AlignmentTrial(there.withSeed(setup.seed()), handOver);
    }

    AlignmentTrial withDistance(double distance) {
        return withControl(distance, period(), timing());
    }

    AlignmentTrial withPeriod(double period) {
        return withControl(controllerSpec(setup).distance(), period, timing());
    }

    AlignmentTrial withHandOver(int newHandOver) {
        return new AlignmentTrial(setup, newHandOver);
    }

    RobotSpec robot() {
        return setup.robot();
    }

    /** Returns the control period, seconds. */
    double period() {
        return controllerSpec(setup).period();
    }

    /** Returns the rule for F3 and F4. */
    TimingRule timing() {
        return controllerSpec(setup).timingRule();
    }

    /** Runs the trial; returns empty if the robot never enters FOLLOW. */
    Optional<TrialResult> run() {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            int handOvers = 0;
            ControllerState before = FollowerState.SEARCH;
            while (simulation.time() < setup.duration()
                    && simulation.collision().isEmpty()) {
                simulation.tick();
                Telemetry now = simulation.telemetry();
                if (now.state() == FollowerState.FOLLOW && before == FollowerState.ALIGN && ++handOvers == handOver) {
                    Pose pose = simulation.pose();
                    return Optional.of(new TrialResult(
                            Angles.normalize(pose.heading()),
                            pose.position(),
                            now.edges().tF4() - now.edges().tF3(),
                            simulation.trueReading(setup.robot().indexOf("left"))));
                }
                before = now.state();
            }
            return Optional.empty();
        }
    }
}
