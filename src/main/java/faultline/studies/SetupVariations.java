package faultline.studies;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.List;

/** What a study varies of the scenario file that it starts from. */
final class SetupVariations {

    private SetupVariations() {}

    /** The same with another robot. */
    static SimulationSetup with(SimulationSetup base, RobotSpec robot) {
        return new SimulationSetup(
                base.world(),
                robot,
                base.start(),
                base.controller(),
                base.timeline(),
                base.dt(),
                base.seed(),
                base.duration());
    }

    /** The same with another controller. */
    static SimulationSetup with(SimulationSetup base, ControllerSpec controller) {
        return new SimulationSetup(
                base.world(),
                base.robot(),
                base.start(),
                controller,
                base.timeline(),
                base.dt(),
                base.seed(),
                base.duration());
    }

    /** The same with other things done to it. */
    static SimulationSetup with(SimulationSetup base, List<SimulationSetup.TimedCommand> timeline) {
        return new SimulationSetup(
                base.world(),
                base.robot(),
                base.start(),
                base.controller(),
                timeline,
                base.dt(),
                base.seed(),
                base.duration());
    }

    /** The same with an obstacle in the place of the one that has its id. */
    static SimulationSetup with(SimulationSetup base, Obstacle changed) {
        WorldSpec world = base.world();
        List<Obstacle> obstacles = world.obstacles().stream()
                .map(obstacle -> obstacle.id().equals(changed.id()) ? changed : obstacle)
                .toList();
        return new SimulationSetup(
                new WorldSpec(world.width(), world.height(), world.enclosed(), world.maxMoving(), obstacles),
                base.robot(),
                base.start(),
                base.controller(),
                base.timeline(),
                base.dt(),
                base.seed(),
                base.duration());
    }

    /** An obstacle of a file. */
    static Obstacle findObstacle(SimulationSetup base, String id) {
        return base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .orElseThrow();
    }
}
