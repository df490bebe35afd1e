package faultline.app.figures;

import faultline.control.PdGains;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * The PD law and the motors beside a long straight wall, and nothing else: distance and heading are known, a decision acts at the next tick.
 *
 * @param gains of the law
 * @param tooFar how much too far from the wall the robot starts, metres
 * @param heading that it starts at, radians towards the wall
 */
record PdLoop(PdGains gains, double tooFar, double heading) {

    static final double WANTED = 0.25;
    static final double TICK = 0.01;
    static final double SPEED = RobotSpec.DEFAULT.speed();

    /** What became of the loop, from the best to the worst. */
    enum Fate {
        SETTLES, SLOW, SWINGS, TOUCHES
    }

    private static final double SECONDS = 12;
    private static final double SETTLED = 0.001;
    private static final double LATE = 2;
    private static final double SIZE = 100;
    private static final double SLOWEST = 0.3;

    /** The distance errors tick by tick, metres; they end where the robot touches the wall. */
    List<Double> errors() {
        RobotSpec robot = RobotSpec.DEFAULT;
        Obstacle wall = new Obstacle("wall", new ObstacleShape.Wall(List.of(new Vec(0, SIZE / 2), new Vec(SIZE, SIZE / 2))), Pose.ORIGIN);
        Pose start = new Pose(SIZE / 2, SIZE / 2 - robot.width() / 2 - WANTED - tooFar, heading);
        World world = new World(new WorldSpec(SIZE, SIZE, false, 0, List.of(wall)), robot, start, TICK, 1);
        List<Double> errors = new ArrayList<>();
        double volts = robot.motor().voltageFor(SPEED);
        double half = 0;
        while (errors.size() * TICK < SECONDS && world.collision().isEmpty()) {
            double error = SIZE / 2 - world.pose().y() - robot.width() / 2 - WANTED;
            errors.add(error);
            double rate = gains.proportionalTerm(error) + gains.derivativeTerm(-SPEED * StrictMath.sin(world.pose().heading()));
            world.move(volts - half, volts + half);
            double share = Math.max(SLOWEST, Math.min(1, robot.turnRate() / Math.abs(rate)));
            double held = Math.max(-robot.turnRate(), Math.min(robot.turnRate(), rate));
            volts = robot.motor().voltageFor(share * SPEED);
            half = robot.motor().voltageFor(held * robot.track() / 2);
        }
        return errors;
    }

    Fate fate() {
        List<Double> errors = errors();
        if ((errors.size() + 1) * TICK < SECONDS) {
            return Fate.TOUCHES;
        }
        List<Double> late = errors.subList((int) ((SECONDS - LATE) / TICK), errors.size());
        double most = late.stream().mapToDouble(error -> error).max().orElseThrow();
        double least = late.stream().mapToDouble(error -> error).min().orElseThrow();
        if (Math.max(most, -least) < SETTLED) {
            return Fate.SETTLES;
        }
        return least > 0 || most < 0 ? Fate.SLOW : Fate.SWINGS;
    }
}
