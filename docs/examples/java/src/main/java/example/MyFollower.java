package example;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.Velocity;
import java.util.Map;

/** A first wall follower: searches for a wall, and keeps it on its left. */
public final class MyFollower implements ControllerProvider {

    @Override
    public String name() {
        return "my-follower";
    }

    @Override
    public Controller create(Map<String, String> settings) {
        return new Follower(Double.parseDouble(settings.getOrDefault("distance", "0.25")));
    }

    private static final class Follower implements Controller {

        private final double distance;
        private boolean besideWall;

        Follower(double distance) {
            this.distance = distance;
        }

        @Override
        public Decision decide(Observation sight) {
            double ahead = Math.min(sight.distance("front", 9), sight.distance("front-left", 9) + 0.05);
            if (ahead < distance + 0.05) {
                besideWall = true;
                return Decision.ofVelocity(sight.robot(), new Velocity(0, -1), "TURN", "wall ahead");
            }
            if (!besideWall) {
                return Decision.ofVelocity(sight.robot(), new Velocity(0.3, 0), "SEARCH", "");
            }
            double error = sight.distance("left", distance + 0.2) - distance;
            double omega = Math.max(-1, Math.min(0.7, 5 * error));
            return Decision.ofVelocity(sight.robot(), new Velocity(0.2, omega), "FOLLOW", "beside a wall");
        }
    }
}
