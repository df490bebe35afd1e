package faultline.app.figures;

import faultline.control.ControllerSpec;
import faultline.engine.Setup;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.List;

/** What a study varies of the scenario file that it starts from. */
final class Variation {

    private Variation() {
    }

    /** The same with another robot. */
    static Setup of(Setup base, RobotSpec robot) {
        return new Setup(base.world(), robot, base.start(), base.controller(), base.timeline(), base.dt(), base.seed(), base.duration());
    }

    /** The same with another controller. */
    static Setup of(Setup base, ControllerSpec controller) {
        return new Setup(base.world(), base.robot(), base.start(), controller, base.timeline(), base.dt(), base.seed(), base.duration());
    }

    /** The same with other things done to it. */
    static Setup of(Setup base, List<Setup.Timed> timeline) {
        return new Setup(base.world(), base.robot(), base.start(), base.controller(), timeline, base.dt(), base.seed(), base.duration());
    }

    /** The same with an obstacle in the place of the one that has its id. */
    static Setup of(Setup base, Obstacle changed) {
        WorldSpec world = base.world();
        List<Obstacle> obstacles = world.obstacles().stream().map(obstacle -> obstacle.id().equals(changed.id()) ? changed : obstacle).toList();
        return new Setup(new WorldSpec(world.width(), world.height(), world.enclosed(), world.maxMoving(), obstacles), base.robot(),
                base.start(), base.controller(),
                base.timeline(), base.dt(), base.seed(), base.duration());
    }

    /** An obstacle of a file. */
    static Obstacle obstacle(Setup base, String id) {
        return base.world().obstacles().stream().filter(obstacle -> obstacle.id().equals(id)).findFirst().orElseThrow();
    }
}
