package faultline.gui.document;

import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.Timer;

/**
 * Notices when somebody else changes the open file. The file is looked at off the event dispatch thread; a change is
 * told once it has rested from one look to the next, so that half a file is never taken for a whole one, and only where
 * the file now holds another scenario or none.
 */
public final class FileWatch implements AutoCloseable {

    private static final int PERIOD_MILLIS = 2000;

    private final Workspace workspace;
    private final Consumer<Path> changed;
    private final Consumer<ScenarioException> broken;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> poll());
    private Optional<FileVersion> lastRead = Optional.empty();
    private Optional<FileVersion> lastSeen = Optional.empty();
    private boolean polling;

    /** What tells two versions of a file apart without reading them. */
    private record FileVersion(Path file, FileTime modified, long size) {}

    /**
     * What a look has found; where the file was worth reading, either the scenario or what is wrong with it is there.
     */
    private record PollResult(FileVersion version, Optional<Scenario> scenario, Optional<ScenarioException> failure) {}

    /**
     * Begins to watch the open file, whichever it is.
     *
     * @param bench where it is open
     * @param changed told that it holds another scenario, on the event dispatch thread
     * @param broken told that it can no longer be read, on the event dispatch thread
     */
    public FileWatch(Workspace bench, Consumer<Path> changed, Consumer<ScenarioException> broken) {
        assert EventQueue.isDispatchThread();
        this.workspace = bench;
        this.changed = changed;
        this.broken = broken;
        timer.start();
    }

    /** Looks at the file, soon. */
    void poll() {
        if (!polling && workspace.file().isPresent()) {
            polling = true;
            Path file = workspace.file().get();
            Optional<FileVersion> before = lastSeen;
            Optional<FileVersion> known = lastRead;
            BackgroundTasks.run(() -> inspect(file, before, known), this::inspected, gone -> polling = false);
        }
    }

    /** Whether a look is not over yet. */
    boolean isPolling() {
        return polling;
    }

    private static PollResult inspect(Path file, Optional<FileVersion> before, Optional<FileVersion> known)
            throws IOException {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        Optional<FileVersion> now =
                Optional.of(new FileVersion(file, attributes.lastModifiedTime(), attributes.size()));
        boolean worthReading = now.equals(before) && !now.equals(known);
        return worthReading ? read(file, now.get()) : new PollResult(now.get(), Optional.empty(), Optional.empty());
    }

    private static PollResult read(Path file, FileVersion stamp) {
        try {
            return new PollResult(stamp, Optional.of(Scenario.load(file)), Optional.empty());
        } catch (ScenarioException wrong) {
            return new PollResult(stamp, Optional.empty(), Optional.of(wrong));
        }
    }

    private void inspected(PollResult sight) {
        polling = false;
        lastSeen = Optional.of(sight.version());
        if (workspace.file().equals(Optional.of(sight.version().file()))) {
            sight.scenario().ifPresent(this::scenarioFound);
            sight.failure().ifPresent(this::fileBroken);
        }
    }

    private void scenarioFound(Scenario found) {
        lastRead = lastSeen;
        if (!workspace.savedScenario().equals(Optional.of(found))) {
            if (!workspace.scenario().equals(Optional.of(found))) {
                changed.accept(lastSeen.orElseThrow().file());
            }
            workspace.setSavedScenario(Optional.of(found));
        }
    }

    private void fileBroken(ScenarioException wrong) {
        lastRead = lastSeen;
        workspace.setSavedScenario(Optional.empty());
        broken.accept(wrong);
    }

    @Override
    public void close() {
        timer.stop();
    }
}
