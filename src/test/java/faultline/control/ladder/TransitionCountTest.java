package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.Telemetry;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Transitions are counted and dated in the same way whichever strategy drives. */
class TransitionCountTest {

    /** The six states with all sensors and with fewer, the local map, no useful sensor, and the six states again. */
    private static final List<TimedCommand> SWITCHES = Stream.of(
                    switches(10, false, "rear"),
                    switches(20, false, "front"),
                    switches(50, false, "left", "front-left", "rear-left"),
                    switches(60, true, "front", "left", "front-left", "rear-left", "rear"),
                    switches(80, false, "left"),
                    switches(95, true, "left"))
            .flatMap(List::stream)
            .toList();

    private static List<TimedCommand> switches(double time, boolean on, String... sensors) {
        return Stream.of(sensors)
                .map(sensor -> new TimedCommand(time, new Command.SwitchSensor(sensor, on)))
                .toList();
    }

    @Test
    void everyChangeOfStateCountsOnceAndIsDatedWithTheTickOfItsDecision() {
        SimulationSetup setup = new SimulationSetup(
                new WorldSpec(5, 4, true, 3, List.of()),
                RobotSpec.DEFAULT,
                new Pose(2, 2, 0.4),
                ControllerSpec.WallFollowing.DEFAULT,
                SWITCHES,
                0.01,
                1,
                120);
        Set<String> rungs = new HashSet<>();
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            Telemetry before = simulation.telemetry();
            while (simulation.time() < setup.duration()) {
                simulation.tick();
                Telemetry now = simulation.telemetry();
                rungs.add(now.diagnosis().rung());
                boolean changed = !now.state().equals(before.state());
                assertEquals(before.transitions() + (changed ? 1 : 0), now.transitions(), "tick " + simulation.ticks());
                assertEquals(changed ? simulation.ticks() - 1 : before.sinceTick(), now.sinceTick());
                before = now;
            }
            assertTrue(before.transitions() > 10, "transitions: " + before.transitions());
        }
        assertTrue(rungs.containsAll(Set.of("ALL", "THREE", "STOP", "REDUCED")), rungs.toString());
    }
}
