package faultline.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.JavaProcess;
import faultline.control.ControllerProvider;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.spi.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A provider of a named module, which a static method may make instead of a constructor. */
class ModuleProviderTest {

    private static final String SOURCE =
            """
            package turner;

            import faultline.control.*;
            import faultline.robot.Velocity;
            import java.util.Map;

            public class Turners {
                public static ControllerProvider provider() {
                    return new ControllerProvider() {
                        public String name() { return "turner"; }
                        public Controller create(Map<String, String> settings) {
                            return o -> Decision.ofVelocity(o.robot(), new Velocity(0, 1), "TURN", "");
                        }
                    };
                }
            }
            """;

    @TempDir
    private Path folder;

    /** The type of such a provider is the result of the method, here the interface. */
    @Test
    void aStaticMethodOfAModuleMayMakeAProvider() throws Exception {
        Path program = folder.resolve("faultline.jar");
        runTool("jar", "--create", "--no-compress", "--file", "" + program, "-C", JavaProcess.programClasses(), ".");
        Process process = new ProcessBuilder(
                        JavaProcess.executable(),
                        "-p",
                        program + File.pathSeparator + compiledModule(program),
                        "--add-modules",
                        "turner",
                        "-m",
                        "faultline/faultline.app.Main",
                        "run",
                        "scenarios/yard.xml",
                        "--controller",
                        "turner",
                        "--until",
                        "0.1")
                .redirectErrorStream(true)
                .start();
        String output = JavaProcess.output(process);
        assertTrue(output.contains("states: EXTERN TURN"), output);
    }

    private Path compiledModule(Path program) throws IOException {
        String module = "module turner { requires faultline; provides " + ControllerProvider.class.getName()
                + " with turner.Turners; }";
        Path description = Files.writeString(folder.resolve("module-info.java"), module);
        Path source = Files.writeString(
                Files.createDirectory(folder.resolve("turner")).resolve("Turners.java"), SOURCE);
        Path classes = folder.resolve("classes");
        runTool("javac", "-p", "" + program, "-d", "" + classes, "" + description, "" + source);
        return classes;
    }

    private static void runTool(String name, String... arguments) {
        assertEquals(0, ToolProvider.findFirst(name).orElseThrow().run(System.out, System.err, arguments));
    }
}
