package faultline.gui.document;

import faultline.io.AtomicFile;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
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
 * A folder where each running window keeps its unsaved scenario under its process's number and beginning, because
 * numbers are given out again; what is there of a process that is gone was left by a crash. All of it is slow, and for
 * other threads than the event dispatch thread.
 */
public final class RecoveryStore {

    private static final String SCENARIO_SUFFIX = ".xml";
    private static final String ORIGIN_SUFFIX = ".origin";
    private static final Pattern FILE_NAME = Pattern.compile("(\\d+)-(\\d+)\\.xml");
    /** When a process began is known to about a second; a clock that is set changes it by more. */
    private static final Duration START_TOLERANCE = Duration.ofMinutes(1);

    private final Path folder;
    private final String process;

    /**
     * Unsaved edits that a crash has left.
     *
     * @param recoveryFile where they are kept now
     * @param origin the file that was edited, empty for a scenario without one
     * @param scenario as it was
     */
    public record RecoveredFile(Path recoveryFile, Optional<Path> origin, Scenario scenario) {}

    /** For a process of a number that began at a time. */
    RecoveryStore(Path folder, long number, Instant begun) {
        this.folder = folder;
        this.process = number + "-" + begun.toEpochMilli();
    }

    /** For this process. */
    RecoveryStore(Path folder) {
        this(
                folder,
                ProcessHandle.current().pid(),
                startTime(ProcessHandle.current()).orElse(Instant.EPOCH));
    }

    private static Optional<Instant> startTime(ProcessHandle process) {
        return process.info().startInstant();
    }

    /**
     * The recovery of this process in the user's home.
     *
     * @return nothing is written yet
     */
    public static RecoveryStore forCurrentUser() {
        return new RecoveryStore(Path.of(System.getProperty("user.home"), ".faultline", "recovery"));
    }

    void save(Optional<Path> origin, Scenario scenario) throws IOException {
        Files.createDirectories(folder);
        write(
                folder.resolve(process + ORIGIN_SUFFIX),
                origin.map(file -> file.toAbsolutePath().toString()).orElse("").getBytes(StandardCharsets.UTF_8));
        write(ownFile(), scenario.toBytes());
    }

    private static void write(Path file, byte[] bytes) throws IOException {
        try (AtomicFile out = AtomicFile.create(file)) {
            out.stream().write(bytes);
            out.commit();
        }
    }

    /** Keeps what was left by another process as this one's own from now on. */
    void adopt(RecoveredFile rescue) throws IOException {
        save(rescue.origin(), rescue.scenario());
        delete(rescue.recoveryFile());
    }

    /** Nothing is unsaved any more. */
    void delete() throws IOException {
        delete(ownFile());
    }

    private Path ownFile() {
        return folder.resolve(process + SCENARIO_SUFFIX);
    }

    /**
     * Takes away what was left.
     *
     * @param kept where
     * @throws IOException if it cannot be taken away
     */
    public void delete(Path kept) throws IOException {
        Files.deleteIfExists(kept);
        Files.deleteIfExists(originFile(kept));
    }

    private static Path originFile(Path kept) {
        return kept.resolveSibling(kept.getFileName().toString().replace(SCENARIO_SUFFIX, ORIGIN_SUFFIX));
    }

    /**
     * What a process that is gone has left.
     *
     * @return empty where there is nothing, or nothing that can be read
     * @throws IOException if the folder cannot be looked at
     */
    public Optional<RecoveredFile> findOrphan() throws IOException {
        if (Files.notExists(folder)) {
            return Optional.empty();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(RecoveryStore::isOrphan)
                    .sorted()
                    .flatMap(file -> loadRecovered(file).stream())
                    .findFirst();
        }
    }

    /** Whether it was kept by a process that is gone, even where another has its number by now. */
    private static boolean isOrphan(Path file) {
        Matcher name = FILE_NAME.matcher(file.getFileName().toString());
        return name.matches()
                && ProcessHandle.of(Long.parseLong(name.group(1)))
                        .filter(alive -> hasStartTime(alive, Long.parseLong(name.group(2))))
                        .isEmpty();
    }

    /** Whether a process began at a time; where nobody knows when it did, it may have. */
    private static boolean hasStartTime(ProcessHandle process, long epochMillis) {
        return startTime(process)
                .map(begun -> Duration.between(begun, Instant.ofEpochMilli(epochMillis))
                                .abs()
                                .compareTo(START_TOLERANCE)
                        < 0)
                .orElse(true);
    }

    private static Optional<RecoveredFile> loadRecovered(Path kept) {
        try {
            String origin = Files.readString(originFile(kept));
            return Optional.of(new RecoveredFile(
                    kept, origin.isEmpty() ? Optional.empty() : Optional.of(Path.of(origin)), Scenario.load(kept)));
        } catch (IOException | ScenarioException unreadable) {
            return Optional.empty();
        }
    }
}
