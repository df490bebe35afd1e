package faultline.engine.metrics;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.FollowerState;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.TickObserver;
import faultline.engine.recording.RunEvent;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * A run of a wall follower in a room, and the defects of that run.
 *
 * @param result of the run
 * @param searchCount how often it searched for a wall
 * @param lapTime the time of a lap after the first, seconds; empty where none was finished
 * @param maxLapTime 1.4 times that of a perfect lap, seconds
 */
record WallFollowingRun(RunResult result, int searchCount, OptionalDouble lapTime, double maxLapTime) {

    private static final double MIN_COVERAGE = 0.97;
    private static final double MAX_RMS_ERROR = 0.005;
    private static final double LAP_FACTOR = 1.4;

    /** The conditions of a run. */
    record Conditions(RobotSpec robot, WallFollowing follower, double dt, double duration) {

        static final Conditions DEFAULT = new Conditions(RobotSpec.DEFAULT, WallFollowing.DEFAULT, 0.01, 240);

        Conditions with(RobotSpec other) {
            return new Conditions(other, follower, dt, duration);
        }

        Conditions with(WallFollowing other) {
            return new Conditions(robot, other, dt, duration);
        }

        Conditions withTick(double seconds) {
            return new Conditions(robot, follower, seconds, duration);
        }

        Conditions withDuration(double seconds) {
            return new Conditions(robot, follower, dt, seconds);
        }

        SimulationSetup setupFor(PolygonRoom room) {
            return SimulationSetup.of(room.world(), room.start())
                    .withRobot(robot)
                    .withController(follower)
                    .withTick(dt)
                    .withDuration(duration);
        }
    }

    static WallFollowingRun simulate(PolygonRoom room, Conditions manner) {
        LapTimer timer = new LapTimer();
        StateEntryCounter searches = new StateEntryCounter(FollowerState.SEARCH);
        RunResult result = HeadlessRun.run(manner.setupFor(room), ControllerMode.DIRECT, List.of(timer, searches));
        double offset = manner.follower().distance() + manner.robot().width() / 2;
        return new WallFollowingRun(
                result, searches.count(), timer.lapTime(), LAP_FACTOR * room.lapTime(manner.robot(), offset));
    }

    /** What breaks the rules of following, a sentence each. */
    List<String> violations() {
        return violations(1, MAX_RMS_ERROR);
    }

    /** What breaks the rules of a run in which the diagnosis took a sensor for faulty: both limits are doubled. */
    List<String> violationsWithFalseAlarm() {
        return violations(2, 2 * MAX_RMS_ERROR);
    }

    /** Whether the controller temporarily used fewer sensors than there are. */
    boolean leftFirstRung() {
        return result.diagnosisEvents().stream().anyMatch(RunEvent.RungChanged.class::isInstance);
    }

    private List<String> violations(int maxSearches, double maxRmsError) {
        List<String> problems = safetyViolations();
        addViolation(
                problems,
                result.distanceRms().orElse(0) > maxRmsError,
                "distance error of %.1f mm RMS",
                1000 * result.distanceRms().orElse(0));
        addViolation(problems, searchCount > maxSearches, "%.0f searches", searchCount);
        addViolation(problems, lapTime.isEmpty(), "no lap in %.0f s", result.simulatedSeconds());
        addViolation(problems, lapTime.orElse(0) > maxLapTime, "a lap of %.1f s", lapTime.orElse(0));
        return problems;
    }

    /** What breaks the rules that hold for bad sensors as well. */
    List<String> safetyViolations() {
        List<String> problems = new ArrayList<>();
        result.collision().ifPresent(contact -> addViolation(problems, true, "contact at %.2f s", contact.time()));
        addViolation(
                problems,
                result.coverage().orElse(0) < MIN_COVERAGE,
                "coverage of %.3f",
                result.coverage().orElse(0));
        return problems;
    }

    private static void addViolation(List<String> problems, boolean wrong, String sentence, double number) {
        if (wrong) {
            problems.add(String.format(Locale.ROOT, sentence, number));
        }
    }

    /** Counts how often a controller comes into a state. */
    private static final class StateEntryCounter implements TickObserver {

        private final FollowerState state;
        private boolean inside;
        private int count;

        StateEntryCounter(FollowerState state) {
            this.state = state;
        }

        @Override
        public void observe(Simulation simulation) {
            boolean now = simulation.telemetry().state() == state;
            count += now && !inside ? 1 : 0;
            inside = now;
        }

        int count() {
            return count;
        }
    }
}
