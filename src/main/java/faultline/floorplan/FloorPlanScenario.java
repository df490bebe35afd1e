package faultline.floorplan;

import faultline.engine.SimulationSetup;
import faultline.engine.metrics.Expectation;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.io.DecimalText;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.world.Clearance;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Makes a scenario from a floor plan: an enclosed world of the map's size, with the plan as one solid obstacle. If a
 * map is rotated by the {@code yaw} of its origin, the world has the size of its bounding box.
 */
public final class FloorPlanScenario {

    private static final String PLAN_ID = "plan";
    private static final double DURATION = 120;

    private FloorPlanScenario() {}

    /**
     * {@return the name of the scenario of a map: that of its file without the extension}
     *
     * @param file the map or image
     */
    public static String nameFor(Path file) {
        return file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    }

    /**
     * {@return the scenario, with the robot in the middle of a large free disc} The disc about the middle of a cell is
     * taken, unless the robot cannot turn there or has no room at all; then that about a corner of cells. Only if the
     * robot has no room in a disc of known cells, the disc may contain unknown cells, which obstruct nothing.
     *
     * @param name the scenario's name
     * @param plan the floor plan
     * @param settings the settings that may help if there is no room, for the sentence of the exception
     * @throws FloorPlanException if there is no room for the robot
     */
    public static Scenario create(String name, FloorPlan plan, String settings) throws FloorPlanException {
        Optional<Scenario> scenario = create(name, plan, false).or(() -> create(name, plan, true));
        if (scenario.isPresent()) {
            return scenario.get();
        }
        RobotSpec robot = RobotSpec.DEFAULT;
        BigDecimal cell = plan.description().resolution();
        throw new FloorPlanException(
                plan.description().image(),
                FloorPlanProblem.NO_ROOM.with(
                        DecimalText.format(robot.length()),
                        DecimalText.format(robot.width()),
                        metres(plan.grid().width(), cell),
                        metres(plan.grid().height(), cell),
                        settings));
    }

    private static String metres(int cells, BigDecimal cell) {
        return DecimalText.formatRounded(cell.doubleValue() * cells);
    }

    private static Optional<Scenario> create(String name, FloorPlan plan, boolean unknownIsFree) {
        Optional<Scenario> first = create(name, plan, FreeDisc.aboutCell(plan.grid(), plan.solid(), unknownIsFree));
        if (first.filter(FloorPlanScenario::canTurn).isPresent()) {
            return first;
        }
        Optional<Scenario> second = create(name, plan, FreeDisc.aboutCorner(plan.grid(), plan.solid(), unknownIsFree));
        return second.filter(FloorPlanScenario::canTurn).or(() -> Stream.concat(first.stream(), second.stream())
                .filter(scenario -> hasRoom(scenario, scenario.setup().robot()))
                .findFirst());
    }

    /** Returns the scenario with the start in the middle of a disc, unless that is empty. */
    private static Optional<Scenario> create(String name, FloorPlan plan, FreeDisc disc) {
        if (disc.clearance() == 0) {
            return Optional.empty();
        }
        double x = plan.description().metres(disc.x());
        double y = plan.description().metres(disc.y());
        Vector2 start = frame(plan).lowerLeft().toParent(new Vector2(x, y));
        return Optional.of(create(name, plan, new Pose(MapFrame.round(start.x()), MapFrame.round(start.y()), 0)));
    }

    /** Returns whether the square about the circle in which the robot turns is free. */
    private static boolean canTurn(Scenario scenario) {
        RobotSpec robot = scenario.setup().robot();
        double side = Math.hypot(robot.length(), robot.width());
        return hasRoom(scenario, robot.withPlatform(side, side, robot.speed()));
    }

    private static boolean hasRoom(Scenario scenario, RobotSpec robot) {
        SimulationSetup setup = scenario.setup();
        return Clearance.findObstruction(setup.world(), robot, setup.start()).isEmpty();
    }

    private static MapFrame frame(FloorPlan plan) {
        return MapFrame.of(plan.description(), plan.grid().width(), plan.grid().height());
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
