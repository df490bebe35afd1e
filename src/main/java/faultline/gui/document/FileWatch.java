package faultline.gui.document;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.Timer;

/**
 * Notices changes of the open file by other programs. The file is polled on a background thread. It is read when it has
 * not changed between two polls, so that a half-written file is not read, and reported if it holds another scenario
 * than before, or none, or no longer exists.
 */
public final class FileWatch implements AutoCloseable {

    private static final int PERIOD_MILLIS = 2000;

    private final Workspace workspace;
    private final Predicate<Path> onChanged;
    private final Consumer<ScenarioException> onBroken;
    private final Consumer<Path> onDeleted;
    /** Whether nothing can be asked now. */
    private final BooleanSupplier busy;

    private final Timer timer = new Timer(PERIOD_MILLIS, event -> poll());
    /** Null before the file is read. */
    private FileVersion lastRead;
    /** Null before the first poll. */
    private FileVersion lastSeen;

    private final BackgroundPoll poll = new BackgroundPoll();

    /** A version of a file, as far as it is known without reading the file; the time is null if there is no file. */
    private record FileVersion(Path file, FileTime modified, long size) {}

    /** The result of a poll: the scenario or the failure is null, or both are if the file was not read. */
    private record PollResult(FileVersion version, Scenario scenario, ScenarioException failure) {}

    /**
     * Starts to watch the open file of a workspace. On the event dispatch thread, {@code onChanged} is called with the
     * file if it holds another scenario, and returns whether a save may replace it; {@code onBroken} is called if it
     * can no longer be read, and {@code onDeleted} with the file if it no longer exists. While a modal dialog is open,
     * which may show values of the scenario, or another scenario is being opened, nothing is reported.
     */
    public FileWatch(
            Workspace workspace,
            Predicate<Path> onChanged,
            Consumer<ScenarioException> onBroken,
            Consumer<Path> onDeleted) {
        this(workspace, ModalDialogs::isAnyOpen, onChanged, onBroken, onDeleted);
    }

    /** Starts to watch the open file; nothing is reported while {@code busy} returns true. */
    FileWatch(
            Workspace workspace,
            BooleanSupplier busy,
            Predicate<Path> onChanged,
            Consumer<ScenarioException> onBroken,
            Consumer<Path> onDeleted) {
        assert EventQueue.isDispatchThread();
        this.workspace = workspace;
        this.busy = busy;
        this.onChanged = onChanged;
        this.onBroken = onBroken;
        this.onDeleted = onDeleted;
        timer.start();
    }

    /** Polls the file, asynchronously. */
    void poll() {
        Optional<Path> file = workspace.file();
        if (file.isPresent()) {
            FileVersion seen = lastSeen;
            FileVersion read = lastRead;
            Scenario saved = workspace.savedScenario().orElse(null);
            poll.compute(
                    () -> inspect(file.get(), seen, read),
                    result -> end(saved, () -> inspected(result)),
                    unreadable -> end(saved, () -> notInspected(file.get(), unreadable)));
        }
    }

    /** Returns whether a poll is active. */
    boolean isPolling() {
        return poll.isActive();
    }

    private static PollResult inspect(Path file, FileVersion seen, FileVersion read) throws IOException {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        FileVersion now = new FileVersion(file, attributes.lastModifiedTime(), attributes.size());
        if (!now.equals(seen) || now.equals(read)) {
            return new PollResult(now, null, null);
        }
        try {
            return new PollResult(now, Scenario.load(file), null);
        } catch (ScenarioException failure) {
            return new PollResult(now, null, failure);
        }
    }

    /**
     * Ends a poll, given what the file held when it began, null for nothing. The result does not count if the file has
     * been saved since then, or while another scenario may be about to open.
     */
    private void end(Scenario savedBefore, Runnable result) {
        if (!busy.getAsBoolean() && workspace.task().isEmpty() && isSaved(savedBefore)) {
            result.run();
        }
    }

    /** Returns whether the open file holds a scenario, as far as is known, null for none. */
    private boolean isSaved(Scenario scenario) {
        return Objects.equals(workspace.savedScenario().orElse(null), scenario);
    }

    private boolean isOpen(Path file) {
        return workspace.file().equals(Optional.of(file));
    }

    private void inspected(PollResult result) {
        lastSeen = result.version();
        if (!isOpen(lastSeen.file())) {
            return;
        }
        if (result.scenario() != null) {
            lastRead = lastSeen;
            scenarioFound(result.scenario());
        } else if (result.failure() != null) {
            lastRead = lastSeen;
            workspace.setSavedScenario(null);
            onBroken.accept(result.failure());
        }
    }

    /** Reports a file that is missing at two polls; programs that replace a file may delete it for a moment. */
    private void notInspected(Path file, Throwable failure) {
        if (failure instanceof NoSuchFileException && isOpen(file)) {
            FileVersion none = new FileVersion(file, null, 0);
            if (none.equals(lastSeen) && !none.equals(lastRead)) {
                lastRead = none;
                workspace.setSavedScenario(null);
                onDeleted.accept(file);
            }
            lastSeen = none;
        }
    }

    private void scenarioFound(Scenario found) {
        if (isSaved(found)) {
            return;
        }
        Path file = lastSeen.file();
        Scenario savedBefore = workspace.savedScenario().orElse(null);
        boolean replaceable = workspace.scenario().equals(Optional.of(found)) || onChanged.test(file);
        // While the question was open, another scenario may have been opened, or this one saved.
        if (isOpen(file) && isSaved(savedBefore)) {
            workspace.setSavedScenario(found);
            if (replaceable) {
                workspace.allowReplacement();
            }
        }
    }

    @Override
    public void close() {
        timer.stop();
    }
}
