package faultline.gui.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.JavaProcess;
import faultline.control.ControllerProvider;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A developer runs the program with the own controller on the class path, and chooses the jar with it, too. */
class FoundControllersTest {

    private static final String SERVICE = "META-INF/services/" + ControllerProvider.class.getName();

    @TempDir
    private Path folder;

    /** Prints what is found with a jar. */
    public static final class Finder {

        private Finder() {}

        /** Finds the controllers of the jar that is the argument. */
        public static void main(String[] arguments) {
            FoundControllers found = FoundControllers.of(List.of(), Path.of(arguments[0]));
            System.out.print(found.names() + " " + found.first() + " " + found.jars());
        }
    }

    @Test
    void aJarReplacesTheClassPath() throws IOException {
        Path classes = Files.createDirectories(folder.resolve("classes"));
        Path source = Files.writeString(
                folder.resolve("Turner.java"),
                """
                package own;
                public final class Turner implements faultline.control.ControllerProvider {
                    @Override public String name() { return "turner"; }
                    @Override public faultline.control.Controller create(java.util.Map<String, String> settings) {
                        return null;
                    }
                }
                """);
        assertEquals(
                0,
                ToolProvider.getSystemJavaCompiler()
                        .run(null, null, null, "-cp", JavaProcess.classPath(), "-d", "" + classes, "" + source));
        byte[] service = "own.Turner".getBytes(StandardCharsets.UTF_8);
        Files.createDirectories(classes.resolve(SERVICE).getParent());
        Files.write(classes.resolve(SERVICE), service);
        Path jar = folder.resolve("turner.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry(SERVICE));
            out.write(service);
            out.putNextEntry(new JarEntry("own/Turner.class"));
            out.write(Files.readAllBytes(classes.resolve("own/Turner.class")));
        }
        ProcessBuilder finder = JavaProcess.builder(classes, Finder.class.getName(), List.of(jar.toString()));
        Process process = finder.redirectError(ProcessBuilder.Redirect.INHERIT).start();
        assertEquals("[wall-follower, none, turner] turner [" + jar + "]", JavaProcess.output(process));
    }
}
