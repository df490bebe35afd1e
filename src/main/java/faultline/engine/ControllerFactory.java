package faultline.engine;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.PeriodicController;
import faultline.control.Telemetry;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.WallFollower;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Makes controllers from their specifications. */
public final class ControllerFactory {

    private ControllerFactory() {}

    /** Returns a new controller in its initial state. */
    public static Controller create(ControllerSpec spec) {
        if (spec instanceof ControllerSpec.WallFollowing wall) {
            Controller follower = wall.diagnosis() ? new FaultTolerantFollower(wall) : new WallFollower(wall);
            return new PeriodicController(follower, wall.period());
        }
        Telemetry telemetry = Telemetry.ofState(initialState(spec));
        Decision constant = spec instanceof ControllerSpec.Drive drive
                ? new Decision(drive.leftVolts(), drive.rightVolts(), telemetry)
                : new Decision(0, 0, telemetry);
        return observation -> constant;
    }

    /** Returns all states of a controller, the initial state first. */
    public static List<ControllerState> states(ControllerSpec spec) {
        if (spec instanceof ControllerSpec.WallFollowing wall) {
            Stream<ControllerState> stop = wall.diagnosis() ? Stream.of(FaultTolerantFollower.STOP) : Stream.empty();
            return Stream.concat(Arrays.stream(FollowerState.values()), stop).toList();
        }
        return List.of(ControllerState.of(spec instanceof ControllerSpec.Drive ? "DRIVE" : "NONE"));
    }

    /** Returns the state that a controller starts in. */
    public static ControllerState initialState(ControllerSpec spec) {
        return states(spec).get(0);
    }
}
