package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.PythonProcess.Output;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What {@code src/conf/compare-peers} does without the peers; with them, it measures for minutes. */
@Timeout(60)
class ComparePeersTest {

    @TempDir
    private Path folder;

    @BeforeEach
    void requirePython() throws Exception {
        PythonProcess.require();
    }

    @Test
    void aFolderThatIsNotEnkiIsRefused() throws Exception {
        assertEquals(
                new Output(
                        2,
                        "compare-peers: " + folder + " is not a copy of Enki: it has no file enki/PhysicalEngine.h.\n"),
                comparePeers(folder.toString()));
    }

    @Test
    void aFolderThatIsNotStageIsRefused() throws Exception {
        pretendEnki();
        assertEquals(
                new Output(
                        2, "compare-peers: " + folder + " is not a copy of Stage: it has no file libstage/stage.hh.\n"),
                comparePeers(folder.toString(), folder.toString()));
    }

    @Test
    void aMissingJarIsNamedWithTheCommandThatMakesIt() throws Exception {
        pretendEnki();
        assertEquals(
                new Output(2, "compare-peers: none.jar does not exist; `mvn -DskipTests package` makes it.\n"),
                comparePeers(folder.toString(), "--jar", "none.jar"));
    }

    private void pretendEnki() throws IOException {
        Files.createDirectory(folder.resolve("enki"));
        Files.createFile(folder.resolve("enki/PhysicalEngine.h"));
    }

    private static Output comparePeers(String... arguments) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("src/conf/compare-peers"));
        words.addAll(List.of(arguments));
        return PythonProcess.run(Map.of(), words.toArray(String[]::new));
    }
}
