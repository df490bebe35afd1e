package faultline.floorplan;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.Scenario;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;

/**
 * Makes a scenario from a floor plan: an enclosed world of the map's size, with the plan as one solid obstacle. If a
 * map is rotated by the {@code yaw} of its origin, the world has the size of its bounding box.
 */
public final class FloorPlanScenario {

    private static final String PLAN_ID = "plan";
    private static final double DURATION = 120;

    private FloorPlanScenario() {}

    /**
     * {@return the scenario, with the robot in the middle of the largest free disc} Only if the robot has no room in a
     * disc of known cells, the disc may contain unknown cells, which obstruct nothing.
     *
     * @param name the scenario's name
     * @param plan the floor plan
     * @throws FloorPlanException if there is no room for the robot
     */
    public static Scenario create(String name, FloorPlan plan) throws FloorPlanException {
        Scenario scenario = create(name, plan, middle(plan, false));
        if (!hasRoom(scenario)) {
            scenario = create(name, plan, middle(plan, true));
        }
        if (!hasRoom(scenario)) {
            SimulationSetup setup = scenario.setup();
            throw new FloorPlanException(
                    plan.description().image(),
                    FloorPlanProblem.NO_ROOM.with(
                            DecimalText.format(setup.robot().length()),
                            DecimalText.format(setup.robot().width()),
                            DecimalText.formatRounded(setup.world().width()),
                            DecimalText.formatRounded(setup.world().height())));
        }
        return scenario;
    }

    /** Returns the pose in the middle of the largest free disc. */
    private static Pose middle(FloorPlan plan, boolean unknownIsFree) {
        FreeDisc disc = FreeDisc.largest(plan.grid(), plan.solid(), unknownIsFree);
        double x = plan.description().metres(disc.column() + 0.5);
        double y = plan.description().metres(disc.row() + 0.5);
        Vector2 start = frame(plan).lowerLeft().toParent(new Vector2(x, y));
        return new Pose(MapFrame.round(start.x()), MapFrame.round(start.y()), 0);
    }

    private static MapFrame frame(FloorPlan plan) {
        return MapFrame.of(plan.description(), plan.grid().width(), plan.grid().height());
    }

    private static boolean hasRoom(Scenario scenario) {
        SimulationSetup setup = scenario.setup();
        return Clearance.findObstruction(setup.world(), setup.robot(), setup.start())
                .isEmpty();
    }

    /**
     * {@return the scenario with a given start}
     *
     * @param name the scenario's name
     * @param plan the floor plan
     * @param start the robot's pose in the world, metres from the lower left corner
     */
    public static Scenario create(String name, FloorPlan plan, Pose start) {
        MapFrame frame = frame(plan);
        List<Obstacle> obstacles = plan.rings().isEmpty()
                ? List.of()
                : List.of(new Obstacle(PLAN_ID, new ObstacleShape.PlanShape(rings(plan)), frame.lowerLeft()));
        WorldSpec world = new WorldSpec(frame.width(), frame.height(), true, WorldSpec.DEFAULT_MAX_MOVING, obstacles);
        SimulationSetup setup = SimulationSetup.of(world, start).withDuration(DURATION);
        String description = plan.grid().width() + " x " + plan.grid().height() + " cells of "
                + plan.description().resolution().stripTrailingZeros().toPlainString() + " m, "
                + plan.segmentCount() + " wall segments.";
        return new Scenario(name, description, false, setup, Expectation.NONE);
    }

    private static List<List<Vector2>> rings(FloorPlan plan) {
        MapDescription map = plan.description();
        List<List<Vector2>> rings = new ArrayList<>();
        for (GridRing ring : plan.rings()) {
            List<Vector2> points = new ArrayList<>();
            for (int i = 0; i < ring.size(); i++) {
                points.add(new Vector2(map.metres(ring.column(i)), map.metres(ring.row(i))));
            }
            rings.add(points);
        }
        return rings;
    }
}
