package faultline.scenario;

import faultline.control.FollowerState;
import faultline.control.SensorFinding;
import faultline.control.SensorHealth;
import faultline.control.SensorTrust;
import faultline.engine.metrics.RunResult;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.MotorFaults;
import faultline.robot.RobotSpec;
import faultline.robot.WheelSpeeds;
import faultline.world.Collision;
import faultline.world.Snapshot;
import java.util.List;
import java.util.Map;

/** Results of runs whose values differ from each other. */
final class SampleResults {

    private SampleResults() {}

    /** Returns a result with all values, and with a suspicion that is no change of trust. */
    static RunResult eventful() {
        SensorHealth off = new SensorHealth("left", SensorTrust.DISTRUSTED, SensorFinding.OFF, 1, 50);
        SensorHealth suspect = new SensorHealth("rear", SensorTrust.SUSPECTED, SensorFinding.OFF, 1, 60);
        List<RunEvent> events = List.of(
                new RunEvent.HealthChanged(50, 0.5, SensorTrust.TRUSTED, off),
                new RunEvent.HealthChanged(60, 0.6, SensorTrust.TRUSTED, suspect),
                new RunEvent.RungChanged(75, 0.75, "ALL", "THREE"),
                new RunEvent.HealthChanged(200, 2, SensorTrust.DISTRUSTED, SensorHealth.trusted("left")));
        Collision collision =
                new Collision(new Vector2(1.5, 0.25), 2.25, 225, "pole", Map.of(), List.of(), MotorFaults.NONE);
        return new RunResult(
                250,
                2.5,
                12.25,
                FollowerState.FOLLOW,
                List.of(FollowerState.SEARCH, FollowerState.FOLLOW),
                0.75,
                false,
                0.003,
                0.0045,
                255,
                7,
                List.of(),
                "THREE",
                events,
                snapshot(List.of(collision)));
    }

    /** Returns the result of a run without a tick, in which nothing could be measured. */
    static RunResult uneventful() {
        return new RunResult(
                0,
                0,
                Double.NaN,
                FollowerState.SEARCH,
                List.of(FollowerState.SEARCH),
                Double.NaN,
                false,
                Double.NaN,
                Double.NaN,
                1,
                1,
                List.of(),
                "",
                List.of(),
                snapshot(List.of()));
    }

    private static Snapshot snapshot(List<Collision> collisions) {
        return new Snapshot(
                0,
                0,
                6,
                4,
                true,
                RobotSpec.DEFAULT,
                Pose.ORIGIN,
                new WheelSpeeds(0, 0),
                MotorFaults.NONE,
                List.of(),
                List.of(),
                List.of(),
                collisions);
    }
}
