package faultline.floorplan;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.RigidMotion;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.scenario.Scenario;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.math.BigDecimal;
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
        double x = metres(plan, disc.column() + 0.5);
        double y = metres(plan, disc.row() + 0.5);
        Vector2 start = frame(plan).toParent(new Vector2(x, y));
        return new Pose(round(start.x()), round(start.y()), 0);
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
        Pose frame = frame(plan);
        List<Obstacle> obstacles = plan.rings().isEmpty()
                ? List.of()
                : List.of(new Obstacle(PLAN_ID, new ObstacleShape.PlanShape(rings(plan)), frame));
        Vector2 size = size(plan);
        WorldSpec world = new WorldSpec(size.x(), size.y(), true, WorldSpec.DEFAULT_MAX_MOVING, obstacles);
        SimulationSetup setup = SimulationSetup.of(world, start).withDuration(DURATION);
        String description = plan.grid().width() + " x " + plan.grid().height() + " cells of "
                + plan.description().resolution().stripTrailingZeros().toPlainString() + " m, "
                + plan.segmentCount() + " wall segments.";
        return new Scenario(name, description, false, setup, Expectation.NONE);
    }

    /** Coordinates are whole numbers of cells times the resolution, in decimals. */
    private static double metres(FloorPlan plan, double cells) {
        return plan.description()
                .resolution()
                .multiply(BigDecimal.valueOf(cells))
                .doubleValue();
    }

    private static double round(double metres) {
        return Math.rint(metres * 1e6) / 1e6;
    }

    private static List<List<Vector2>> rings(FloorPlan plan) {
        List<List<Vector2>> rings = new ArrayList<>();
        for (GridRing ring : plan.rings()) {
            List<Vector2> points = new ArrayList<>();
            for (int i = 0; i < ring.size(); i++) {
                points.add(new Vector2(metres(plan, ring.column(i)), metres(plan, ring.row(i))));
            }
            rings.add(points);
        }
        return rings;
    }

    /**
     * Returns the pose of the map's lower left corner: rotated by its yaw, and moved so that all of it is in the world.
     */
    private static Pose frame(FloorPlan plan) {
        double yaw = plan.description().yaw();
        if (yaw == 0) {
            return new Pose(0, 0, 0);
        }
        double minX = 0;
        double minY = 0;
        for (Vector2 corner : rotatedCorners(plan)) {
            minX = Math.min(minX, corner.x());
            minY = Math.min(minY, corner.y());
        }
        return new Pose(round(-minX), round(-minY), yaw);
    }

    private static Vector2 size(FloorPlan plan) {
        if (plan.description().yaw() == 0) {
            return new Vector2(
                    metres(plan, plan.grid().width()), metres(plan, plan.grid().height()));
        }
        Pose frame = frame(plan);
        double maxX = 0;
        double maxY = 0;
        for (Vector2 corner : rotatedCorners(plan)) {
            maxX = Math.max(maxX, corner.x() + frame.x());
            maxY = Math.max(maxY, corner.y() + frame.y());
        }
        return new Vector2(round(maxX + 1e-6), round(maxY + 1e-6));
    }

    private static List<Vector2> rotatedCorners(FloorPlan plan) {
        RigidMotion turn =
                RigidMotion.rotationAbout(Vector2.ZERO, plan.description().yaw());
        double w = metres(plan, plan.grid().width());
        double h = metres(plan, plan.grid().height());
        return List.of(
                turn.toParent(new Vector2(0, 0)),
                turn.toParent(new Vector2(w, 0)),
                turn.toParent(new Vector2(w, h)),
                turn.toParent(new Vector2(0, h)));
    }
}
