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

/**
 * Starts Java programs, and kills them at random moments. Most of them end so early that the optimising compiler would
 * take more time than it saves, so they do without it. Programs whose processor time or memory a test limits, and those
 * that compute for long, get the virtual machine as users start it.
 */
public final class JavaProcess {

    /** How often each writer is killed; the system property {@code faultline.kills} sets it. */
    public static final int KILLS = Integer.getInteger("faultline.kills", 3);

    /** The options of a virtual machine for a program that ends soon. */
    private static final List<String> FOR_SHORT_PROGRAMS = List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");

    private static final SplittableRandom RANDOM = new SplittableRandom(Long.getLong("faultline.kills.seed", 99));

    private JavaProcess() {}

    /** Returns a builder of a process that runs a class for a short time. */
    public static ProcessBuilder builder(String mainClass, List<String> arguments) {
        return new ProcessBuilder(command(FOR_SHORT_PROGRAMS, classPath(), mainClass, arguments));
    }

    /** Returns a builder of a process that runs a class for a short time, with a folder of further classes. */
    public static ProcessBuilder builder(Path classes, String mainClass, List<String> arguments) {
        return new ProcessBuilder(
                command(FOR_SHORT_PROGRAMS, classPath() + File.pathSeparator + classes, mainClass, arguments));
    }

    /** Returns a builder of a process that runs a class for long, or within limits. */
    public static ProcessBuilder longBuilder(String mainClass, List<String> arguments) {
        return new ProcessBuilder(command(List.of(), classPath(), mainClass, arguments));
    }

    /**
     * Returns the command that runs the program for a short time, from its own classes alone. Further options of the
     * virtual machine have their place at index 1, arguments at the end.
     */
    public static List<String> program() {
        return command(FOR_SHORT_PROGRAMS, programClasses(), "faultline.app.Main", List.of());
    }

    /** Returns the command that runs the program for long, or within limits, from its own classes alone. */
    public static List<String> longProgram() {
        return command(List.of(), programClasses(), "faultline.app.Main", List.of());
    }

    private static List<String> command(
            List<String> options, String classPath, String mainClass, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(executable()));
        command.addAll(options);
        command.addAll(List.of("-cp", classPath, mainClass));
        command.addAll(arguments);
        return command;
    }

    /** Returns the path of the command {@code java}. */
    public static String executable() {
        return Path.of(System.getProperty("java.home"), "bin", "java").toString();
    }

    /** Returns the folder from which the classes of the program are loaded. */
    public static String programClasses() {
        return location(World.class);
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

    /** Starts a class for long with a heap of at most a size, such as {@code 512m}; errors are part of the output. */
    public static Process startWithHeap(String size, String mainClass, List<String> arguments) throws IOException {
        return new ProcessBuilder(command(List.of("-Xmx" + size), classPath(), mainClass, arguments))
                .redirectErrorStream(true)
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
