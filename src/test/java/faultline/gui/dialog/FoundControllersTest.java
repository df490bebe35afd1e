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
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A developer has a controller on the class path of the program, and also chooses its jar in the window. */
class FoundControllersTest {

    private static final String SERVICE = "META-INF/services/" + ControllerProvider.class.getName();

    @TempDir
    private Path folder;

    private Path classes;

    /** Prints what is found with the jar that is the last argument, added to the other ones. */
    public static final class Finder {

        private Finder() {}

        /** Finds the controllers of jars. */
        public static void main(String[] arguments) {
            List<Path> jars = Stream.of(arguments).map(Path::of).toList();
            int last = jars.size() - 1;
            FoundControllers found = FoundControllers.of(jars.subList(0, last), jars.get(last));
            System.out.print(found.names() + " " + found.first() + " " + found.jars());
        }
    }

    @BeforeEach
    void addToTheClassPath() throws IOException {
        classes = Files.createDirectories(folder.resolve("classes"));
        compile("Turner", classes);
        Files.createDirectories(classes.resolve(SERVICE).getParent());
        Files.writeString(classes.resolve(SERVICE), "own.Turner");
    }

    /** Compiles a provider whose controller has the name of the class. */
    private void compile(String name, Path target) throws IOException {
        String text =
                """
                package own;
                public final class NAME implements faultline.control.ControllerProvider {
                    @Override public String name() { return "NAME"; }
                    @Override public faultline.control.Controller create(java.util.Map<String, String> settings) {
                        return null;
                    }
                }
                """;
        Path source = Files.writeString(folder.resolve(name + ".java"), text.replace("NAME", name));
        assertEquals(
                0,
                ToolProvider.getSystemJavaCompiler()
                        .run(null, null, null, "-cp", JavaProcess.classPath(), "-d", "" + target, "" + source));
    }

    private Path jar(String name) throws IOException {
        Path built = Files.createDirectories(folder.resolve(name));
        compile(name, built);
        Path jar = folder.resolve(name + ".jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry(SERVICE));
            out.write(("own." + name).getBytes(StandardCharsets.UTF_8));
            out.putNextEntry(new JarEntry("own/" + name + ".class"));
            out.write(Files.readAllBytes(built.resolve("own/" + name + ".class")));
        }
        return jar;
    }

    private String find(Path... jars) throws IOException {
        List<String> arguments = Stream.of(jars).map(Path::toString).toList();
        return JavaProcess.output(JavaProcess.builder(classes, Finder.class.getName(), arguments)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start());
    }

    @Test
    void aJarReplacesTheClassPath() throws IOException {
        Path jar = jar("Turner");
        assertEquals("[wall-follower, none, Turner] Turner [" + jar + "]", find(jar));
    }

    @Test
    void otherJarsStay() throws IOException {
        Path other = jar("Other");
        Path jar = jar("Turner");
        assertEquals("[wall-follower, none, Other, Turner] Turner [" + other + ", " + jar + "]", find(other, jar));
    }
}
