package faultline.studies;

import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.engine.metrics.RunResult;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** A run with its poses and states at each tick from tick 0 on. */
record RunTrace(SimulationSetup setup, List<Pose> poses, List<ControllerState> states, RunResult result) {

    static RunTrace simulate(SimulationSetup setup) {
        List<Pose> poses = new ArrayList<>();
        List<ControllerState> states = new ArrayList<>();
        RunResult result = HeadlessRun.run(setup, ControllerMode.DIRECT, List.of((Simulation simulation) -> {
            poses.add(simulation.pose());
            states.add(simulation.telemetry().state());
        }));
        return new RunTrace(setup, poses, states, result);
    }

    List<Vector2> path() {
        return poses.stream().map(Pose::position).toList();
    }

    /** Returns the ticks of the transitions from ALIGN to FOLLOW. */
    List<Integer> handOvers() {
        return IntStream.range(1, states.size())
                .filter(tick -> states.get(tick) == FollowerState.FOLLOW && states.get(tick - 1) == FollowerState.ALIGN)
                .boxed()
                .toList();
    }

    Pose lastPose() {
        return poses.get(poses.size() - 1);
    }
}
