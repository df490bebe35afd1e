package faultline.studies;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.engine.SimulationSetup;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Obstacle;
import java.util.function.UnaryOperator;

/** Varies the setup of a scenario. */
final class SetupVariations {

    private SetupVariations() {}

    /** Returns a setup with an obstacle instead of the one with the same id. */
    static SimulationSetup with(SimulationSetup base, Obstacle changed) {
        return base.withWorld(base.world()
                .withObstacles(base.world().obstacles().stream()
                        .map(obstacle -> obstacle.id().equals(changed.id()) ? changed : obstacle)
                        .toList()));
    }

    /** Returns a setup whose wall follower does not diagnose its sensors, as in the paper. */
    static SimulationSetup withoutDiagnosis(SimulationSetup base) {
        WallFollowing spec = (WallFollowing) base.controller();
        return base.withController(spec.withDiagnosis(false));
    }

    /** Returns a setup with the same noise on all sensors, standard deviation in metres. */
    static SimulationSetup withNoise(SimulationSetup base, double deviation) {
        return base.withRobot(withNoise(base.robot(), deviation));
    }

    /** Returns a robot with the same noise on all sensors, standard deviation in metres. */
    static RobotSpec withNoise(RobotSpec base, double deviation) {
        return withSensors(base, sensor -> sensor.withNoise(deviation));
    }

    static RobotSpec withSensors(RobotSpec base, UnaryOperator<SensorSpec> change) {
        return base.withSensors(base.sensors().stream().map(change).toList());
    }

    /** Returns the obstacle with an id. */
    static Obstacle findObstacle(SimulationSetup base, String id) {
        return base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .orElseThrow();
    }
}
