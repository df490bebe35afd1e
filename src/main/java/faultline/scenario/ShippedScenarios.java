package faultline.scenario;

import faultline.io.ProgramFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.stream.Stream;

/** Lists the scenarios that ship with the program. */
public final class ShippedScenarios {

    /** The name of the file that is opened if none is given: its room has some of everything. */
    public static final String DEFAULT = "office.xml";

    private static final String FOLDER = "scenarios/";
    private static final String EXTENSION = ".xml";

    private ShippedScenarios() {}

    /**
     * {@return the names of the files, for {@link Scenario#loadShipped(String)}, in alphabetical order} Slow: reads the
     * program's own file.
     *
     * @throws IOException if the program's own file cannot be read
     */
    public static List<String> names() throws IOException {
        Path home = ProgramFile.find().orElseThrow(() -> new IOException("the program's own file is not known"));
        return Files.isDirectory(home) ? listFolder(home.resolve(FOLDER)) : listJar(home);
    }

    private static List<String> listFolder(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return sorted(files.map(file -> file.getFileName().toString()));
        }
    }

    static List<String> listJar(Path jar) throws IOException {
        try (JarFile opened = new JarFile(jar.toFile())) {
            return sorted(opened.stream()
                    .map(entry -> entry.getName())
                    .filter(name -> name.startsWith(FOLDER))
                    .map(name -> name.substring(FOLDER.length())));
        }
    }

    private static List<String> sorted(Stream<String> names) {
        // Folders hold files for special purposes, such as the worlds of the studies.
        return names.filter(name -> name.endsWith(EXTENSION) && !name.contains("/"))
                .sorted()
                .toList();
    }
}
