package faultline.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the list of the scenarios that are part of the program. */
class ShippedScenariosListTest {

    @TempDir
    private Path folder;

    @Test
    void everyFileOfTheFolderIsListed() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("scenarios"))) {
            assertEquals(
                    files.map(file -> file.getFileName().toString())
                            .filter(name -> name.endsWith(".xml"))
                            .sorted()
                            .toList(),
                    ShippedScenarios.names());
        }
    }

    @Test
    void scenariosInAJarAreListed() throws IOException {
        Path jar = folder.resolve("program.jar");
        try (OutputStream out = Files.newOutputStream(jar);
                JarOutputStream entries = new JarOutputStream(out)) {
            for (String name : List.of(
                    "scenarios/yard.xml",
                    "scenarios/",
                    "other/office.xml",
                    "scenarios/a.xml",
                    "scenarios/notes.txt",
                    "scenarios/studies/b.xml")) {
                entries.putNextEntry(new JarEntry(name));
                entries.closeEntry();
            }
        }
        assertEquals(List.of("a.xml", "yard.xml"), ShippedScenarios.listJar(jar));
    }
}
