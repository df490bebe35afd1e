package faultline.studies;

import faultline.control.PdGains;
import faultline.control.wallfollower.WallFollower;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.world.World;
import java.util.ArrayList;
import java.util.List;

/**
 * The PD law and the motors beside a long straight wall: distance and heading are known, and a decision acts at the
 * next tick. The P term is clamped. The initial distance error, metres, is positive if too far; the heading, radians,
 * is positive towards the wall.
 */
record PdLoop(PdGains gains, double distanceError, double heading) {

    private static final SimulationSetup BASE =
            StudyScenarios.load("studies/pd-law.xml").setup();
    static final double TICK = BASE.dt();
    static final double SPEED = BASE.robot().speed();

    /**
     * The response of the loop, from the best to the worst. A settled loop keeps the distance within a millimetre; its
     * heading may still oscillate.
     */
    enum LoopResponse {
        SETTLES,
        SLOW,
        OSCILLATES,
        COLLIDES
    }

    private static final double SECONDS = 12;
    private static final double SETTLED_ERROR = 0.001;
    private static final double SETTLED_WINDOW = 2;

    /** Returns the distance errors of all ticks, metres, up to the contact with the wall. */
    List<Double> errors() {
        RobotSpec robot = BASE.robot();
        double line = BASE.start().y();
        World world = new World(
                BASE.world(), robot, new Pose(BASE.start().x(), line - distanceError, heading), TICK, BASE.seed());
        List<Double> errors = new ArrayList<>();
        double volts = robot.motor().voltageFor(SPEED);
        double half = 0;
        while (errors.size() * TICK < SECONDS && world.collision().isEmpty()) {
            double error = line - world.pose().y();
            errors.add(error);
            double rate = gains.proportionalTerm(error)
                    + gains.derivativeTerm(-SPEED * StrictMath.sin(world.pose().heading()));
            world.move(volts - half, volts + half);
            Velocity next = WallFollower.onCurve(SPEED, rate, robot.spinRate());
            volts = robot.motor().voltageFor(next.linear());
            half = robot.motor().voltageFor(next.angular() * robot.track() / 2);
        }
        return errors;
    }

    LoopResponse response() {
        List<Double> errors = errors();
        if ((errors.size() + 1) * TICK < SECONDS) {
            return LoopResponse.COLLIDES;
        }
        List<Double> late = errors.subList((int) ((SECONDS - SETTLED_WINDOW) / TICK), errors.size());
        double most = late.stream().mapToDouble(error -> error).max().orElseThrow();
        double least = late.stream().mapToDouble(error -> error).min().orElseThrow();
        if (Math.max(most, -least) < SETTLED_ERROR) {
            return LoopResponse.SETTLES;
        }
        return least > 0 || most < 0 ? LoopResponse.SLOW : LoopResponse.OSCILLATES;
    }
}
