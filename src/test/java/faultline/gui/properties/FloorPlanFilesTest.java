package faultline.gui.properties;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FloorPlanFilesTest {

    @ParameterizedTest
    @CsvSource({"hall.png, true", "maps/hall.YAML, true", "hall.xml, false", "png, false", "/, false"})
    void aFloorPlanIsRecognisedByTheEndingOfItsName(Path file, boolean floorPlan) {
        assertEquals(floorPlan, FloorPlanFiles.isFloorPlan(file));
    }
}
