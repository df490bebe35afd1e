package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the start of runs whose first commands are executed before the robot moves. */
class FirstTickTest {

    private static final Obstacle BOX =
            new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.8), new Pose(2.5, 0.4, 0));
    private static final SimulationSetup ROOM = SimulationSetup.of(
                    new WorldSpec(5, 4, true, 3, List.of()), new Pose(1.5, 2, 0))
            .withDuration(120);
    private static final SimulationSetup ROOM_WITH_BOX =
            ROOM.withWorld(ROOM.world().withObstacles(List.of(BOX)));
    private static final ControllerSpec.WallFollowing NEAR = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.3);

    private static SimulationSetup with(SimulationSetup setup, SimulationSetup.TimedCommand... timeline) {
        return setup.withTimeline(Arrays.asList(timeline));
    }

    private static SimulationSetup.TimedCommand at(double time, Command command) {
        return new SimulationSetup.TimedCommand(time, command);
    }

    /** The sensors do not reach the box from the start, so the trajectories are the same. */
    @Test
    void aWallPutBeforeTheFirstTickIsAWallOfTheStart() {
        RunResult expected = HeadlessRun.run(ROOM_WITH_BOX, ControllerMode.DIRECT, List.of());
        for (double time : new double[] {0, 0.01}) {
            SimulationSetup put = with(ROOM, at(time, new Command.PlaceObstacle(BOX)));
            RunResult result = HeadlessRun.run(put, ControllerMode.DIRECT, List.of());
            assertEquals(expected.trajectoryHash(), result.trajectoryHash());
            assertEquals(expected.coverage(), result.coverage());
            assertEquals(expected.distanceRms(), result.distanceRms());
        }
    }

    @Test
    void runsInTheSameRoomShareTheirCircuit() {
        WallCircuits circuits = new WallCircuits();
        SimulationSetup near = ROOM_WITH_BOX.withController(NEAR);
        SimulationSetup edited =
                with(ROOM, at(0.01, new Command.ConfigureController(NEAR)), at(0, new Command.PlaceObstacle(BOX)));
        assertSame(circuits.forCarryOn(near), circuits.forCarryOn(edited));
    }

    @Test
    void laterCommandsAndFaultsAreNoPartOfTheStart() {
        SimulationSetup late = with(
                ROOM,
                at(0.011, new Command.PlaceObstacle(BOX)),
                at(0, new Command.InjectFault("left", new Fault.Dead())));
        assertSame(late, FirstTick.setup(late));
    }

    @Test
    void refusedCommandsAreNoPartOfTheStart() {
        SimulationSetup refused = with(ROOM, at(0, new Command.RemoveObstacle("box")));
        assertEquals(ROOM, FirstTick.setup(refused));
        SimulationSetup foreign = ROOM.withController(new ControllerSpec.Extern(0));
        assertEquals(foreign, FirstTick.setup(with(foreign, at(0, new Command.ConfigureController(NEAR)))));
    }

    /** In the order of the ticks, and within a tick in that of the timeline; commands from outside are the last. */
    @Test
    void commandsAreAppliedInTheOrderOfTheRun() {
        SimulationSetup edited = with(
                ROOM,
                at(0.01, new Command.RemoveObstacle("box")),
                at(0.008, new Command.SetPlatform(0.3, 0.2, 0.25)),
                at(0, new Command.PlaceObstacle(BOX)));
        SimulationSetup start = FirstTick.setup(edited);
        assertEquals(List.of(), start.world().obstacles());
        assertEquals(0.25, start.robot().speed());
        assertEquals(
                List.of(BOX),
                FirstTick.setup(edited, List.of(new Command.PlaceObstacle(BOX)))
                        .world()
                        .obstacles());
    }
}
