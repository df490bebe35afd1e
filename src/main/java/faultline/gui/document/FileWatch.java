package faultline.gui.document;

import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
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
 * Notices when somebody else changes the open file. The file is looked at off the event dispatch thread; a change is told once it has
 * rested from one look to the next, so that half a file is never taken for a whole one, and only where the file now holds another scenario.
 */
public final class FileWatch implements AutoCloseable {

    private static final int PERIOD_MILLIS = 2000;

    private final Bench bench;
    private final Consumer<Path> changed;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> look());
    private Optional<Stamp> settled = Optional.empty();
    private Optional<Stamp> last = Optional.empty();
    private boolean looking;

    /** What tells two versions of a file apart without reading them. */
    private record Stamp(Path file, FileTime modified, long size) {
    }

    /** What a look has found; the scenario is there where it was worth reading. */
    private record Sight(Stamp stamp, Optional<Scenario> scenario) {
    }

    /**
     * Begins to watch the open file, whichever it is.
     *
     * @param bench where it is open
     * @param changed told of it, on the event dispatch thread
     */
    public FileWatch(Bench bench, Consumer<Path> changed) {
        assert EventQueue.isDispatchThread();
        this.bench = bench;
        this.changed = changed;
        timer.start();
    }

    /** Looks at the file, soon. */
    void look() {
        if (!looking && bench.file().isPresent()) {
            looking = true;
            Path file = bench.file().get();
            Optional<Stamp> before = last;
            Optional<Stamp> known = settled;
            Background.run(() -> see(file, before, known), this::seen, gone -> looking = false);
        }
    }

    /** Whether a look is not over yet. */
    boolean isLooking() {
        return looking;
    }

    private static Sight see(Path file, Optional<Stamp> before, Optional<Stamp> known) throws IOException {
        BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
        Optional<Stamp> now = Optional.of(new Stamp(file, attributes.lastModifiedTime(), attributes.size()));
        boolean worthReading = now.equals(before) && !now.equals(known);
        return new Sight(now.get(), worthReading ? read(file) : Optional.empty());
    }

    private static Optional<Scenario> read(Path file) {
        try {
            return Optional.of(Scenario.load(file));
        } catch (ScenarioException broken) {
            // Somebody is still at work on it.
            return Optional.empty();
        }
    }

    private void seen(Sight sight) {
        looking = false;
        last = Optional.of(sight.stamp());
        sight.scenario().filter(found -> bench.file().equals(Optional.of(sight.stamp().file()))).ifPresent(found -> {
            settled = last;
            if (!bench.saved().equals(Optional.of(found))) {
                changed.accept(sight.stamp().file());
                bench.fileHolds(found);
            }
        });
    }

    @Override
    public void close() {
        timer.stop();
    }
}
