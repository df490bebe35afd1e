package faultline;

import faultline.world.World;
import java.io.File;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assertions;

/** Starts Java programs with the class path of the tests, and kills them at random moments. */
public final class JavaProcess {

    /** How often each writer is killed; the system property {@code faultline.kills} sets it. */
    public static final int KILLS = Integer.getInteger("faultline.kills", 3);

    private static final SplittableRandom RANDOM = new SplittableRandom(Long.getLong("faultline.kills.seed", 99));

    private JavaProcess() {}

    /** Returns a builder of a process that runs a class. */
    public static ProcessBuilder builder(String mainClass, List<String> arguments) {
        return builder(classPath(), mainClass, arguments);
    }

    /** Returns a builder of a process that runs a class, with a folder of further classes. */
    public static ProcessBuilder builder(Path classes, String mainClass, List<String> arguments) {
        return builder(classPath() + File.pathSeparator + classes, mainClass, arguments);
    }

    private static ProcessBuilder builder(String classPath, String mainClass, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp", classPath, mainClass));
        command.addAll(arguments);
        return new ProcessBuilder(command);
    }

    /**
     * Returns the classes of the program, those of the tests, and the assertions, which a test runner may load
     * separately.
     */
    public static String classPath() {
        return Stream.of(World.class, JavaProcess.class, Assertions.class)
                        .map(JavaProcess::location)
                        .collect(Collectors.joining(File.pathSeparator, "", File.pathSeparator))
                + System.getProperty("java.class.path");
    }

    private static String location(Class<?> type) {
        return Path.of(URI.create(
                        type.getProtectionDomain().getCodeSource().getLocation().toString()))
                .toString();
    }

    /** Starts a class and discards its output. */
    public static Process start(String mainClass, List<String> arguments) throws IOException {
        return builder(mainClass, arguments)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    /** Starts a class and waits until it has written its first byte to standard output. */
    public static Process startAndAwaitOutput(String mainClass, List<String> arguments) throws IOException {
        Process process = builder(mainClass, arguments)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        if (process.getInputStream().read() < 0) {
            throw new IOException(mainClass + " wrote nothing");
        }
        return process;
    }

    /** Returns what a process writes until it ends; one that does not end within five minutes is killed. */
    public static String output(Process process) throws IOException {
        CompletableFuture.delayedExecutor(5, TimeUnit.MINUTES).execute(process::destroyForcibly);
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    /** Sends a signal to a process, such as {@code -STOP}; not on Windows. */
    public static void signal(String signal, ProcessHandle process) throws IOException, InterruptedException {
        Assertions.assertEquals(
                0,
                new ProcessBuilder("kill", signal, Long.toString(process.pid()))
                        .start()
                        .waitFor());
    }

    /** Kills a process after a random time, unless it has ended by then. Returns whether it was killed. */
    public static boolean killWithin(long millis, Process process) throws InterruptedException {
        if (process.waitFor(RANDOM.nextLong(millis), TimeUnit.MILLISECONDS)) {
            return false;
        }
        process.destroyForcibly().waitFor();
        return true;
    }

    /**
     * Ends a process by SIGTERM after a random time, unless it has ended by then. Returns whether it was ended so. Not
     * on Windows, where a process cannot be asked to end.
     */
    public static boolean terminateWithin(long millis, Process process) throws InterruptedException {
        if (process.waitFor(RANDOM.nextLong(millis), TimeUnit.MILLISECONDS)) {
            return false;
        }
        process.destroy();
        process.waitFor();
        return true;
    }
}
