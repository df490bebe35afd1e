package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.RobotPath;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The keyframes of a run so long that its path has been thinned several times. */
class KeyframeRecorderTest {

    /** In each tick the robot drives far enough for a point of its path. */
    private static final SimulationSetup CIRCLE = SimulationSetup.of(
                    new WorldSpec(6, 6, true, 3, List.of()), new Pose(3, 3, 0))
            .withController(new ControllerSpec.Drive(3, 2))
            .withTick(0.05);

    private static final long TICKS = 700_000;

    @Test
    void everyKeyframeSharesThePointsOfTheNewestPath() {
        KeyframeRecorder recorder = new KeyframeRecorder();
        int thinnings = 0;
        try (Simulation run = new Simulation(CIRCLE, ControllerMode.DIRECT)) {
            RobotPath last = run.frame().path();
            recorder.add(run.frame());
            while (run.ticks() < TICKS) {
                run.tick();
                if (recorder.isDue(run.ticks())) {
                    Frame frame = run.frame();
                    recorder.add(frame);
                    thinnings += frame.path().isContinuationOf(last) ? 0 : 1;
                    last = frame.path();
                }
            }
        }
        assertTrue(thinnings >= 3, thinnings + " thinnings");
        Keyframes frames = recorder.view();
        RobotPath newest = frames.frameAt(TICKS).orElseThrow().path();
        int size = 0;
        long stride = frames.frameAt(Long.MAX_VALUE).orElseThrow().snapshot().tick() / (frames.size() - 1);
        for (long tick = 0; tick < TICKS; tick += stride) {
            Frame frame = frames.frameAt(tick).orElseThrow();
            assertEquals(tick, frame.snapshot().tick());
            assertTrue(newest.isContinuationOf(frame.path()), "at tick " + tick);
            assertTrue(frame.path().size() >= size, "at tick " + tick);
            size = frame.path().size();
        }
    }

    @Test
    void theOnlyKeyframeIsThatOfEveryTick() {
        assertEquals(Optional.empty(), Keyframes.EMPTY.frameAt(0));
        assertEquals(0, Keyframes.EMPTY.size());
        KeyframeRecorder recorder = new KeyframeRecorder();
        assertEquals(Optional.empty(), recorder.view().frameAt(0));
        try (Simulation run = new Simulation(CIRCLE, ControllerMode.DIRECT)) {
            Frame first = run.frame();
            recorder.add(first);
            assertEquals(Optional.of(first), recorder.view().frameAt(0));
            assertEquals(Optional.of(first), recorder.view().frameAt(TICKS));
        }
    }
}
