package faultline.floorplan;

import static org.junit.jupiter.api.Assertions.assertTimeout;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.xml.FileMutator;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Maps and images damaged at random: each is refused in one sentence, or gives a floor plan. The system property
 * {@code faultline.fuzz} sets their number to a tenth of it.
 */
class MutatedMapsTest {

    private static final int MAPS = Integer.getInteger("faultline.fuzz", 3000) / 10;
    private static final Duration MAX_TIME = Duration.ofSeconds(10);

    private static final String YAML =
            """
            image: map.pgm
            resolution: 0.50
            origin: [0.0, -1.5, 0]  # metres
            negate: 0
            mode: trinary
            occupied_thresh: 0.65
            free_thresh: 0.196
            """;

    private static final String IMAGE =
            """
            P2
            # a room
            6 4
            255
            0 0 0 0 0 0
            0 254 254 205 254 0
            0 254 100 254 254 0
            0 0 0 0 0 0
            """;

    @TempDir
    private Path folder;

    private final FileMutator mutator = new FileMutator();

    @Test
    void damagedMapsAreRefusedInOneSentenceOrRead() throws IOException {
        Path yaml = folder.resolve("map.yaml");
        int refused = 0;
        for (int i = 0; i < MAPS; i++) {
            byte[] description = i % 2 == 0 ? mutator.damaged(YAML) : YAML.getBytes(StandardCharsets.UTF_8);
            byte[] image = i % 2 == 1 ? mutator.damaged(IMAGE) : IMAGE.getBytes(StandardCharsets.UTF_8);
            Files.write(yaml, description);
            Files.write(folder.resolve("map.pgm"), image);
            String both = new String(description, StandardCharsets.UTF_8) + new String(image, StandardCharsets.UTF_8);
            refused += assertTimeout(MAX_TIME, () -> isRefused(yaml, both), both) ? 1 : 0;
        }
        assertTrue(4 * refused > MAPS && refused < MAPS, refused + " were refused");
    }

    private static boolean isRefused(Path yaml, String both) {
        try {
            FloorPlan plan = FloorPlan.readYaml(yaml, FloorPlan.Options.DEFAULT);
            FloorPlanScenario.create("map", plan, "");
            return false;
        } catch (IOException e) {
            assertTrue(e.getMessage().matches("[^\\p{Cc}]{10,}"), () -> e + "\n" + both);
            return true;
        } catch (RuntimeException | Error e) {
            throw new AssertionError(both, e);
        }
    }
}
