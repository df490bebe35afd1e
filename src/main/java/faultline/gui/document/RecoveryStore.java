package faultline.gui.document;

import faultline.io.AtomicFile;
import faultline.io.FilePermissions;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A folder in which each process saves its unsaved scenario. Its files are named by process id and start time, because
 * process ids are reused; a file of a process that no longer runs was left by a crash. Safe on any thread; methods
 * block and must not be called on the event dispatch thread.
 */
public final class RecoveryStore {

    private static final Path HOME_FOLDER = Path.of(".faultline");
    private static final String SCENARIO_SUFFIX = ".xml";
    private static final String ORIGIN_SUFFIX = ".origin";
    private static final String BASE_SUFFIX = ".base";
    private static final String LOCK_SUFFIX = ".lock";
    private static final Pattern FILE_NAME = Pattern.compile("(\\d+)-(\\d+)\\.xml");
    /** The start time of a process is known to about a second; setting the clock changes it by more. */
    private static final Duration START_TOLERANCE = Duration.ofMinutes(1);

    private final Path folder;
    private final String process;
    /** Whether a lock shows that this store is in use; those of other processes have other ids. */
    private final boolean locking;

    /** Null while this process has no edits; used by one thread at a time. */
    private FileChannel lock;

    /** Locked while this process offers the edits of another one, so that no other window does; null otherwise. */
    private FileChannel claim;

    /**
     * Unsaved edits that a crash has left: the file that holds them, and when it was written; the file that was edited,
     * null for a scenario without a file; the scenario that was edited, null if it is not known; and the edited
     * scenario.
     */
    public record RecoveredFile(Path recoveryFile, Instant written, Path originFile, Scenario base, Scenario scenario) {

        /** Returns the name of the file that was edited, or that of a scenario without a file. */
        public String name() {
            return origin().map(FileNames::lastOf).orElse(scenario.name());
        }

        /** Returns the file that was edited; empty for a scenario without a file. */
        public Optional<Path> origin() {
            return Optional.ofNullable(originFile);
        }
    }

    /** Creates the store of a process with an id and a start time, which does not show that it is in use. */
    RecoveryStore(Path folder, long id, Instant start) {
        this(folder, id, start, false);
    }

    private RecoveryStore(Path folder, long id, Instant start, boolean locking) {
        this.folder = folder;
        this.process = id + "-" + start.toEpochMilli();
        this.locking = locking;
    }

    /** Creates the store of this process. */
    RecoveryStore(Path folder) {
        this(
                folder,
                ProcessHandle.current().pid(),
                startTime(ProcessHandle.current()).orElse(Instant.EPOCH),
                true);
    }

    private static Optional<Instant> startTime(ProcessHandle process) {
        return process.info().startInstant();
    }

    /** Returns the store of this process in the user's home directory. */
    public static RecoveryStore forCurrentUser() {
        return new RecoveryStore(
                Path.of(System.getProperty("user.home")).resolve(HOME_FOLDER).resolve("recovery"));
    }

    /**
     * Saves unsaved edits.
     *
     * @param origin the edited file, null for a scenario without a file
     * @param base what a save may replace in the file without a question, null for nothing
     * @param scenario the edited scenario
     */
    synchronized void save(Path origin, Scenario base, Scenario scenario) throws IOException {
        createPrivateFolder();
        acquireLock();
        AtomicFile.writeSecret(sibling(ownFile(), BASE_SUFFIX), base == null ? new byte[0] : base.toBytes());
        AtomicFile.writeSecret(
                folder.resolve(process + ORIGIN_SUFFIX),
                (origin == null ? "" : origin.toAbsolutePath().toString()).getBytes(StandardCharsets.UTF_8));
        AtomicFile.writeSecret(ownFile(), scenario.toBytes());
    }

    /** Creates the folder, which only its owner may look into. */
    private void createPrivateFolder() throws IOException {
        Files.createDirectories(folder);
        Set<PosixFilePermission> ownerOnly = PosixFilePermissions.fromString("rwx------");
        FilePermissions.setIfPossible(folder, ownerOnly);
        if (folder.endsWith(HOME_FOLDER.resolve("recovery"))) {
            FilePermissions.setIfPossible(folder.getParent(), ownerOnly);
        }
    }

    /**
     * Shows every process that uses the folder, also those of other containers and machines, that this one is running.
     * Where files cannot be locked, there is no lock file, and the id of the process shows it to those of this machine.
     * A lock is tried only before the edits are first saved: with a lock that fails later, they would look abandoned.
     */
    private void acquireLock() throws IOException {
        if (!locking || lock != null || Files.exists(ownFile())) {
            return;
        }
        Path lockFile = folder.resolve(process + LOCK_SUFFIX);
        FileChannel opened = FileChannel.open(lockFile, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try {
            opened.tryLock();
            lock = opened;
        } catch (IOException unsupported) {
            opened.close();
            Files.delete(lockFile);
        }
    }

    /** Saves the edits of another process as those of this one. */
    synchronized void adopt(RecoveredFile recovered) throws IOException {
        save(recovered.originFile(), recovered.base(), recovered.scenario());
        discard(recovered);
    }

    /** Deletes the edits of another process. */
    synchronized void discard(RecoveredFile recovered) throws IOException {
        delete(recovered.recoveryFile());
        release();
    }

    /** Lets other windows offer the edits that were found last. */
    synchronized void release() throws IOException {
        if (claim != null) {
            claim.close();
            claim = null;
        }
    }

    /** Deletes the edits of this process. */
    synchronized void delete() throws IOException {
        delete(ownFile());
        if (lock != null) {
            lock.close();
            lock = null;
        }
    }

    private Path ownFile() {
        return folder.resolve(process + SCENARIO_SUFFIX);
    }

    private static void delete(Path recoveryFile) throws IOException {
        Files.deleteIfExists(recoveryFile);
        Files.deleteIfExists(originFile(recoveryFile));
        Files.deleteIfExists(sibling(recoveryFile, BASE_SUFFIX));
        Files.deleteIfExists(sibling(recoveryFile, LOCK_SUFFIX));
    }

    private static Path originFile(Path recoveryFile) {
        return sibling(recoveryFile, ORIGIN_SUFFIX);
    }

    private static Path sibling(Path recoveryFile, String suffix) {
        return recoveryFile.resolveSibling(recoveryFile.getFileName().toString().replace(SCENARIO_SUFFIX, suffix));
    }

    /**
     * Returns the edits of a process that no longer runs, but not those of files that were found before; empty if there
     * are none that can be read. Until they are adopted, discarded or released, no other process finds them.
     */
    synchronized Optional<RecoveredFile> findOrphan(Set<Path> foundBefore) throws IOException {
        release();
        for (Path file : orphans()) {
            if (foundBefore.contains(file)) {
                continue;
            }
            Optional<RecoveredFile> found = claim(file) ? loadRecovered(file) : Optional.empty();
            if (found.isPresent()) {
                return found;
            }
            release();
            if (Files.notExists(file)) {
                // Another process has just adopted the edits; only the lock of this one is left.
                delete(file);
            }
        }
        return Optional.empty();
    }

    /** Returns the edits of all processes that no longer run, so far as they can be read; others may find them, too. */
    List<RecoveredFile> orphanedEdits() throws IOException {
        return orphans().stream()
                .map(RecoveryStore::loadRecovered)
                .flatMap(Optional::stream)
                .toList();
    }

    private List<Path> orphans() throws IOException {
        if (Files.notExists(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> !(locking && file.equals(ownFile())))
                    .filter(RecoveryStore::isOrphan)
                    .sorted()
                    .toList();
        }
    }

    /** Locks the edits of a process that no longer runs; returns false if another process has done so. */
    private boolean claim(Path file) {
        if (!locking) {
            return true;
        }
        try {
            claim = FileChannel.open(sibling(file, LOCK_SUFFIX), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
            return claim.tryLock() != null;
        } catch (OverlappingFileLockException e) {
            return false;
        } catch (IOException e) {
            // Where files cannot be locked, several windows may offer the same edits.
            return true;
        }
    }

    /** Returns whether a file is that of a process that no longer runs, even if its id has been reused. */
    private static boolean isOrphan(Path file) {
        Matcher name = FILE_NAME.matcher(file.getFileName().toString());
        if (!name.matches()) {
            return false;
        }
        Path lockFile = sibling(file, LOCK_SUFFIX);
        if (Files.exists(lockFile)) {
            return !isLocked(lockFile);
        }
        // It was written where files cannot be locked, or by an earlier version, which did not lock files.
        return ProcessHandle.of(Long.parseLong(name.group(1)))
                .filter(alive -> hasStartTime(alive, Long.parseLong(name.group(2))))
                .isEmpty();
    }

    private static boolean isLocked(Path lockFile) {
        try (FileChannel channel = FileChannel.open(lockFile, StandardOpenOption.WRITE);
                FileLock free = channel.tryLock()) {
            return free == null;
        } catch (OverlappingFileLockException e) {
            return true;
        } catch (IOException e) {
            // No other process could read it either.
            return false;
        }
    }

    /** Returns whether a process started at a time, or its start time is unknown. */
    private static boolean hasStartTime(ProcessHandle process, long epochMillis) {
        return startTime(process)
                .map(start -> Duration.between(start, Instant.ofEpochMilli(epochMillis))
                                .abs()
                                .compareTo(START_TOLERANCE)
                        < 0)
                .orElse(true);
    }

    private static Optional<RecoveredFile> loadRecovered(Path file) {
        try {
            Scenario edited = Scenario.load(file);
            Path origin = readOrigin(originFile(file)).orElse(null);
            Path base = sibling(file, BASE_SUFFIX);
            // Earlier versions did not keep what the file held.
            return Optional.of(new RecoveredFile(
                    file,
                    Files.getLastModifiedTime(file).toInstant(),
                    origin,
                    loadIfReadable(Files.exists(base) ? base : origin),
                    edited));
        } catch (ScenarioException | IOException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns the scenario of a file, null if there is none. */
    private static Scenario loadIfReadable(Path file) {
        try {
            return file == null ? null : Scenario.load(file);
        } catch (ScenarioException unreadable) {
            return null;
        }
    }

    /** Returns the file that was edited; empty if there was none or its name cannot be read. */
    private static Optional<Path> readOrigin(Path originFile) {
        try {
            String origin = Files.readString(originFile);
            return origin.isEmpty() ? Optional.empty() : Optional.of(Path.of(origin));
        } catch (IOException | InvalidPathException e) {
            return Optional.empty();
        }
    }
}
