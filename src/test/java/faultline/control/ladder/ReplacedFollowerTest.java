package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RandomRoom;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Decision;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.control.WallSide;
import faultline.control.wallfollower.Observations;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.world.Command;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A follower that replaces another one while the robot moves. */
class ReplacedFollowerTest {

    /** Slow motors keep the robot in motion for some time after the change. */
    @ParameterizedTest
    @CsvSource({"7730011, 0.2, 33.91, LEFT", "7730056, 0.2, 33.86, RIGHT", "7730030, 0.5, 33.95, RIGHT"})
    void healthySensorsRemainTrusted(long seed, double timeConstant, double change, WallSide side) {
        WallFollowing other = WallFollowing.DEFAULT.withPeriod(0.02).withSide(side);
        RandomRoom room = RandomRoom.ofSeed(seed);
        SimulationSetup setup = SimulationSetup.of(room.world(), room.start())
                .withRobot(RobotSpec.DEFAULT.withMotor(new MotorSpec(timeConstant, 0.1, 6)))
                .withTimeline(List.of(new TimedCommand(change, new Command.ConfigureController(other))));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            while (simulation.time() < change + 20) {
                simulation.tick();
                for (SensorHealth health : simulation.telemetry().diagnosis().health()) {
                    assertEquals(SensorTrust.TRUSTED, health.trust(), () -> health + " at " + simulation.time());
                }
            }
        }
    }

    /** The loop over all ticks of that run would take minutes. */
    @Test
    void theTicksBeforeItBeginsDoNotCount() {
        FaultTolerantFollower follower = new FaultTolerantFollower(WallFollowing.DEFAULT);
        follower.begin(100_000_000_000L, new WheelSpeeds(0.3, 0.3));
        Decision decision = follower.decide(Observations.observation(100_000_000_000L, Map.of()));
        assertTrue(decision.leftVolts() > 0);
    }
}
