package faultline.gui.properties;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;

/** The templates of new scenarios. */
enum ScenarioTemplate {
    /** A room without obstacles. */
    EMPTY_ROOM(5, 4, true, new Pose(2.5, 2, 0)),
    /** A room with furniture along its walls and a table in its middle. */
    FURNISHED_ROOM(
            6,
            5,
            true,
            new Pose(1, 1, 0),
            new Obstacle("cabinet", new ObstacleShape.RectangleShape(1.6, 0.5), new Pose(1.4, 4.74, 0)),
            new Obstacle("desk", new ObstacleShape.RectangleShape(0.8, 1.6), new Pose(5.59, 2.4, 0)),
            new Obstacle("table", new ObstacleShape.CircleShape(0.5), new Pose(2.6, 2.4, 0))),
    /** A long corridor. */
    CORRIDOR(12, 1.8, true, new Pose(1, 0.9, 0)),
    /** A square room with a pillar, whose outer corners must be rounded. */
    PILLAR(
            6,
            6,
            true,
            new Pose(1.2, 3, 0),
            new Obstacle("pillar", new ObstacleShape.RectangleShape(1.2, 1.2), new Pose(3, 3, 0))),
    /** A building in the open. */
    OPEN_GROUND(
            10,
            8,
            false,
            new Pose(1.5, 4, 0),
            new Obstacle("building", new ObstacleShape.RectangleShape(4, 3), new Pose(5, 4, 0)));

    private final WorldSpec world;
    private final Pose start;

    ScenarioTemplate(double width, double height, boolean enclosed, Pose start, Obstacle... obstacles) {
        this.world = new WorldSpec(width, height, enclosed, WorldSpec.DEFAULT_MAX_MOVING, List.of(obstacles));
        this.start = start;
    }

    /** Returns a scenario with the standard robot, which is expected not to collide. */
    Scenario create() {
        return new Scenario(
                Messages.get("template." + name()),
                "",
                false,
                SimulationSetup.of(world, start),
                new Expectation(List.of(new Expectation.Collides(false))));
    }
}
