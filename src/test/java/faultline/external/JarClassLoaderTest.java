package faultline.external;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import faultline.control.ControllerProvider;
import faultline.control.Decision;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Node;

/** What a jar has replaces what the class path has, but not what belongs to the program or to the JDK. */
class JarClassLoaderTest {

    @TempDir
    private Path folder;

    /** Makes a loader of one jar. */
    private JarClassLoader loader(Map<String, byte[]> files, ClassLoader parent) throws IOException {
        Path jar = folder.resolve("some.jar");
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
            out.putNextEntry(new JarEntry("META-INF/services/" + ControllerProvider.class.getName()));
            out.write(bytes("own.Gain"));
            for (Map.Entry<String, byte[]> file : files.entrySet()) {
                out.putNextEntry(new JarEntry(file.getKey()));
                out.write(file.getValue());
            }
        }
        return new JarClassLoader(List.of(jar), parent);
    }

    private Map<String, byte[]> jarWithGain(String gain) throws IOException {
        Path source = Files.writeString(
                folder.resolve("Gain.java"),
                "package own; public final class Gain { public String toString() { return \"" + gain + "\"; } }");
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, source.toString()));
        return Map.of("own/Gain.class", Files.readAllBytes(folder.resolve("Gain.class")), "own/gain.txt", bytes(gain));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    @Test
    void aJarWinsAgainstAClassAndAResourceOfTheSameName() throws Exception {
        ClassLoader classPath = loader(jarWithGain("1"), getClass().getClassLoader());
        ClassLoader loader = loader(jarWithGain("5"), classPath);
        Class<?> gain = loader.loadClass("own.Gain");
        assertEquals("5", gain.getConstructor().newInstance().toString());
        assertSame(gain, loader.loadClass("own.Gain"));
        try (InputStream in = gain.getResourceAsStream("gain.txt")) {
            assertEquals("5", new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    @Test
    void theClassesOfTheProgramAndOfTheJdkAreShared() throws Exception {
        Map<String, byte[]> copies =
                Map.of("faultline/control/Decision.class", bytes("other"), "org/w3c/dom/Node.class", bytes("other"));
        ClassLoader loader = loader(copies, getClass().getClassLoader());
        assertSame(Decision.class, loader.loadClass("faultline.control.Decision"));
        assertSame(Node.class, loader.loadClass("org.w3c.dom.Node"));
        assertEquals(
                Decision.class.getResource("Decision.class"), loader.getResource("faultline/control/Decision.class"));
    }
}
