package faultline.gui.document;

import faultline.scenario.AtomicFile;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A folder where each running window keeps its unsaved scenario under its process's number and beginning, because numbers are given out
 * again; what is there of a process that is gone was left by a crash. All of it is slow, and for other threads than the event dispatch
 * thread.
 */
public final class Recovery {

    private static final String SCENARIO = ".xml";
    private static final String ORIGIN = ".origin";
    private static final Pattern KEPT = Pattern.compile("(\\d+)-(\\d+)\\.xml");
    /** When a process began is known to about a second; a clock that is set changes it by more. */
    private static final Duration SLACK = Duration.ofMinutes(1);

    private final Path folder;
    private final String process;

    /**
     * Unsaved edits that a crash has left.
     *
     * @param kept where they are kept now
     * @param origin the file that was edited, empty for a scenario without one
     * @param scenario as it was
     */
    public record Rescue(Path kept, Optional<Path> origin, Scenario scenario) {
    }

    /** For a process of a number that began at a time. */
    Recovery(Path folder, long number, Instant begun) {
        this.folder = folder;
        this.process = number + "-" + begun.toEpochMilli();
    }

    /** For this process. */
    Recovery(Path folder) {
        this(folder, ProcessHandle.current().pid(), begun(ProcessHandle.current()).orElse(Instant.EPOCH));
    }

    private static Optional<Instant> begun(ProcessHandle process) {
        return process.info().startInstant();
    }

    /**
     * The recovery of this process in the user's home.
     *
     * @return nothing is written yet
     */
    public static Recovery ofUser() {
        return new Recovery(Path.of(System.getProperty("user.home"), ".faultline", "recovery"));
    }

    void keep(Optional<Path> origin, Scenario scenario) throws IOException {
        Files.createDirectories(folder);
        write(folder.resolve(process + ORIGIN), origin.map(file -> file.toAbsolutePath().toString()).orElse("").getBytes(StandardCharsets.UTF_8));
        write(own(), scenario.toBytes());
    }

    private static void write(Path file, byte[] bytes) throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(bytes);
            out.commit();
        }
    }

    /** Keeps what was left by another process as this one's own from now on. */
    void adopt(Rescue rescue) throws IOException {
        keep(rescue.origin(), rescue.scenario());
        forget(rescue.kept());
    }

    /** Nothing is unsaved any more. */
    void forget() throws IOException {
        forget(own());
    }

    private Path own() {
        return folder.resolve(process + SCENARIO);
    }

    /**
     * Takes away what was left.
     *
     * @param kept where
     * @throws IOException if it cannot be taken away
     */
    public void forget(Path kept) throws IOException {
        Files.deleteIfExists(kept);
        Files.deleteIfExists(origin(kept));
    }

    private static Path origin(Path kept) {
        return kept.resolveSibling(kept.getFileName().toString().replace(SCENARIO, ORIGIN));
    }

    /**
     * What a process that is gone has left.
     *
     * @return empty where there is nothing, or nothing that can be read
     * @throws IOException if the folder cannot be looked at
     */
    public Optional<Rescue> left() throws IOException {
        if (Files.notExists(folder)) {
            return Optional.empty();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(Recovery::isOrphan).sorted().flatMap(file -> rescue(file).stream()).findFirst();
        }
    }

    /** Whether it was kept by a process that is gone, even where another has its number by now. */
    private static boolean isOrphan(Path file) {
        Matcher name = KEPT.matcher(file.getFileName().toString());
        return name.matches() && ProcessHandle.of(Long.parseLong(name.group(1))).filter(alive -> isBegun(alive, Long.parseLong(name.group(2)))).isEmpty();
    }

    /** Whether a process began at a time; where nobody knows when it did, it may have. */
    private static boolean isBegun(ProcessHandle process, long epochMillis) {
        return begun(process).map(begun -> Duration.between(begun, Instant.ofEpochMilli(epochMillis)).abs().compareTo(SLACK) < 0).orElse(true);
    }

    private static Optional<Rescue> rescue(Path kept) {
        try {
            String origin = Files.readString(origin(kept));
            return Optional.of(new Rescue(kept, origin.isEmpty() ? Optional.empty() : Optional.of(Path.of(origin)), Scenario.load(kept)));
        } catch (IOException | ScenarioException unreadable) {
            return Optional.empty();
        }
    }
}
