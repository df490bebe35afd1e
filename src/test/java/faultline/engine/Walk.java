package faultline.engine;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.robot.RobotSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * A wall follower's walk round a room, and what is wrong with it.
 *
 * @param result of the run
 * @param searches how often it searched for a wall
 * @param lap the time of a lap after the first, seconds; empty where none was finished
 * @param lapAllowed 1.4 times that of a perfect lap, seconds
 */
record Walk(RunResult result, int searches, OptionalDouble lap, double lapAllowed) {

    private static final double LEAST_COVERAGE = 0.97;
    private static final double MOST_ERROR = 0.005;
    private static final double LAP_FACTOR = 1.4;

    /** How a robot walks: the usual way, but for what is changed. */
    record Manner(RobotSpec robot, WallFollowing follower, double dt, double duration) {

        static final Manner USUAL = new Manner(RobotSpec.DEFAULT, WallFollowing.DEFAULT, 0.01, 240);

        Manner with(RobotSpec other) {
            return new Manner(other, follower, dt, duration);
        }

        Manner with(WallFollowing other) {
            return new Manner(robot, other, dt, duration);
        }

        Manner withTick(double seconds) {
            return new Manner(robot, follower, seconds, duration);
        }

        Manner lasting(double seconds) {
            return new Manner(robot, follower, dt, seconds);
        }

        Setup in(Room room) {
            return new Setup(room.world(), robot, room.start(), follower, List.of(), dt, 1, duration);
        }
    }

    static Walk round(Room room, Manner manner) {
        LapTimer timer = new LapTimer();
        StateCount searches = new StateCount("SEARCH");
        RunResult result = HeadlessRun.run(manner.in(room), ControllerMode.DIRECT, List.of(timer, searches));
        double offset = manner.follower().distance() + manner.robot().width() / 2;
        return new Walk(result, searches.count(), timer.lap(), LAP_FACTOR * room.lapTime(manner.robot(), offset));
    }

    /** What breaks the rules of following, a sentence each. */
    List<String> complaints() {
        List<String> complaints = dangers();
        complain(complaints, result.distanceRms().orElse(0) > MOST_ERROR, "distance error of %.1f mm RMS", 1000 * result.distanceRms().orElse(0));
        complain(complaints, searches > 1, "%.0f searches", searches);
        complain(complaints, lap.isEmpty(), "no lap in %.0f s", result.simulatedSeconds());
        complain(complaints, lap.orElse(0) > lapAllowed, "a lap of %.1f s", lap.orElse(0));
        return complaints;
    }

    /** What breaks the rules that hold for bad sensors as well. */
    List<String> dangers() {
        List<String> complaints = new ArrayList<>();
        result.collision().ifPresent(contact -> complain(complaints, true, "contact at %.2f s", contact.time()));
        complain(complaints, result.coverage().orElse(0) < LEAST_COVERAGE, "coverage of %.3f", result.coverage().orElse(0));
        return complaints;
    }

    private static void complain(List<String> complaints, boolean wrong, String sentence, double number) {
        if (wrong) {
            complaints.add(String.format(Locale.ROOT, sentence, number));
        }
    }

    /** Counts how often a controller comes into a state. */
    private static final class StateCount implements TickObserver {

        private final String state;
        private boolean inside;
        private int count;

        StateCount(String state) {
            this.state = state;
        }

        @Override
        public void observe(Simulation simulation) {
            boolean now = simulation.telemetry().state().equals(state);
            count += now && !inside ? 1 : 0;
            inside = now;
        }

        int count() {
            return count;
        }
    }
}
