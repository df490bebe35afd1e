package faultline.floorplan;

import faultline.io.Message;
import faultline.scenario.xml.ScenarioLimits;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * A map that has been read and traced.
 *
 * @param description the contents of the map file
 * @param grid the classified cells
 * @param solid the cells that obstruct the robot
 * @param rings the outlines of the solid cells, solid by the even-odd rule, in cells
 */
public record FloorPlan(MapDescription description, OccupancyGrid grid, SolidCells solid, List<GridRing> rings) {

    /** The plan itself is one of the obstacles and points of a scenario. */
    private static final int MAX_SEGMENTS = ScenarioLimits.MAX_PARTS - 1;

    /** The longest outlines that are traced to be straightened, so that time and memory are bounded. */
    private static final int MAX_SMOOTHED = 2_000_000;

    /**
     * Creates a floor plan from a copy of the rings.
     *
     * @param description the contents of the map file
     * @param grid the classified cells
     * @param solid the cells that obstruct the robot
     * @param rings the outlines of the solid cells, solid by the even-odd rule, in cells
     */
    public FloorPlan {
        rings = List.copyOf(rings);
    }

    /**
     * The options of tracing a map.
     *
     * @param unknownIsSolid whether unknown cells count as solid
     * @param minCells the minimum size of a group of solid cells; smaller groups are dropped
     * @param smoothing the bound for simplified outlines, in cells; 0 keeps the exact staircase
     */
    public record Options(boolean unknownIsSolid, int minCells, double smoothing) {

        /** Exact outlines of the occupied cells. */
        public static final Options DEFAULT = new Options(false, 1, 0);

        /**
         * Creates the options.
         *
         * @param unknownIsSolid whether unknown cells count as solid
         * @param minCells the minimum size of a group of solid cells; smaller groups are dropped
         * @param smoothing the bound for simplified outlines, in cells; 0 keeps the exact staircase
         * @throws IllegalArgumentException if the number of cells is negative, or the smoothing is negative or not
         *     finite
         */
        public Options {
            if (minCells < 0) {
                throw new IllegalArgumentException("the number of cells must not be negative: " + minCells);
            }
            if (!(smoothing >= 0 && Double.isFinite(smoothing))) {
                throw new IllegalArgumentException("the smoothing must not be negative: " + smoothing);
            }
        }
    }

    /**
     * {@return whether a file is a map's YAML file, and not an image, by the ending of its name}
     *
     * @param file any file name
     */
    public static boolean isYaml(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return name.endsWith(".yaml") || name.endsWith(".yml");
    }

    /**
     * {@return the plan in a map_server YAML file and its image}
     *
     * @param yaml the YAML file
     * @param options the options of the tracing
     * @throws IOException if the files cannot be read
     */
    public static FloorPlan readYaml(Path yaml, Options options) throws IOException {
        return read(MapYamlReader.read(yaml), options);
    }

    /**
     * {@return notes on what a map file contains without an effect, but probably by mistake}
     *
     * @param yaml the YAML file
     * @throws IOException if the file cannot be read
     */
    public static List<Message> readNotes(Path yaml) throws IOException {
        return MapYamlReader.readNotes(yaml);
    }

    /**
     * {@return the plan in an image}
     *
     * @param description names a PGM, PNG, BMP, GIF or TIFF file and says how it is read
     * @param options the options of the tracing
     * @throws IOException if the file cannot be read
     */
    public static FloorPlan read(MapDescription description, Options options) throws IOException {
        try {
            return trace(description, description.classify(MapImageReader.read(description.image())), options);
        } catch (OutOfMemoryError e) {
            throw new FloorPlanException(description.image(), FloorPlanProblem.MEMORY.with());
        }
    }

    /**
     * Checks that a file is an image that can be read.
     *
     * @param file the file
     * @throws FloorPlanException if it is not
     */
    public static void checkImage(Path file) throws FloorPlanException {
        MapImageReader.read(file);
    }

    /** Traces classified cells. */
    static FloorPlan trace(MapDescription description, OccupancyGrid grid, Options options) throws FloorPlanException {
        description.requireSize(grid.width(), grid.height());
        SolidCells solid = grid.solidCells(options.unknownIsSolid()).withoutSpecks(options.minCells());
        requireSegments(description, solid.cornerCount(), options.smoothing() > 0 ? MAX_SMOOTHED : MAX_SEGMENTS);
        List<GridRing> rings = OutlineTracer.trace(solid);
        if (options.smoothing() > 0) {
            rings = rings.stream()
                    .map(ring -> OutlineSimplifier.simplify(ring, options.smoothing()))
                    .toList();
        }
        FloorPlan plan = new FloorPlan(description, grid, solid, rings);
        requireSegments(description, plan.segmentCount(), MAX_SEGMENTS);
        return plan;
    }

    private static void requireSegments(MapDescription description, long count, long allowed)
            throws FloorPlanException {
        if (count > allowed) {
            throw new FloorPlanException(description.image(), FloorPlanProblem.SEGMENTS.with(count, allowed));
        }
    }

    /** {@return the number of wall segments of all outlines} */
    public int segmentCount() {
        return rings.stream().mapToInt(GridRing::size).sum();
    }
}
