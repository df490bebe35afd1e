package faultline.control.ladder;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.SensorHealth;
import faultline.control.Successor;
import faultline.control.Telemetry;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.control.fallback.MapFollower;
import faultline.control.wallfollower.WallFollower;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Reading;
import java.util.List;

/**
 * A wall follower that tolerates faults. A diagnosis checks all sensors, and the strategy of the highest {@link Rung}
 * whose requirements the trusted sensors meet drives. As long as all are trusted, its decisions are exactly those of
 * the six-state follower.
 */
public final class FaultTolerantFollower implements Successor {

    /** The state in which the robot has stopped because it cannot go on. */
    public static final ControllerState STOP = ControllerState.of("STOP");

    private ControllerSpec.WallFollowing spec;
    private final SensorDiagnosis diagnosis;
    private final MapFollower mapFollower;
    private WallFollower sixStates;
    private final AlignmentMonitor alignments = new AlignmentMonitor();
    private Rung rung = Rung.ALL;
    private Decision last = new Decision(0, 0, Telemetry.ofState(FollowerState.SEARCH));
    private long lastTick;
    /** The trusted sensors with which the map follower made no progress; it is not tried again with the same ones. */
    private int stuckWith;
    /** The trusted sensors at the last decision of the map follower. */
    private int mapSensors;

    private StopReason stopReason = StopReason.NO_SENSOR;
    private Rung reportedRung;
    private List<SensorHealth> reportedHealth = List.of();
    private Telemetry.Diagnosis reportedVerdict = Telemetry.Diagnosis.NONE;

    /**
     * Creates a follower that trusts all sensors.
     *
     * @param spec its settings
     */
    public FaultTolerantFollower(ControllerSpec.WallFollowing spec) {
        this.spec = spec;
        this.diagnosis = new SensorDiagnosis(spec.side());
        setWantedDistance();
        this.mapFollower = new MapFollower(diagnosis, spec);
        this.sixStates = new WallFollower(spec, diagnosis.reckoning().odometer());
    }

    @Override
    public void begin(long tick, WheelSpeeds wheels) {
        lastTick = tick;
        diagnosis.reckoning().odometer().setWheels(spec.side().nearAndFar(wheels));
    }

    @Override
    public Decision decide(Observation observation) {
        long ticks = observation.tick() - lastTick;
        diagnosis.update(observation, last.nearVolts(spec.side()), last.farVolts(spec.side()), ticks);
        lastTick = observation.tick();
        switchRung();
        last = shown(drive(observation, ticks * observation.dt()));
        return last;
    }

    @Override
    public void configure(ControllerSpec.BuiltIn settings) {
        spec = spec.changedTo(settings);
        setWantedDistance();
        mapFollower.configure(spec);
        sixStates.configure(spec);
    }

    private void setWantedDistance() {
        ControllerSpec.WallFollowing wanted = spec;
        diagnosis.setWantedDistance(wanted.distance(), robot -> WallFollower.wantedCentreDistance(wanted, robot));
    }

    private void switchRung() {
        if (rung == Rung.ALL && diagnosis.allTrusted()) {
            return;
        }
        Rung.Strategy before = rung.strategy();
        if (before == Rung.Strategy.STOP) {
            diagnosis.trustAnswering();
        }
        boolean wasStuck = before == Rung.Strategy.MAP && mapFollower.isStuck();
        if (wasStuck) {
            stuckWith = mapSensors;
        }
        rung = Rung.of(diagnosis);
        stopReason = StopReason.NO_SENSOR;
        if (rung.strategy() == Rung.Strategy.MAP) {
            boolean stuck = stuckWith == diagnosis.trusted();
            stopReason = stuck ? StopReason.NO_PROGRESS : StopReason.TOO_FAR;
            rung = stuck || !diagnosis.reach().holdsWanted() ? Rung.STOP : rung;
        }
        if (wasStuck || rung.strategy() != before) {
            if (rung.strategy() == Rung.Strategy.MAP) {
                mapFollower.begin(last.telemetry().state() != FollowerState.SEARCH);
            } else if (rung.strategy() == Rung.Strategy.SIX_STATES) {
                sixStates = new WallFollower(spec, diagnosis.reckoning().odometer());
                alignments.reset();
            }
        }
    }

    private Decision drive(Observation observation, double dt) {
        return switch (rung.strategy()) {
            case SIX_STATES -> watched(sixStates.decide(masked(observation), verdict()));
            case MAP -> {
                mapSensors = diagnosis.trusted();
                mapFollower.decide(observation.robot(), dt);
                yield decision(
                        observation.robot(), mapFollower.velocity(), mapFollower.state(), mapFollower.wallControl());
            }
            case STOP -> decision(observation.robot(), Velocity.ZERO, STOP, Telemetry.WallControl.NONE);
        };
    }

    /** Counts an alignment; after too many, the sensor that the six states use for steering is no longer trusted. */
    private Decision watched(Decision decision) {
        boolean aligned = decision.telemetry().state() == FollowerState.FOLLOW
                && last.telemetry().state() == FollowerState.ALIGN;
        if (aligned
                && alignments.isRepeated(
                        diagnosis.reckoning().distance(), diagnosis.reckoning().heading())) {
            Rung.facingWall(diagnosis).ifPresent(diagnosis::distrustMisleading);
            alignments.reset();
        }
        return decision;
    }

    /** Returns a decision with its telemetry completed: transitions are counted and dated across all rungs. */
    private Decision shown(Decision decision) {
        Telemetry now = decision.telemetry();
        Telemetry before = last.telemetry();
        boolean changed = !now.state().equals(before.state());
        int transitions = before.transitions() + (changed ? 1 : 0);
        long sinceTick = changed ? lastTick : before.sinceTick();
        if (now.transitions() == transitions && now.sinceTick() == sinceTick && now.diagnosis() == verdict()) {
            return decision;
        }
        Telemetry telemetry = new Telemetry(
                now.state(),
                rung == Rung.STOP ? stopReason.condition() : now.condition(),
                sinceTick,
                transitions,
                now.wall(),
                now.edges(),
                verdict());
        return new Decision(decision.leftVolts(), decision.rightVolts(), telemetry);
    }

    /** Returns the result of the diagnosis, the same instance as long as nothing has changed. */
    private Telemetry.Diagnosis verdict() {
        if (reportedRung != rung || reportedHealth != diagnosis.health()) {
            reportedRung = rung;
            reportedHealth = diagnosis.health();
            reportedVerdict = new Telemetry.Diagnosis(rung.name(), reportedHealth);
        }
        return reportedVerdict;
    }

    /** Returns the observation in which sensors that are not trusted are off. */
    private Observation masked(Observation observation) {
        if (rung == Rung.ALL) {
            return observation;
        }
        double[] kept = observation.readings().clone();
        for (int i = 0; i < kept.length; i++) {
            if (!diagnosis.isTrusted(i)) {
                kept[i] = Reading.OFF;
            }
        }
        return new Observation(observation.tick(), observation.dt(), observation.robot(), kept);
    }

    private Decision decision(RobotSpec robot, Velocity velocity, ControllerState state, Telemetry.WallControl wall) {
        Telemetry telemetry = new Telemetry(state, "", 0, 0, wall, Telemetry.EdgeTimes.NONE, Telemetry.Diagnosis.NONE);
        return Decision.ofVelocity(robot, spec.side(), velocity, telemetry);
    }
}
