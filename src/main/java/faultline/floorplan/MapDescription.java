package faultline.floorplan;

import faultline.io.DecimalText;
import faultline.scenario.xml.ScenarioLimits;
import java.math.BigDecimal;
import java.nio.file.Path;

/**
 * The contents of a map_server YAML file.
 *
 * @param image the image file
 * @param resolution the side of a cell, metres, positive
 * @param yaw the direction of the image's rows in the world, radians, counter-clockwise
 * @param mode the meaning of pixel values
 * @param negate whether white is occupied
 * @param occupiedThreshold a cell of at least this occupancy is occupied, in [0, 1]
 * @param freeThreshold a cell of at most this occupancy is free, in [0, 1]
 */
public record MapDescription(
        Path image,
        BigDecimal resolution,
        double yaw,
        MapMode mode,
        boolean negate,
        double occupiedThreshold,
        double freeThreshold) {

    /** The allowed sides of a cell, in words. */
    public static final String RESOLUTIONS = FloorPlanProblem.RESOLUTION.english();

    /** The usual value of {@code occupiedThreshold}. */
    public static final double DEFAULT_OCCUPIED = 0.65;

    private static final BigDecimal MIN_RESOLUTION = new BigDecimal("0.000001");
    /** The greatest width and height of a world, metres. */
    private static final BigDecimal MAX_SIZE = new BigDecimal(ScenarioLimits.MAX_COORDINATE);

    /** The brightness of white in map files. */
    private static final double WHITE = 255;

    private static final double DEFAULT_FREE = 0.196;

    /**
     * Creates a description.
     *
     * @param image the image file
     * @param resolution the side of a cell, metres, positive
     * @param yaw the direction of the image's rows in the world, radians, counter-clockwise
     * @param mode the meaning of pixel values
     * @param negate whether white is occupied
     * @param occupiedThreshold a cell of at least this occupancy is occupied, in [0, 1]
     * @param freeThreshold a cell of at most this occupancy is free, in [0, 1]
     * @throws IllegalArgumentException if the resolution is not positive, the yaw is not finite, or a threshold is
     *     outside [0, 1]
     */
    public MapDescription {
        if (resolution.signum() <= 0) {
            throw new IllegalArgumentException("the resolution must be positive: " + resolution);
        }
        if (!Double.isFinite(yaw)) {
            throw new IllegalArgumentException("the yaw must be finite: " + yaw);
        }
        if (!(occupiedThreshold >= 0 && occupiedThreshold <= 1 && freeThreshold >= 0 && freeThreshold <= 1)) {
            throw new IllegalArgumentException(
                    "thresholds must be in [0, 1]: " + occupiedThreshold + ", " + freeThreshold);
        }
    }

    /**
     * {@return the description of an image without a YAML file, with map_server's usual thresholds: dark pixels are
     * occupied}
     *
     * @param image the image file
     * @param resolution the side of a cell, metres
     */
    public static MapDescription of(Path image, BigDecimal resolution) {
        return new MapDescription(image, resolution, 0, MapMode.TRINARY, false, DEFAULT_OCCUPIED, DEFAULT_FREE);
    }

    /**
     * {@return this description with another meaning of the pixels}
     *
     * @param whiteIsOccupied whether white is occupied, and not black
     * @param threshold a cell of at least this occupancy is occupied, in [0, 1]
     */
    public MapDescription withOccupied(boolean whiteIsOccupied, double threshold) {
        return new MapDescription(image, resolution, yaw, mode, whiteIsOccupied, threshold, freeThreshold);
    }

    /**
     * {@return whether a number is allowed as the side of a cell}
     *
     * @param metres any number
     */
    public static boolean isResolution(BigDecimal metres) {
        return metres.compareTo(MIN_RESOLUTION) >= 0 && metres.compareTo(MAX_SIZE) <= 0;
    }

    /** Throws an exception if a map with this number of cells, rotated by its yaw, exceeds the size of a world. */
    void requireSize(int columns, int rows) throws FloorPlanException {
        MapFrame frame = MapFrame.of(this, columns, rows);
        if (Math.max(frame.width(), frame.height()) > MAX_SIZE.doubleValue()) {
            throw new FloorPlanException(
                    image,
                    FloorPlanProblem.MAP_SIZE.with(wholeMetres(frame.width()), wholeMetres(frame.height()), MAX_SIZE));
        }
    }

    /** Returns a length rounded up, so that one that is too great is not shown as the greatest one. */
    private static String wholeMetres(double length) {
        return DecimalText.formatFixed(Math.ceil(length), 0);
    }

    /** Returns a number of cells in metres, the nearest double to their exact product with the resolution. */
    double metres(double cells) {
        return resolution.multiply(BigDecimal.valueOf(cells)).doubleValue();
    }

    /** Classifies the pixels of this map's image. */
    OccupancyGrid classify(MapImage pixels) {
        byte[] cells = new byte[pixels.width() * pixels.height()];
        for (int row = 0; row < pixels.height(); row++) {
            int rowFromTop = pixels.height() - 1 - row;
            for (int column = 0; column < pixels.width(); column++) {
                CellState state = pixels.isTransparent(column, rowFromTop)
                        ? CellState.UNKNOWN
                        : classify(pixels.sample(column, rowFromTop), pixels.white());
                cells[row * pixels.width() + column] = (byte) state.ordinal();
            }
        }
        return new OccupancyGrid(pixels.width(), pixels.height(), cells);
    }

    private CellState classify(int sample, int white) {
        double occupancy = occupancy(sample, white);
        if (mode == MapMode.RAW && occupancy > 1) {
            return CellState.UNKNOWN;
        }
        if (occupancy >= occupiedThreshold) {
            return CellState.OCCUPIED;
        }
        return occupancy <= freeThreshold ? CellState.FREE : CellState.UNKNOWN;
    }

    /** Returns the nearest double to the occupancy, so that it equals a threshold that it is equal to. */
    private double occupancy(int sample, int white) {
        if (mode == MapMode.RAW) {
            return Math.rint(sample * WHITE / white) / 100;
        }
        return (double) (negate ? sample : white - sample) / white;
    }
}
