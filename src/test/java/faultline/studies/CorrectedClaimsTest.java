package faultline.studies;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RandomRoom;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.TimingRule;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Degrees;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Claims that were wrong once, on worlds and seeds that no study uses. */
class CorrectedClaimsTest {

    /** The paper's t_D depends on the left sensor alone, also on what the follower knows of noise. */
    @Test
    void noiseOfTheFrontSensorBeforeTheSpinDoesNotChangeItsTiming() {
        int compared = 0;
        for (int variant = 0; variant < 20; variant++) {
            AlignmentTrial quiet = AlignmentTrial.standard(TimingRule.EQUAL_READINGS, variant)
                    .withSetup(WallScenes.endless(AlignmentTrial.BASE, 0.55 + 0.013 * variant, variant % 6));
            RunTrace reference = RunTrace.simulate(quiet.setup().withDuration(10));
            int spin = reference.states().indexOf(FollowerState.TURN);
            SensorSpec front = quiet.robot().sensor("front").orElseThrow();
            double dt = quiet.setup().dt();
            SimulationSetup disturbed = quiet.setup()
                    .withTimeline(List.of(
                            new TimedCommand(0, new Command.ConfigureSensor(front.withNoise(0.008))),
                            new TimedCommand((spin - 25) * dt, new Command.ConfigureSensor(front))));
            RunTrace noisy = RunTrace.simulate(disturbed.withDuration(10));
            if (noisy.states().indexOf(FollowerState.TURN) == spin) {
                compared++;
                assertEquals(reference.poses().get(spin), noisy.poses().get(spin));
                assertEquals(
                        quiet.run().orElseThrow().tD(),
                        new AlignmentTrial(disturbed, 1).run().orElseThrow().tD(),
                        "variant " + variant);
            }
        }
        assertTrue(compared >= 10, compared + " spins began at the same tick");
    }

    @Test
    void littleNoiseDoesNotMakeTheFollowerAlternateBetweenWallAndCorner() {
        SimulationSetup office = StudyScenarios.load("office.xml").setup();
        int quiet = corners(office.withDuration(90));
        for (int seed = 7001; seed <= 7010; seed++) {
            int noisy = corners(
                    SetupVariations.withNoise(office, 0.001).withSeed(seed).withDuration(90));
            assertTrue(noisy <= 2 * quiet, noisy + " corners instead of " + quiet + ", seed " + seed);
        }
    }

    private static int corners(SimulationSetup setup) {
        List<ControllerState> states = RunTrace.simulate(setup).states();
        AtomicInteger count = new AtomicInteger();
        for (int i = 1; i < states.size(); i++) {
            if (states.get(i) == FollowerState.ROUND && states.get(i - 1) != FollowerState.ROUND) {
                count.incrementAndGet();
            }
        }
        return count.get();
    }

    @Test
    void randomRoomsAreFollowedThroughLittleNoiseWithAnErrorOfAFewMillimetres() {
        for (int seed = 9001; seed <= 9012; seed++) {
            RandomRoom room = RandomRoom.ofSeed(seed);
            SimulationSetup setup = SetupVariations.withNoise(
                    StudyScenarios.load("office.xml").setup().withWorld(room.world()), 0.001);
            RunResult result = HeadlessRun.run(
                    setup.withStart(room.start()).withSeed(seed).withDuration(90), ControllerMode.DIRECT, List.of());
            assertTrue(result.collision().isEmpty(), "collision in room " + seed);
            assertTrue(result.distanceRms().orElse(0) < 0.012, "room " + seed + ": " + result.distanceRms());
        }
    }

    @Test
    void equalReadingsAlignWithAWallFarAwayAsWellAsWithANearOne() {
        for (int i = 0; i < 12; i++) {
            double distance = 1.6 + 0.11 * i;
            AlignmentTrial trial = AlignmentTrial.standard(TimingRule.EQUAL_READINGS, 30 + i)
                    .withRobot(AlignmentTrial.robot(4, Degrees.toRadians(20), Degrees.toRadians(60), 0.05))
                    .withDistance(distance)
                    .withSetup(WallScenes.endless(AlignmentTrial.BASE, distance, i));
            double error = Math.toDegrees(trial.run().orElseThrow().headingError());
            assertEquals(0, error, 0.3, "at " + distance + " m");
        }
    }
}
