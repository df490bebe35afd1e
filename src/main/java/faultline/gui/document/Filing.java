package faultline.gui.document;

import faultline.engine.Journal;
import faultline.scenario.Remarks;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/** Brings scenarios from their files to the bench, and back. */
public final class Filing {

    private final Bench bench;

    /**
     * For a bench.
     *
     * @param bench where scenarios are opened
     */
    public Filing(Bench bench) {
        this.bench = bench;
    }

    /**
     * Reads a file and begins a session of it, soon.
     *
     * @param file the scenario file
     */
    public void open(Path file) {
        bench.begin(Task.OPEN, file, way -> {
            Scenario scenario = Scenario.load(file);
            way.throwIfCancelled();
            return Work.begin(Document.begin(Optional.of(file), Optional.of(scenario), scenario));
        });
    }

    /**
     * Begins a session of a scenario that ships with the program, soon.
     *
     * @param name its file's name
     */
    public void openShipped(String name) {
        bench.begin(Task.OPEN, Path.of(name), way -> {
            Scenario scenario = Scenario.shipped(name);
            return Work.begin(Document.begin(Optional.empty(), Optional.of(scenario), scenario));
        });
    }

    /** Begins anew, soon, with the scenario as its file holds it; edits are given up. */
    public void revert() {
        bench.work().map(Work::document).ifPresent(now -> now.file().ifPresentOrElse(this::open, () -> now.saved().ifPresent(
                saved -> bench.begin(Task.OPEN, now.name(), way -> Work.begin(Document.begin(Optional.empty(), now.saved(), saved))))));
    }

    /**
     * Begins a session of edits that a crash has left, soon; they are unsaved still.
     *
     * @param rescue what was left
     */
    public void recover(Recovery.Rescue rescue) {
        Path name = rescue.origin().orElse(rescue.kept());
        bench.begin(Task.OPEN, name, way -> Work.begin(Document.begin(rescue.origin(), rescue.origin().flatMap(Filing::held), rescue.scenario())));
    }

    /** What a file holds now; empty where it cannot be read. */
    private static Optional<Scenario> held(Path file) {
        try {
            return Optional.of(Scenario.load(file));
        } catch (ScenarioException gone) {
            return Optional.empty();
        }
    }

    /**
     * Writes the scenario as it is edited by now, soon, with the comments of the file that it came from.
     *
     * @param file where to
     * @param then done when it is written, and only then
     */
    public void save(Path file, Runnable then) {
        bench.work().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().wholeJournal();
            Background.finish(() -> {
                Scenario scenario = now.document().after(journal.join());
                scenario.save(file, now.document().file().map(Remarks::of).orElse(Remarks.NONE));
                return scenario;
            }, scenario -> {
                noteSaved(now, file, scenario, EditedSetup.keepsAll(journal.join()));
                then.run();
            }, why -> bench.listener().failed(Task.SAVE, file, why));
        });
    }

    /** The scenario is in its file as it was before; what was edited while it was written is unsaved. */
    void noteSaved(Work before, Path file, Scenario scenario, boolean whole) {
        bench.change(before, document -> {
            Document saved = document.savedAs(file, scenario);
            return document.edited().equals(before.document().edited()) ? saved.withEdited(scenario) : saved;
        });
        bench.listener().saved(file, whole);
        bench.listener().renamed();
    }

    /**
     * Writes a scenario that replays what was done in this run, soon.
     *
     * @param file where to
     */
    public void saveJournal(Path file) {
        bench.replay().ifPresent(replay -> Background.finish(() -> {
            replay.join().save(file);
            return file;
        }, bench.listener()::journalSaved, why -> bench.listener().failed(Task.SAVE_JOURNAL, file, why)));
    }
}
