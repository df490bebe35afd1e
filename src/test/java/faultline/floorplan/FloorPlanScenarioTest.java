package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.SimulationSetup;
import faultline.engine.metrics.HeadlessRun;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.scenario.Scenario;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.World;
import faultline.world.WorldSpec;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests scenarios of maps: saving and loading loses nothing, and sensors see a plan like its outlines. */
class FloorPlanScenarioTest {

    private static final BigDecimal RESOLUTION = new BigDecimal("0.05");

    @TempDir
    private Path folder;

    @Test
    void theNameIsThatOfTheFileWithoutItsLastExtension() {
        assertEquals("office", FloorPlanScenario.nameFor(Path.of("maps", "office.yaml")));
        assertEquals("office.2", FloorPlanScenario.nameFor(Path.of("office.2.png")));
        assertEquals("office", FloorPlanScenario.nameFor(Path.of("office")));
    }

    @Test
    void theSavedScenarioHoldsTheBitmap() throws Exception {
        Random random = new Random(4);
        for (int trial = 0; trial < 20; trial++) {
            FloorPlan plan = plan(random, 30 + random.nextInt(30), 30 + random.nextInt(30), 0);
            Path file = folder.resolve("room.xml");
            Scenario made = FloorPlanScenario.create("Room", plan, "");
            made.save(file);
            Scenario read = Scenario.load(file);
            assertEquals(made, read);
            assertEquals(
                    plan.solid(), scan(read, plan.grid().width(), plan.grid().height()));
        }
    }

    /** Returns the cells whose middle is inside the plan of the scenario. */
    private static SolidCells scan(Scenario scenario, int width, int height) {
        Obstacle plan = scenario.setup().world().obstacles().get(0);
        boolean[] solid = new boolean[width * height];
        for (int i = 0; i < solid.length; i++) {
            Vector2 middle = new Vector2((i % width + 0.5) * 0.05, (i / width + 0.5) * 0.05);
            solid[i] = plan.shape().contains(plan.pose().toLocal(middle));
        }
        return new SolidCells(width, height, solid);
    }

    @Test
    void coordinatesAreDecimalsOfTheResolution() throws IOException {
        String text = new String(
                FloorPlanScenario.create("Room", plan(new Random(5), 40, 40, 0), "")
                        .toBytes(),
                StandardCharsets.UTF_8);
        String points = text.replaceAll("(?s).*<plan[^>]*points=\"([^\"]*)\".*", "$1");
        for (String number : points.split("[ ,|]+")) {
            assertTrue(number.matches("\\d+(\\.\\d{1,2})?"), number);
        }
    }

    @Test
    void aPlanIsSensedAsThePolygonsOfItsOutlinesAre() throws IOException {
        FloorPlan plan = plan(new Random(6), 60, 60, 0);
        SimulationSetup setup = FloorPlanScenario.create("Room", plan, "").setup();
        List<Obstacle> polygons = new ArrayList<>();
        ObstacleShape.PlanShape shape =
                (ObstacleShape.PlanShape) setup.world().obstacles().get(0).shape();
        for (List<Vector2> ring : shape.rings()) {
            polygons.add(new Obstacle("p" + polygons.size(), new ObstacleShape.PolygonShape(ring), new Pose(0, 0, 0)));
        }
        WorldSpec other = setup.world().withObstacles(polygons);
        Random random = new Random(7);
        for (int i = 0; i < 500; i++) {
            Pose pose = new Pose(3 * random.nextDouble(), 3 * random.nextDouble(), 7 * random.nextDouble());
            assertArrayEquals(readings(setup.world(), setup, pose), readings(other, setup, pose));
        }
    }

    private static double[] readings(WorldSpec spec, SimulationSetup setup, Pose pose) {
        World world = new World(spec, setup.robot(), pose, setup.dt(), setup.seed());
        world.sense();
        double[] readings = new double[setup.robot().sensors().size()];
        for (int i = 0; i < readings.length; i++) {
            readings[i] = world.trueReading(i);
        }
        return readings;
    }

    @Test
    void aMapWithoutRoomForTheRobotIsRefusedWithASentence() throws FloorPlanException {
        CellState[] cells = new CellState[40 * 30];
        Arrays.setAll(cells, i -> (i + i / 40) % 2 == 0 ? CellState.FREE : CellState.OCCUPIED);
        for (double yaw : new double[] {0, 0.5}) {
            FloorPlan plan = trace(40, 30, yaw, cells);
            FloorPlanException problem =
                    assertThrows(FloorPlanException.class, () -> FloorPlanScenario.create("Chess", plan, "--start"));
            assertEquals(
                    "none.pgm: the robot, 0.25 m long and 0.2 m wide, has no room in the free space"
                            + " of this map of 2 x 1.5 m; what may help: --start",
                    problem.getMessage());
        }
    }

    /** About the middle of a cell, the robot would touch a wall in its first turn. */
    @Test
    void theRobotStartsInTheMiddleOfACorridorOfTwoWideCells() throws FloorPlanException {
        CellState[] cells = new CellState[20 * 4];
        Arrays.setAll(cells, i -> i / 20 == 1 || i / 20 == 2 ? CellState.FREE : CellState.OCCUPIED);
        Scenario corridor = FloorPlanScenario.create("Corridor", trace(20, 4, 0, new BigDecimal("0.2"), cells), "");
        assertEquals(new Pose(0.2, 0.4, 0), corridor.setup().start());
    }

    /** About a corner of cells, it would touch a wall. */
    @Test
    void theRobotStartsInTheMiddleOfACorridorInWhichItCannotTurn() throws FloorPlanException {
        CellState[] cells = new CellState[20 * 5];
        Arrays.setAll(cells, i -> i / 20 == 0 || i / 20 == 4 ? CellState.OCCUPIED : CellState.FREE);
        Scenario corridor = FloorPlanScenario.create("Corridor", trace(20, 5, 0, new BigDecimal("0.1"), cells), "");
        assertEquals(new Pose(0.15, 0.25, 0), corridor.setup().start());
    }

    @Test
    void theRobotStartsInTheMiddleOfLargeUnknownCellsWithoutAnObstacle() throws FloorPlanException {
        CellState[] cells = new CellState[9];
        Arrays.fill(cells, CellState.UNKNOWN);
        SimulationSetup setup = FloorPlanScenario.create("Unknown", trace(3, 3, 0, BigDecimal.ONE, cells), "")
                .setup();
        assertEquals(new Pose(1.5, 1.5, 0), setup.start());
        assertEquals(List.of(), setup.world().obstacles());
    }

    @Test
    void unknownCellsAreAPlaceToStartOnlyIfNoneIsKnown() throws FloorPlanException {
        CellState[] cells = new CellState[40 * 30];
        Arrays.fill(cells, CellState.UNKNOWN);
        cells[0] = CellState.OCCUPIED;
        Pose anywhere = FloorPlanScenario.create("Unknown", trace(40, 30, 0, cells), "")
                .setup()
                .start();
        assertEquals(new Pose(0.725, 0.725, 0), anywhere);
        for (int i = 0; i < cells.length; i++) {
            cells[i] = i % 40 >= 30 && i / 40 >= 20 ? CellState.FREE : cells[i];
        }
        Pose known = FloorPlanScenario.create("Known", trace(40, 30, 0, cells), "")
                .setup()
                .start();
        assertEquals(new Pose(1.725, 1.225, 0), known);
    }

    @Test
    void aRotatedMapLiesInsideItsWorld() throws Exception {
        FloorPlan plan = plan(new Random(8), 40, 30, 0.7);
        Scenario scenario = FloorPlanScenario.create("Room", plan, "");
        WorldSpec world = scenario.setup().world();
        Obstacle obstacle = world.obstacles().get(0);
        for (List<Vector2> ring : ((ObstacleShape.PlanShape) obstacle.shape()).rings()) {
            for (Vector2 point : ring) {
                Vector2 p = obstacle.pose().toParent(point);
                assertTrue(
                        p.x() > -1e-6 && p.y() > -1e-6 && p.x() < world.width() && p.y() < world.height(), p::toString);
            }
        }
        HeadlessRun.run(scenario.setup().withDuration(1), ControllerMode.DIRECT, List.of());
    }

    /** A map with a free square in the middle, big enough for the robot. */
    private static FloorPlan plan(Random random, int width, int height, double yaw) throws FloorPlanException {
        CellState[] cells = new CellState[width * height];
        for (int i = 0; i < cells.length; i++) {
            boolean middle = Math.abs(i % width - width / 2) < 8 && Math.abs(i / width - height / 2) < 8;
            cells[i] = middle || random.nextDouble() < 0.8 ? CellState.FREE : CellState.OCCUPIED;
        }
        return trace(width, height, yaw, cells);
    }

    private static FloorPlan trace(int width, int height, double yaw, CellState[] cells) throws FloorPlanException {
        return trace(width, height, yaw, RESOLUTION, cells);
    }

    private static FloorPlan trace(int width, int height, double yaw, BigDecimal resolution, CellState[] cells)
            throws FloorPlanException {
        MapDescription description =
                new MapDescription(Path.of("none.pgm"), resolution, yaw, MapMode.TRINARY, false, 0.65, 0.196);
        return FloorPlan.trace(description, new OccupancyGrid(width, height, cells), FloorPlan.Options.DEFAULT);
    }
}
