package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.Telemetry;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import faultline.robot.MotorSide;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Motors that fail, and a drive that differs from what the controller believes, in runs of a large empty room. */
class FaultyDriveTest {

    /** Motors without lag, 0.1 m/s per volt. */
    private static final RobotSpec ROBOT = RobotSpec.DEFAULT.withMotor(new MotorSpec(0, 0.1, 6));

    private static Simulation run(RobotSpec robot, double leftVolts, double rightVolts, TimedCommand... timeline) {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(20, 20, true, 3, List.of()), new Pose(10, 10, 0))
                .withRobot(robot)
                .withController(new ControllerSpec.Drive(leftVolts, rightVolts))
                .withTimeline(List.of(timeline))
                .withDuration(60);
        return new Simulation(setup, ControllerMode.DIRECT);
    }

    private static void runTo(Simulation simulation, double time) {
        while (simulation.time() < time - 1e-9) {
            simulation.tick();
        }
    }

    private static TimedCommand breaking(double at, MotorSide motor, MotorFault fault) {
        return new TimedCommand(at, new Command.InjectMotorFault(motor, fault));
    }

    /** A file may have its commands in any order. */
    @Test
    void commandsAreExecutedAtTheirTimesNotInTheOrderOfTheList() {
        MotorFault weak = new MotorFault.Weak(0.5);
        TimedCommand repair = new TimedCommand(2, new Command.ClearMotorFault(MotorSide.LEFT, weak));
        try (Simulation simulation = run(ROBOT, 3, 3, repair, breaking(1, MotorSide.LEFT, weak))) {
            runTo(simulation, 1.5);
            assertEquals(
                    List.of(weak), simulation.frame().snapshot().motorFaults().left());
            runTo(simulation, 2.5);
            assertEquals(List.of(), simulation.frame().snapshot().motorFaults().left());
        }
    }

    @ParameterizedTest
    @EnumSource
    void thePathOfARobotWithAFaultyMotorIsMarked(MotorSide side) {
        try (Simulation simulation = run(ROBOT, 3, 3, breaking(1, side, new MotorFault.Weak(0.5)))) {
            runTo(simulation, 2);
            RobotPath path = simulation.frame().path();
            assertFalse(PathTag.isFaulty(path.tag(1)));
            assertTrue(PathTag.isFaulty(path.tag(path.size() - 1)));
        }
    }

    @Test
    void aWeakSideTurnsTheRobotUntilItIsRepaired() {
        MotorFault weak = new MotorFault.Weak(0.5);
        Simulation simulation = run(
                ROBOT,
                3,
                3,
                breaking(1, MotorSide.LEFT, weak),
                new TimedCommand(2, new Command.ClearMotorFault(MotorSide.LEFT, weak)));
        runTo(simulation, 1.5);
        assertEquals(0.15, simulation.wheelSpeeds().left(), 1e-12);
        assertEquals(0.3, simulation.wheelSpeeds().right(), 1e-12);
        assertEquals((0.3 - 0.15) / 0.18, simulation.velocity().angular(), 1e-12);
        runTo(simulation, 2.5);
        assertEquals(0.3, simulation.wheelSpeeds().left(), 1e-12);
    }

    @Test
    void faultsOfOneSideActInTheOrderInWhichTheyCame() {
        MotorFault weak = new MotorFault.Weak(0.5);
        MotorFault band = new MotorFault.DeadBand(1);
        Simulation weakFirst = run(ROBOT, 3, 3, breaking(0, MotorSide.RIGHT, weak), breaking(0, MotorSide.RIGHT, band));
        runTo(weakFirst, 1);
        assertEquals(0.1 * (0.5 * 3 - 1), weakFirst.wheelSpeeds().right(), 1e-12);
        Simulation bandFirst = run(ROBOT, 3, 3, breaking(0, MotorSide.RIGHT, band), breaking(0, MotorSide.RIGHT, weak));
        runTo(bandFirst, 1);
        assertEquals(0.1 * 0.5 * (3 - 1), bandFirst.wheelSpeeds().right(), 1e-12);
        assertEquals(List.of(band, weak), bandFirst.snapshot().motorFaults().right());
    }

    @Test
    void aFaultActsOnWhatTheSupplyGives() {
        Simulation simulation = run(ROBOT, 60, 6, breaking(0, MotorSide.LEFT, new MotorFault.Weak(0.5)));
        runTo(simulation, 1);
        assertEquals(0.3, simulation.wheelSpeeds().left(), 1e-12);
    }

    @Test
    void aDeadSideStopsWithTheMotorsTimeConstant() {
        Simulation simulation = run(
                RobotSpec.DEFAULT.withMotor(new MotorSpec(0.1, 0.1, 6)),
                3,
                3,
                breaking(2, MotorSide.LEFT, new MotorFault.NoDrive()));
        runTo(simulation, 2.1);
        assertEquals(
                0.3 * Math.exp(-(0.1 + 0.01) / 0.1), simulation.wheelSpeeds().left(), 0.3 * 0.02);
        runTo(simulation, 4);
        assertEquals(0, simulation.wheelSpeeds().left(), 1e-6);
        assertEquals(0.3, simulation.wheelSpeeds().right(), 1e-6);
    }

    @Test
    void clearingIsUndoneInTheOrderOfTheFaultsAndAnUnknownFaultIsRefused() {
        MotorFault weak = new MotorFault.Weak(0.5);
        MotorFault band = new MotorFault.DeadBand(1);
        Simulation simulation =
                run(ROBOT, 3, 3, breaking(0, MotorSide.RIGHT, weak), breaking(0, MotorSide.RIGHT, band));
        CommandResult refused = simulation.execute(new Command.ClearMotorFault(MotorSide.LEFT, weak));
        assertEquals(
                "the left motors have no such fault", refused.refusal().get().message());
        CommandResult.Executed cleared =
                (CommandResult.Executed) simulation.execute(new Command.ClearMotorFaults(MotorSide.RIGHT));
        assertEquals(MotorFaults.NONE, simulation.snapshot().motorFaults());
        cleared.inverse().forEach(simulation::execute);
        assertEquals(List.of(weak, band), simulation.snapshot().motorFaults().right());
    }

    @Test
    void aDriveDiffersFromWhatTheControllerBelievesAndItNeverSeesBy() {
        DriveScale scale = new DriveScale(1.04, 0.97, 1.03);
        List<RobotSpec> seen = new ArrayList<>();
        SimulationSetup setup = run(ROBOT.withDriveScale(scale), 0, 0).setup();
        Simulation simulation = new Simulation(
                setup,
                observation -> {
                    seen.add(observation.robot());
                    return new Decision(3, 3, Telemetry.ofState(ControllerState.of("DRIVE")));
                },
                ControllerMode.DIRECT,
                CommandListener.NONE);
        runTo(simulation, 1);
        assertEquals(0.3 * 1.04, simulation.wheelSpeeds().left(), 1e-12);
        assertEquals(0.3 * 0.97, simulation.wheelSpeeds().right(), 1e-12);
        double omega = 0.3 * (0.97 - 1.04) / (0.18 * 1.03);
        assertEquals(omega, simulation.velocity().angular(), 1e-12);
        // 100 ticks, at the first of which the controller has decided.
        assertEquals(omega * 1.0, simulation.pose().heading(), 1e-12);
        assertEquals(Set.of(ROBOT), new HashSet<>(seen));
        assertTrue(seen.stream().allMatch(robot -> robot == seen.get(1)), "the same instance at every tick");
    }
}
