package faultline.gui.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes that are killed while they keep unsaved edits: the edits are offered afterwards, the old ones or the new
 * ones. The system property {@code faultline.kills} sets how often.
 */
class KilledAutosaveTest {

    private static final long SAVE_MILLIS = 200;

    @TempDir
    private Path folder;

    /** Keeps the edits of two scenarios in turn, until it is killed. */
    static final class AutosaveLoop {

        private AutosaveLoop() {}

        public static void main(String[] args) throws Exception {
            RecoveryStore store = new RecoveryStore(Path.of(args[0]));
            Scenario scenario = Scenario.loadShipped("beside-a-wall.xml");
            store.save(Path.of("room.xml"), null, named("one", scenario));
            System.out.println("saved");
            while (true) {
                store.save(Path.of("room.xml"), null, named("other", scenario));
                store.save(Path.of("room.xml"), null, named("one", scenario));
            }
        }

        private static Scenario named(String name, Scenario scenario) {
            return new Scenario(name, "", false, scenario.setup(), scenario.expectation());
        }
    }

    @Test
    void theEditsOfAKilledProcessAreOfferedWhole() throws Exception {
        for (int i = 0; i < JavaProcess.KILLS; i++) {
            Process process = JavaProcess.startAndAwaitOutput(AutosaveLoop.class.getName(), List.of(folder.toString()));
            assertTrue(JavaProcess.killWithin(SAVE_MILLIS, process));
            RecoveryStore store = new RecoveryStore(folder);
            RecoveryStore.RecoveredFile offered = store.findOrphan(Set.of()).orElseThrow();
            assertTrue(List.of("one", "other").contains(offered.scenario().name()));
            assertEquals(Optional.of(Path.of("room.xml").toAbsolutePath()), offered.origin());
            store.discard(offered);
            assertEquals(Optional.empty(), store.findOrphan(Set.of()));
        }
        try (Stream<Path> files = Files.list(folder)) {
            // At most the temporary file of each kill, which the next process deletes when it is old enough.
            assertTrue(files.allMatch(file -> file.getFileName().toString().endsWith(".tmp")));
        }
    }
}
