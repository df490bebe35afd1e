package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.WallSide;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A sensor that causes repeated alignments is not trusted, and the robot continues without it. */
class MisleadingSensorTest {

    private static Simulation inRoom(WallSide side, List<TimedCommand> timeline) {
        return new Simulation(
                new SimulationSetup(
                        new WorldSpec(4.3, 3.7, true, 3, List.of()),
                        RobotSpec.DEFAULT,
                        new Pose(1.1, 0.9, 0.2),
                        ControllerSpec.WallFollowing.DEFAULT.withSide(side),
                        timeline,
                        0.01,
                        1,
                        300),
                ControllerMode.DIRECT);
    }

    private static void runTo(Simulation simulation, double time) {
        while (simulation.time() < time) {
            simulation.tick();
        }
    }

    private static SensorHealth health(Simulation simulation, String sensor) {
        return simulation.telemetry().diagnosis().health().stream()
                .filter(health -> health.sensor().equals(sensor))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the length of the way on which the robot's centre was in a time, metres. */
    private static double rolled(Simulation simulation, double seconds) {
        double end = simulation.time() + seconds;
        double way = 0;
        while (simulation.time() < end) {
            Pose before = simulation.pose();
            simulation.tick();
            way += Math.hypot(
                    simulation.pose().x() - before.x(), simulation.pose().y() - before.y());
        }
        return way;
    }

    @ParameterizedTest
    @CsvSource({"LEFT,left,MISALIGNED,24", "RIGHT,right,MISALIGNED,-24"})
    void anAskewSensorIsFoundByTheRepeatedAlignments(WallSide side, String sensor, FaultKind kind, double value) {
        Simulation simulation =
                inRoom(side, List.of(new TimedCommand(12, new Command.InjectFault(sensor, kind.createFault(value)))));
        runTo(simulation, 12);
        while (simulation.time() < 60 && health(simulation, sensor).isTrusted()) {
            simulation.tick();
        }
        assertEquals(SensorFinding.MISLEADING, health(simulation, sensor).finding());
        double way = rolled(simulation, 30);
        assertEquals("THREE", simulation.telemetry().diagnosis().rung());
        assertTrue(way > 6, "rolled only " + way);
        assertTrue(simulation.collision().isEmpty());
    }

    @Test
    void cornersOfARoomAreNoRepeatedAlignments() {
        Simulation simulation = inRoom(WallSide.LEFT, List.of());
        runTo(simulation, 200);
        assertTrue(health(simulation, "left").isTrusted());
        assertTrue(simulation.telemetry().transitions() > 40, "many corners were passed");
    }

    @Test
    void alignmentsAreTooManyOnlyWithinAShortWay() {
        AlignmentMonitor monitor = new AlignmentMonitor();
        for (int i = 0; i < 5; i++) {
            assertFalse(monitor.isRepeated(3 + 0.1 * i, 0.01 * i));
        }
        assertTrue(monitor.isRepeated(3.6, 0.05));
        monitor.reset();
        for (int i = 0; i < 20; i++) {
            assertFalse(monitor.isRepeated(0.5 * i, 0));
        }
    }

    @Test
    void alignmentsWithWallsOfManyDirectionsAreNotRepeated() {
        // As in a corner of a floor plan with a staircase for a wall.
        double[] directions = {0, -52, -91, -92, -80, -124, -180};
        AlignmentMonitor monitor = new AlignmentMonitor();
        for (int i = 0; i < directions.length; i++) {
            assertFalse(monitor.isRepeated(3 + 0.05 * i, Math.toRadians(directions[i])));
        }
        assertTrue(monitor.isRepeated(3.5, Math.toRadians(-182)));
    }
}
