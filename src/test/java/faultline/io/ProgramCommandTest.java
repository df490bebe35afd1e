package faultline.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import java.io.File;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The command that a user can paste is that by which the program was started. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the paths are those of other systems")
class ProgramCommandTest {

    private static final String BUILT_JAR = "java -jar target/faultline.jar";

    @TempDir
    Path folder;

    /** A program that prints its own command. */
    static final class CommandPrinter {
        private CommandPrinter() {}

        /** Prints the command. */
        public static void main(String[] args) {
            System.out.print(ProgramCommand.text());
        }
    }

    @Test
    void aProgramInAnyFolderPrintsTheCommandThatHasStartedIt() throws Exception {
        Path jar = Files.createDirectory(folder.resolve("my tools")).resolve("robot.jar");
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, CommandPrinter.class.getName());
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar), manifest)) {
            for (Class<?> type :
                    List.of(ProgramCommand.class, ProgramFile.class, ShellText.class, CommandPrinter.class)) {
                String name = type.getName().replace('.', '/') + ".class";
                out.putNextEntry(new ZipEntry(name));
                try (InputStream in = type.getResourceAsStream("/" + name)) {
                    in.transferTo(out);
                }
            }
        }
        Process process = new ProcessBuilder(JavaProcess.executable(), "-jar", "my tools/robot.jar")
                .directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        assertEquals("java -jar \"my tools/robot.jar\"", JavaProcess.output(process));
    }

    private static String command(Map<String, String> properties, String searched, Path source) {
        return ProgramCommand.text(properties::get, searched, source);
    }

    private Path launcher(String name) throws Exception {
        Path file = folder.resolve(name).resolve("faultline");
        Files.createDirectories(file.getParent());
        assertTrue(Files.createFile(file).toFile().setExecutable(true));
        return file;
    }

    @Test
    void theJarIsNamedAsItWasStarted() throws Exception {
        Path jar = Files.createFile(folder.resolve("faultline.jar"));
        Path link = Files.createSymbolicLink(folder.resolve("my link.jar"), jar);
        assertEquals("java -jar " + jar, command(Map.of("java.class.path", "" + jar), "", jar));
        assertEquals("java -jar \"" + link + "\"", command(Map.of("java.class.path", "" + link), "", jar));
    }

    @Test
    void withOtherClassPathsTheJarOfABuildIsNamed() throws Exception {
        Path jar = Files.createFile(folder.resolve("faultline.jar"));
        Path other = Files.createFile(folder.resolve("other.jar"));
        for (String classPath : List.of("", "" + other, jar + File.pathSeparator + other, "" + folder, "\0")) {
            assertEquals(BUILT_JAR, command(Map.of("java.class.path", classPath), "", jar), classPath);
        }
        assertEquals(BUILT_JAR, command(Map.of("java.class.path", "" + folder), "", folder));
        assertEquals(BUILT_JAR, command(Map.of(), "", jar));
    }

    /** The Debian package has its own launcher on the path, which starts Java by itself. */
    @Test
    void anInstalledCommandIsNamed() throws Exception {
        Path jar = Files.createFile(folder.resolve("faultline.jar"));
        assertEquals(
                "faultline", command(Map.of("faultline.command", "faultline", "java.class.path", "" + jar), "", jar));
    }

    /** An empty part is not the root folder, where something else has the name of the launcher. */
    @Test
    void anEmptyPartOfThePathIsPassedOver() throws Exception {
        Path launcher = Files.createFile(folder.resolve(folder.getName(0)));
        assertTrue(launcher.toFile().setExecutable(true));
        Map<String, String> properties = Map.of("faultline.command", "faultline", "jpackage.app-path", "" + launcher);
        assertEquals("faultline", command(properties, File.pathSeparator + folder, folder));
        assertEquals(
                ShellText.quoted("" + launcher),
                command(properties, folder.getRoot() + File.pathSeparator + folder, folder));
    }

    @Test
    void anAppImageIsNamedByItsPathIfItsNameStartsNothingOrAnotherProgram() throws Exception {
        Path launcher = launcher("my image");
        Path other = launcher("other");
        Map<String, String> properties = Map.of("faultline.command", "faultline", "jpackage.app-path", "" + launcher);
        String own = "" + launcher.getParent();
        String path = "\"" + launcher + "\"";
        assertEquals(path, command(properties, "", folder));
        assertEquals(path, command(properties, folder + File.pathSeparator + folder.resolve("none"), folder));
        assertEquals(path, command(properties, other.getParent() + File.pathSeparator + own, folder));
        assertEquals("faultline", command(properties, File.pathSeparator + own, folder));
        Path link = Files.createSymbolicLink(
                Files.createDirectory(folder.resolve("bin")).resolve("faultline"), launcher);
        assertEquals("faultline", command(properties, "" + link.getParent(), folder));
    }
}
