package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.TimingRule;
import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Eq. (4) in the whole simulator: how parallel to a long wall the robot stands when ALIGN hands over to FOLLOW. The
 * bound follows from the rule's own error terms: each edge of the detection interval is known to one control period, so
 * their mean to omega T at most; and the spin that is left at the hand-over, below 1 deg/s, decays with the motor.
 * {@link AlignmentModelTest} shows the effect of the terms without compensation.
 */
class AlignmentTest {

    private static final int COMBINATIONS = 1200;
    private static final double MAX_ERROR = Math.toRadians(1.0);
    private static final double MAX_FINAL_RATE = Math.toRadians(1);
    private static final double DT = 0.01;
    private static final double MAX_SECONDS = 60;

    /** An approach to a wall; angles in radians, the direction from the wall's normal. */
    private record Approach(
            double angle,
            double distance,
            double range,
            double cone,
            double rate,
            double period,
            double tau,
            WallSide side,
            TimingRule timingRule) {

        static Approach ofDefaultRobot(double angle) {
            return new Approach(
                    angle,
                    0.25,
                    SensorSpec.DEFAULT_RANGE,
                    SensorSpec.DEFAULT_CONE,
                    RobotSpec.DEFAULT.turnRate(),
                    0,
                    MotorSpec.DEFAULT.timeConstant(),
                    WallSide.LEFT,
                    TimingRule.EQUAL_READINGS);
        }

        static Approach random(SplittableRandom random) {
            double[] periods = {0, 0.01, 0.02, 0.03, 0.05};
            return new Approach(
                    Math.toRadians(random.nextDouble(-50, 50)),
                    random.nextDouble(0.15, 0.4),
                    random.nextDouble(0.5, 1.5),
                    Math.toRadians(random.nextDouble(2, 60)),
                    Math.toRadians(random.nextDouble(20, 120)),
                    periods[random.nextInt(periods.length)],
                    random.nextDouble(0.1),
                    random.nextBoolean() ? WallSide.LEFT : WallSide.RIGHT,
                    TimingRule.EQUAL_READINGS);
        }

        double bound() {
            return rate * Math.max(period, DT) + MAX_FINAL_RATE * (tau + DT);
        }

        /**
         * Returns the angle between robot and wall in the first tick of FOLLOW, radians; empty if FOLLOW is not
         * reached.
         */
        Optional<Double> headingError() {
            try (Simulation simulation = new Simulation(setup(), ControllerMode.DIRECT)) {
                while (simulation.time() < MAX_SECONDS && simulation.collision().isEmpty()) {
                    simulation.tick();
                    if (simulation.telemetry().state() == FollowerState.FOLLOW) {
                        // The wall is the world's upper side: parallel to it with the wall on the left is heading 0, on
                        // the right pi.
                        return Optional.of(Angles.difference(
                                side == WallSide.LEFT ? 0 : Math.PI,
                                simulation.pose().heading()));
                    }
                }
                return Optional.empty();
            }
        }

        private SimulationSetup setup() {
            RobotSpec standard = RobotSpec.DEFAULT;
            RobotSpec robot = new RobotSpec(
                    standard.length(),
                    standard.width(),
                    standard.track(),
                    standard.speed(),
                    rate,
                    new MotorSpec(tau, 0.1, 6),
                    DriveScale.NONE,
                    standard.sensors());
            for (SensorSpec sensor : standard.sensors()) {
                robot = robot.withSensor(sensor.withRange(range).withCone(cone));
            }
            // The six states alone: cones of up to 60 degrees are beyond what the diagnosis was made for.
            return SimulationSetup.of(new WorldSpec(30, 30, true, 0, List.of()), new Pose(15, 28, Math.PI / 2 + angle))
                    .withRobot(robot)
                    .withController(ControllerSpec.WallFollowing.DEFAULT
                            .withDistance(distance)
                            .withSide(side)
                            .withPeriod(period)
                            .withTimingRule(timingRule)
                            .withDiagnosis(false))
                    .withTick(DT)
                    .withDuration(MAX_SECONDS);
        }
    }

    @Test
    void fromAnyApproachTheDefaultRobotEndsWithinOneDegree() {
        for (int degrees = -50; degrees <= 50; degrees++) {
            Approach approach = Approach.ofDefaultRobot(Math.toRadians(degrees));
            assertEquals(0, approach.headingError().orElseThrow(), MAX_ERROR, approach::toString);
        }
    }

    @Test
    void anyRobotEndsWithinTheBoundOfItsErrorTerms() {
        SplittableRandom random = new SplittableRandom(61);
        for (int i = 0; i < COMBINATIONS; i++) {
            Approach approach = Approach.random(random);
            Optional<Double> error = approach.headingError();
            assertTrue(error.isPresent(), () -> approach + " never follows");
            assertEquals(0, error.get(), Math.min(MAX_ERROR, approach.bound()), approach::toString);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.02, 0.1, 0.2})
    void theMotorsLagIsMadeUpFor(double tau) {
        // Left alone, the lag would cost omega tau: 3 degrees at 0.05 s and 12 at 0.2 s.
        assertEquals(
                0,
                straightApproach(tau, TimingRule.EQUAL_READINGS).headingError().orElseThrow(),
                Math.toRadians(0.3));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.02, 0.05, 0.2})
    void thePapersExactRuleLosesOmegaTauAndTheDelays(double tau) {
        Approach letter = straightApproach(tau, TimingRule.RANGE);
        assertEquals(-letter.rate * (tau + DT / 2), letter.headingError().orElseThrow(), letter.bound());
    }

    private static Approach straightApproach(double tau, TimingRule timing) {
        Approach base = Approach.ofDefaultRobot(0);
        return new Approach(0, base.distance, base.range, base.cone, base.rate, 0, tau, WallSide.LEFT, timing);
    }
}
