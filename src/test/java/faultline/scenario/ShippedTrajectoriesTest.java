package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The trajectories of all shipped scenarios, which must not change by accident: each line of {@code trajectories.txt}
 * has a file and its hash, as {@code run FILE} prints it. A change that is wanted changes the line, and its commit
 * message and the changelog say why. The system property {@code faultline.trajectory.seconds} leaves out the longer
 * scenarios.
 */
class ShippedTrajectoriesTest {

    /** In seconds of simulated time. */
    private static final int LONGEST = Integer.getInteger("faultline.trajectory.seconds", Integer.MAX_VALUE);

    private static final Map<String, String> HASHES = read();

    private static Map<String, String> read() {
        Map<String, String> hashes = new TreeMap<>();
        try (InputStream in = ShippedTrajectoriesTest.class.getResourceAsStream("/trajectories.txt")) {
            new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().forEach(line -> {
                String[] words = line.split(" ", -1);
                hashes.put(words[0], words[1]);
            });
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return hashes;
    }

    static List<String> names() throws ScenarioException {
        List<String> names = new ArrayList<>();
        for (String name : HASHES.keySet()) {
            if (Scenario.loadShipped(name).setup().duration() <= LONGEST) {
                names.add(name);
            }
        }
        return names;
    }

    @ParameterizedTest
    @MethodSource("names")
    void theTrajectoryIsThatOfTheVersionsBefore(String name) throws ScenarioException {
        assertEquals(HASHES.get(name), Scenario.loadShipped(name).run().trajectoryHash());
    }

    @Test
    void everyShippedScenarioIsListed() throws IOException {
        assertEquals(
                ShippedScenariosTest.files().stream()
                        .map(file -> Path.of("scenarios").relativize(file).toString())
                        .toList(),
                List.copyOf(HASHES.keySet()));
    }
}
