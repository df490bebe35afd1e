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
 * rested from one look to the next, so that half a file is never taken for a whole one, and only where the file now holds another scenario
 * or none.
 */
public final class FileWatch implements AutoCloseable {

    private static final int PERIOD_MILLIS = 2000;

    private final Bench bench;
    private final Consumer<Path> changed;
    private final Consumer<ScenarioException> broken;
    private final Timer timer = new Timer(PERIOD_MILLIS, event -> look());
    private Optional<Stamp> settled = Optional.empty();
    private Optional<Stamp> last = Optional.empty();
    private boolean looking;

    /** What tells two versions of a file apart without reading them. */
    private record Stamp(Path file, FileTime modified, long size) {
    }

    /** What a look has found; where the file was worth reading, either the scenario or what is wrong with it is there. */
    private record Sight(Stamp stamp, Optional<Scenario> scenario, Optional<ScenarioException> complaint) {
    }

    /**
     * Begins to watch the open file, whichever it is.
     *
     * @param bench where it is open
     * @param changed told that it holds another scenario, on the event dispatch thread
     * @param broken told that it can no longer be read, on the event dispatch thread
     */
    public FileWatch(Bench bench, Consumer<Path> changed, Consumer<ScenarioException> broken) {
        assert EventQueue.isDispatchThread();
        this.bench = bench;
        this.changed = changed;
        this.broken = broken;
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
        return worthReading ? read(file, now.get()) : new Sight(now.get(), Optional.empty(), Optional.empty());
    }

    private static Sight read(Path file, Stamp stamp) {
        try {
            return new Sight(stamp, Optional.of(Scenario.load(file)), Optional.empty());
        } catch (ScenarioException wrong) {
            return new Sight(stamp, Optional.empty(), Optional.of(wrong));
        }
    }

    private void seen(Sight sight) {
        looking = false;
        last = Optional.of(sight.stamp());
        if (bench.file().equals(Optional.of(sight.stamp().file()))) {
            sight.scenario().ifPresent(this::holds);
            sight.complaint().ifPresent(this::isBroken);
        }
    }

    private void holds(Scenario found) {
        settled = last;
        if (!bench.saved().equals(Optional.of(found))) {
            if (!bench.scenario().equals(Optional.of(found))) {
                changed.accept(last.orElseThrow().file());
            }
            bench.fileHolds(Optional.of(found));
        }
    }

    private void isBroken(ScenarioException wrong) {
        settled = last;
        bench.fileHolds(Optional.empty());
        broken.accept(wrong);
    }

    @Override
    public void close() {
        timer.stop();
    }
}
