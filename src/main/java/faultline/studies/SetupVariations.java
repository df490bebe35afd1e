package faultline.studies;

import faultline.engine.SimulationSetup;
import faultline.world.Obstacle;

/** Varies the setup of a scenario. */
final class SetupVariations {

    private SetupVariations() {}

    /** Returns a setup with an obstacle in place of the one with the same id. */
    static SimulationSetup with(SimulationSetup base, Obstacle changed) {
        return base.withWorld(base.world()
                .withObstacles(base.world().obstacles().stream()
                        .map(obstacle -> obstacle.id().equals(changed.id()) ? changed : obstacle)
                        .toList()));
    }

    /** Returns the obstacle with an id. */
    static Obstacle findObstacle(SimulationSetup base, String id) {
        return base.world().obstacles().stream()
                .filter(obstacle -> obstacle.id().equals(id))
                .findFirst()
                .orElseThrow();
    }
}
