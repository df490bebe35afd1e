package faultline;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** Runs programs in Python. */
public final class PythonProcess {

    private PythonProcess() {}

    /** The exit code of a program, -1 if there is no Python, and what it wrote to standard output and error. */
    public record Output(int code, String text) {}

    /** Skips the test if there is no Python of the version that the program's scripts need. */
    public static void require() throws IOException, InterruptedException {
        Output version = run(Map.of(), "-c", "import sys; sys.exit(sys.version_info < (3, 8))");
        assumeTrue(version.code() == 0, "needs Python 3.8");
    }

    /** Runs Python with some arguments, without input, for at most a minute. */
    public static Output run(Map<String, String> environment, String... arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("python3"));
        command.addAll(List.of(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().putAll(environment);
        try {
            Process process = builder.start();
            process.getOutputStream().close();
            String text = JavaProcess.output(process);
            assertTrue(process.waitFor(60, TimeUnit.SECONDS), text);
            return new Output(process.exitValue(), text);
        } catch (IOException notThere) {
            return new Output(-1, notThere.getMessage());
        }
    }
}
