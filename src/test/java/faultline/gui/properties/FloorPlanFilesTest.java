package faultline.gui.properties;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.floorplan.FloorPlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FloorPlanFilesTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"hall.png, true", "maps/hall.YAML, true", "hall.xml, false", "png, false", "/, false"})
    void aFloorPlanIsRecognisedByTheEndingOfItsName(Path file, boolean floorPlan) {
        assertEquals(floorPlan, FloorPlanFiles.isFloorPlan(file));
    }

    /** Smoothing can close the room. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            0  | false
            30 | true
            """)
    void aPlanWithoutRoomNamesTheSmoothingThatIsSet(double smoothing, boolean named) throws IOException {
        Files.writeString(folder.resolve("tiny.pgm"), "P2 2 2 255 9 255 255 9");
        Path map = Files.writeString(folder.resolve("tiny.yaml"), "image: tiny.pgm\nresolution: 0.05\n");
        String noRoom = FloorPlanFiles.read(map, null, new FloorPlan.Options(false, 1, smoothing), null)
                .noRoom();
        assertTrue(
                noRoom.contains("in the map file, \"Unknown cells are walls\", "
                        + (named ? "\"Smoothing, cells\", or a start" : "or a start")),
                noRoom);
    }
}
