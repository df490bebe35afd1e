package faultline.floorplan;

import static faultline.floorplan.CellState.FREE;
import static faultline.floorplan.CellState.OCCUPIED;
import static faultline.floorplan.CellState.UNKNOWN;
import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MapDescriptionTest {

    @TempDir
    private Path folder;

    /** The saved maps of ROS have 205 for unknown cells, whose occupancy of 50/255 is just above 0.196. */
    @Test
    void theUsualThresholdsOfMapServerHoldWithAndWithoutAMapFile() throws IOException {
        Path image = Files.writeString(folder.resolve("m.pgm"), "P2 6 1 255\n0 89 90 205 206 255\n");
        Path yaml = Files.writeString(folder.resolve("m.yaml"), "image: m.pgm\nresolution: 0.05\n");
        CellState[] expected = {OCCUPIED, OCCUPIED, UNKNOWN, UNKNOWN, FREE, FREE};
        OccupancyGrid grid = new OccupancyGrid(6, 1, expected);
        FloorPlan.Options options = FloorPlan.Options.DEFAULT;
        assertEquals(grid, FloorPlan.readYaml(yaml, options).grid(), "with a map file");
        assertEquals(
                grid,
                FloorPlan.read(MapDescription.of(image, new BigDecimal("0.05")), options)
                        .grid(),
                "an image alone");
    }

    @Test
    void aRawMapHasOccupanciesInPerCentUpToAHundred() throws IOException {
        Path yaml = folder.resolve("m.yaml");
        Files.writeString(folder.resolve("m.pgm"), "P2 6 1 255\n0 19 20 65 100 101\n");
        Files.writeString(yaml, "image: m.pgm\nresolution: 0.05\nmode: raw\n");
        CellState[] expected = {FREE, FREE, UNKNOWN, OCCUPIED, OCCUPIED, UNKNOWN};
        assertEquals(
                new OccupancyGrid(6, 1, expected),
                FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT).grid());
    }

    @Test
    void aMapFileWithoutAnOriginIsNotRotated() throws IOException {
        Files.writeString(folder.resolve("m.pgm"), "P2 1 1 255 0");
        Path yaml = Files.writeString(folder.resolve("m.yaml"), "image: m.pgm\nresolution: 0.05\n");
        assertEquals(
                0,
                FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT)
                        .description()
                        .yaw());
        Files.writeString(yaml, "origin: [1, 2, 0.5]\n", StandardOpenOption.APPEND);
        assertEquals(
                0.5,
                FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT)
                        .description()
                        .yaw());
    }

    @ParameterizedTest
    @CsvSource({
        "0.000001, true",
        "0.0000009, false",
        "1, true",
        "100000, true",
        "100000.1, false",
        "0, false",
        "-1, false"
    })
    void theLimitsOfTheResolutionAreAllowed(BigDecimal metres, boolean allowed) {
        assertEquals(allowed, MapDescription.isResolution(metres));
    }

    @ParameterizedTest
    @CsvSource({
        "1,  0,    0, 0, true",
        "1,  0,    1, 1, true",
        "0,  0,    1, 0, false",
        "-1, 0,    1, 0, false",
        "1,  NaN,  1, 0, false",
        "1,  0,  1.1, 0, false",
        "1,  0, -0.1, 0, false",
        "1,  0,  1, 1.1, false",
        "1,  0, 1, -0.1, false"
    })
    void theThresholdsAreShares(BigDecimal resolution, double yaw, double occupied, double free, boolean allowed) {
        Executable creation = () ->
                new MapDescription(folder.resolve("m.pgm"), resolution, yaw, MapMode.TRINARY, false, occupied, free);
        if (allowed) {
            assertDoesNotThrow(creation);
        } else {
            assertThrows(IllegalArgumentException.class, creation);
        }
    }

    @Test
    void aMapMayBeAsLargeAsAWorld() throws IOException {
        Path image = Files.writeString(folder.resolve("m.pgm"), "P2 4 1 255\n0 255 255 255\n");
        FloorPlan plan = FloorPlan.read(MapDescription.of(image, new BigDecimal(25_000)), FloorPlan.Options.DEFAULT);
        assertEquals(4, plan.segmentCount());
    }
}
