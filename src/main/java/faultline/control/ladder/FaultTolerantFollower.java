package faultline.control.ladder;

import faultline.control.Controller;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.control.fallback.MapFollower;
import faultline.control.wallfollower.WallFollower;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;

/**
 * The wall follower that carries on: a diagnosis watches all sensors, and a ladder of strategies goes from the
 * six-state follower, which needs the sensors that face the wall and ahead, to one that follows by the local map, to a
 * safe stop.
 */
public final class FaultTolerantFollower implements Controller {

    private final ControllerSpec.WallFollowing spec;
    private final SensorDiagnosis diagnosis;
    private final MapFollower fallback;
    private WallFollower follower;
    private Decision last = new Decision(0, 0, Telemetry.ofState("SEARCH"));
    private long lastTick;
    private boolean onMap;
    private boolean stopped;

    public FaultTolerantFollower(ControllerSpec.WallFollowing spec) {
        this.spec = spec;
        this.diagnosis = new SensorDiagnosis(spec.side() == WallSide.LEFT ? 1 : -1);
        this.fallback = new MapFollower(diagnosis, spec.distance());
        this.follower = new WallFollower(spec);
    }

    public SensorDiagnosis diagnosis() {
        return diagnosis;
    }

    public boolean isStopped() {
        return stopped;
    }

    @Override
    public Decision decide(Observation observation) {
        boolean left = spec.side() == WallSide.LEFT;
        long ticks = observation.tick() - lastTick;
        diagnosis.update(
                observation,
                left ? last.leftVolts() : last.rightVolts(),
                left ? last.rightVolts() : last.leftVolts(),
                ticks);
        lastTick = observation.tick();
        last = choose(observation, ticks * observation.dt());
        return last;
    }

    private Decision choose(Observation observation, double dt) {
        if (!serves(QUARTER, SIDEWAYS)) {
            stopped = true;
            return new Decision(0, 0, Telemetry.ofState("STOP"));
        }
        stopped = false;
        if (serves(QUARTER, TOLERANCE) && serves(0, TOLERANCE)) {
            if (onMap) {
                onMap = false;
                follower = new WallFollower(spec);
            }
            return follower.decide(masked(observation));
        }
        if (!onMap) {
            onMap = true;
            fallback.begin();
        }
        fallback.decide(observation.robot(), dt);
        return onMap(observation.robot());
    }

    private static final double QUARTER = StrictMath.PI / 2;
    private static final double TOLERANCE = StrictMath.toRadians(20);
    private static final double SIDEWAYS = StrictMath.toRadians(50);

    /** Whether a trusted sensor looks within some angle of a bearing. */
    private boolean serves(double bearing, double within) {
        for (int rest = diagnosis.trusted(); rest != 0; rest &= rest - 1) {
            if (Math.abs(diagnosis.cone(Integer.numberOfTrailingZeros(rest)).bearing() - bearing) < within) {
                return true;
            }
        }
        return false;
    }

    private Observation masked(Observation observation) {
        double[] readings = observation.readings();
        if (diagnosis.trusted() == (1 << readings.length) - 1) {
            return observation;
        }
        double[] kept = readings.clone();
        for (int i = 0; i < kept.length; i++) {
            if (!diagnosis.isTrusted(i)) {
                kept[i] = Reading.OFF;
            }
        }
        return new Observation(observation.tick(), observation.dt(), observation.robot(), kept);
    }

    private Decision onMap(RobotSpec robot) {
        MotorSpec motor = robot.motor();
        double half = fallback.omega() * robot.track() / 2;
        double near = motor.voltageFor(fallback.v() - half);
        double far = motor.voltageFor(fallback.v() + half);
        Telemetry telemetry = Telemetry.ofState(fallback.state());
        return spec.side() == WallSide.LEFT ? new Decision(near, far, telemetry) : new Decision(far, near, telemetry);
    }
}
