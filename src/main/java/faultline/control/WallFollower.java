package faultline.control;

/** The six-state wall follower. */
final class WallFollower implements Controller {

    WallFollower(ControllerSpec.WallFollowing spec) {
    }

    @Override
    public Decision decide(Observation observation) {
        return new Decision(0, 0, Telemetry.named("SEARCH"));
    }
}
