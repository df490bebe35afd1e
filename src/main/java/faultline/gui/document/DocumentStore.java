package faultline.gui.document;

import faultline.engine.Journal;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/** Brings scenarios from their files to the bench, and back. */
public final class DocumentStore {

    private final Workspace workspace;

    /**
     * For a bench.
     *
     * @param bench where scenarios are opened
     */
    public DocumentStore(Workspace bench) {
        this.workspace = bench;
    }

    /**
     * Reads a file and begins a session of it, soon.
     *
     * @param file the scenario file
     */
    public void open(Path file) {
        workspace.startTask(TaskKind.OPEN, file, way -> {
            Scenario scenario = Scenario.load(file);
            way.throwIfCancelled();
            return OpenDocument.create(ScenarioDocument.create(Optional.of(file), Optional.of(scenario), scenario));
        });
    }

    /**
     * Begins a session of a scenario that ships with the program, soon.
     *
     * @param name its file's name
     */
    public void openShipped(String name) {
        workspace.startTask(TaskKind.OPEN, Path.of(name), way -> {
            Scenario scenario = Scenario.loadShipped(name);
            return OpenDocument.create(ScenarioDocument.create(Optional.empty(), Optional.of(scenario), scenario));
        });
    }

    /** Begins anew, soon, with the scenario as its file holds it; edits are given up. */
    public void revert() {
        workspace.openDocument().map(OpenDocument::document).ifPresent(now -> now.file()
                .ifPresentOrElse(this::open, () -> now.saved()
                        .ifPresent(saved -> workspace.startTask(
                                TaskKind.OPEN,
                                now.displayPath(),
                                way -> OpenDocument.create(
                                        ScenarioDocument.create(Optional.empty(), now.saved(), saved))))));
    }

    /**
     * Begins a session of edits that a crash has left, soon; they are unsaved still.
     *
     * @param rescue what was left
     */
    public void recover(RecoveryStore.RecoveredFile rescue) {
        Path name = rescue.origin().orElse(rescue.recoveryFile());
        workspace.startTask(
                TaskKind.OPEN,
                name,
                way -> OpenDocument.create(ScenarioDocument.create(
                        rescue.origin(), rescue.origin().flatMap(DocumentStore::loadIfReadable), rescue.scenario())));
    }

    /** What a file holds now; empty where it cannot be read. */
    private static Optional<Scenario> loadIfReadable(Path file) {
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
        workspace.openDocument().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().fullJournal();
            BackgroundTasks.runBeforeExit(
                    () -> {
                        Scenario scenario = now.document().editedBy(journal.join());
                        scenario.save(
                                file,
                                now.document().file().map(XmlComments::read).orElse(XmlComments.NONE));
                        return scenario;
                    },
                    scenario -> {
                        markSaved(now, file, scenario, SetupEditor.coversAll(journal.join()));
                        then.run();
                    },
                    why -> workspace.listener().taskFailed(TaskKind.SAVE, file, why));
        });
    }

    /** The scenario is in its file as it was before; what was edited while it was written is unsaved. */
    void markSaved(OpenDocument before, Path file, Scenario scenario, boolean whole) {
        workspace.updateDocument(before, document -> {
            ScenarioDocument saved = document.savedAs(file, scenario);
            return document.edited().equals(before.document().edited()) ? saved.withEdited(scenario) : saved;
        });
        workspace.listener().scenarioSaved(file, whole);
        workspace.listener().titleChanged();
    }

    /**
     * Writes a scenario that replays what was done in this run, soon.
     *
     * @param file where to
     */
    public void saveJournal(Path file) {
        workspace
                .replayScenario()
                .ifPresent(replay -> BackgroundTasks.runBeforeExit(
                        () -> {
                            replay.join().save(file);
                            return file;
                        },
                        workspace.listener()::journalSaved,
                        why -> workspace.listener().taskFailed(TaskKind.SAVE_JOURNAL, file, why)));
    }
}
