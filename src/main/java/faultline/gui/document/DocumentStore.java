package faultline.gui.document;

import faultline.io.LinkResolver;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.XmlComments;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javax.swing.Timer;

/** Loads and saves the scenario of a workspace, asynchronously. */
public final class DocumentStore {

    /** The time after which a save that has not ended is reported. */
    private static final int SLOW_MILLIS = 1000;

    private final Workspace workspace;
    private final WriteQueue writes = new WriteQueue();

    public DocumentStore(Workspace workspace) {
        this.workspace = workspace;
    }

    /** Opens a scenario file. */
    public void open(Path file) {
        open(file, () -> {}, () -> {});
    }

    /**
     * Opens a scenario file; {@code then} runs when it is open, {@code otherwise} if it cannot be opened or the user
     * cancels that.
     */
    public void open(Path file, Runnable then, Runnable otherwise) {
        open(file, () -> Scenario.load(file), then, otherwise);
    }

    /** Opens a scenario file with a given reader. */
    public void open(Path file, Callable<Scenario> reader) {
        open(file, reader, () -> {}, () -> {});
    }

    private void open(Path file, Callable<Scenario> reader, Runnable then, Runnable otherwise) {
        start(
                file,
                () -> {
                    Scenario scenario = reader.call();
                    return new ScenarioDocument(file, scenario, scenario);
                },
                then,
                otherwise);
    }

    /** Opens a scenario that is part of the program, given the name of its file. */
    public void openShipped(String name) {
        start(Path.of(name), () -> {
            Scenario scenario = Scenario.loadShipped(name);
            return new ScenarioDocument(null, scenario, scenario);
        });
    }

    /** Opens a new scenario, which has no file yet. */
    public void create(Scenario scenario) {
        create(scenario, () -> {}, () -> {});
    }

    /**
     * Opens a new scenario, which has no file yet; {@code then} runs when it is open, {@code otherwise} if it cannot be
     * opened or the user cancels that.
     */
    public void create(Scenario scenario, Runnable then, Runnable otherwise) {
        start(
                Path.of(FileNames.forScenario(scenario.name())),
                () -> new ScenarioDocument(null, null, scenario),
                then,
                otherwise);
    }

    /** Opens a generated scenario that has no file; it does not count as changed. {@code then} runs when it is open. */
    public void openGenerated(Scenario scenario, Runnable then) {
        start(
                Path.of(FileNames.forScenario(scenario.name())),
                () -> new ScenarioDocument(null, scenario, scenario),
                then);
    }

    /**
     * Returns the scenario with all edits that have been requested; empty before the first session. The future
     * completes on the event dispatch thread.
     */
    public Optional<CompletableFuture<Scenario>> editedScenario() {
        return workspace.edited();
    }

    /** Opens the scenario that the file holds; edits are discarded. */
    public void revert() {
        workspace
                .file()
                .ifPresentOrElse(this::open, () -> workspace.openDocument().ifPresent(this::revertShipped));
    }

    private void revertShipped(OpenDocument now) {
        now.document()
                .saved()
                .ifPresent(
                        saved -> start(now.document().displayPath(), () -> new ScenarioDocument(null, saved, saved)));
    }

    /**
     * Opens a recovered scenario; its edits are still unsaved. {@code then} runs when it is open, {@code otherwise} if
     * it cannot be opened or the user cancels that.
     */
    public void recover(RecoveryStore.RecoveredFile recovered, Runnable then, Runnable otherwise) {
        openEdited(recovered.originFile(), recovered.base(), recovered.scenario(), then, otherwise);
    }

    /**
     * Opens a scenario as an edit of another one.
     *
     * @param file the file that it belongs to, null for none
     * @param saved what the file held when the edits were made, or the edited scenario if there is no file; null for
     *     nothing
     * @param edited the edited scenario
     */
    public void openEdited(Path file, Scenario saved, Scenario edited) {
        openEdited(file, saved, edited, () -> {}, () -> {});
    }

    private void openEdited(Path file, Scenario saved, Scenario edited, Runnable then, Runnable otherwise) {
        start(
                file == null ? Path.of(FileNames.forScenario(edited.name())) : file,
                () -> new ScenarioDocument(file, saved, edited),
                then,
                otherwise);
    }

    private void start(Path name, Callable<ScenarioDocument> loader) {
        start(name, loader, () -> {});
    }

    private void start(Path name, Callable<ScenarioDocument> loader, Runnable then) {
        start(name, loader, then, () -> {});
    }

    private void start(Path name, Callable<ScenarioDocument> loader, Runnable then, Runnable otherwise) {
        WorkspaceTask task = new WorkspaceTask(TaskKind.OPEN, name);
        workspace.start(
                task,
                () -> {
                    ScenarioDocument document = loader.call();
                    task.progress().throwIfCancelled();
                    return OpenDocument.start(document, workspace);
                },
                then,
                otherwise);
    }

    /**
     * Saves the edited scenario, with the comments of its present file, and calls {@code then} when the file is
     * written. Edits that wait until the run has been restarted or moved are waited for.
     */
    public void save(Path file, Runnable then) {
        workspace.openDocument().ifPresent(now -> {
            ScenarioDocument document = now.document();
            write(document, editedNow(), file, scenario -> saved(document, file, scenario, then));
        });
    }

    /**
     * What another program has written to the file of the scenario.
     *
     * @param file the file
     * @param problem why it does not hold a scenario, null if it does
     * @param save saves the edited scenario nevertheless, even if another one is open by then
     */
    public record ForeignChange(Path file, ScenarioException problem, Runnable save) {}

    /** What a file holds: a scenario, or a problem if it is not one, or neither if there is no such file. */
    private record FileContent(Scenario scenario, ScenarioException problem) {

        static FileContent of(Path file) {
            try {
                return new FileContent(Scenario.load(file), null);
            } catch (ScenarioException failure) {
                return new FileContent(null, Files.isRegularFile(file) ? failure : null);
            }
        }

        /** Returns whether a save needs no question, given what it may replace, null for nothing. */
        boolean mayBeReplaced(Scenario edited, Scenario replaceable) {
            return problem == null && (scenario == null || scenario.equals(edited) || scenario.equals(replaceable));
        }
    }

    /** The file of a document, and what a save may replace in it without a question, null for nothing. */
    private record SaveTarget(Path file, Scenario replaceable) {

        static SaveTarget of(ScenarioDocument document) {
            return new SaveTarget(
                    document.file().orElseThrow(), document.replaceable().orElse(null));
        }

        /** Writes a scenario; does nothing but return what another program has written, if it has. */
        Optional<FileContent> replace(Scenario edited) throws IOException {
            LinkResolver.refuseDevice(file);
            FileContent found = FileContent.of(file);
            if (!found.mayBeReplaced(edited, replaceable)) {
                return Optional.of(found);
            }
            edited.save(file, XmlComments.read(file));
            return Optional.empty();
        }
    }

    /**
     * Saves the edited scenario to its file, or to the one to which an earlier request saves it. If another program has
     * changed that file, {@code onForeignChange} is called instead, each time until the edited scenario is saved
     * nevertheless. The watch of the file notices a change only after some seconds.
     */
    public void saveUnlessReplaced(Runnable then, Consumer<ForeignChange> onForeignChange) {
        workspace.openDocument().ifPresent(now -> {
            ScenarioDocument document = now.document();
            CompletableFuture<Scenario> edited = editedNow();
            CompletableFuture<Void> end = writes.add(
                    () -> {
                        Scenario scenario = edited.join();
                        // The event dispatch thread knows the results of all earlier requests by then.
                        return CompletableFuture.supplyAsync(() -> SaveTarget.of(document), EventQueue::invokeLater)
                                .join()
                                .replace(scenario);
                    },
                    foreign -> {
                        Path file = document.file().orElseThrow();
                        foreign.ifPresentOrElse(
                                found -> {
                                    // The watch need not report it again.
                                    document.setSaved(found.scenario());
                                    workspace.fire(WorkspaceListener::titleChanged);
                                    Runnable save = () -> writeToSameFile(document, edited, file, then);
                                    onForeignChange.accept(new ForeignChange(file, found.problem(), save));
                                },
                                () -> saved(document, file, edited.join(), then));
                    },
                    failure -> saveFailed(document.file().orElseThrow(), failure));
            reportIfSlow(document.file().orElseThrow(), end);
        });
    }

    private CompletableFuture<Scenario> editedNow() {
        return workspace.edited().orElseThrow();
    }

    /** Writes a file that another save, which ends before, may replace by another one as the file of the document. */
    private void writeToSameFile(
            ScenarioDocument document, CompletableFuture<Scenario> edited, Path file, Runnable then) {
        write(document, edited, file, scenario -> {
            if (document.file().equals(Optional.of(file))) {
                saved(document, file, scenario, then);
            } else {
                workspace.fire(listener -> listener.scenarioSaved(file));
                then.run();
            }
        });
    }

    private void write(
            ScenarioDocument document, CompletableFuture<Scenario> edited, Path file, Consumer<Scenario> onWritten) {
        Path present = document.file().orElse(null);
        CompletableFuture<Void> end = writes.add(
                () -> {
                    Scenario scenario = edited.join();
                    LinkResolver.refuseDevice(file);
                    // A pipe, from which a scenario may have been opened, has no second content.
                    boolean readable = present != null && Files.isRegularFile(present);
                    scenario.save(file, readable ? XmlComments.read(present) : XmlComments.NONE);
                    return scenario;
                },
                onWritten,
                failure -> saveFailed(file, failure));
        reportIfSlow(file, end);
    }

    private void saved(ScenarioDocument document, Path file, Scenario scenario, Runnable then) {
        markSaved(document, file, scenario);
        then.run();
    }

    private void saveFailed(Path file, Throwable failure) {
        workspace.fire(listener -> listener.taskFailed(TaskKind.SAVE, file, failure));
    }

    /** Marks a scenario as saved; later edits remain unsaved. */
    void markSaved(ScenarioDocument document, Path file, Scenario scenario) {
        document.savedTo(file, scenario);
        workspace.fire(listener -> listener.scenarioSaved(file));
        workspace.fire(WorkspaceListener::titleChanged);
    }

    /** Saves a scenario that replays the run so far. */
    public void saveJournal(Path file) {
        workspace.replayScenario().ifPresent(replay -> {
            CompletableFuture<Void> end = writes.add(
                    () -> {
                        Scenario scenario = replay.join();
                        LinkResolver.refuseDevice(file);
                        scenario.save(file);
                        return scenario;
                    },
                    saved -> workspace.fire(listener -> listener.journalSaved(file)),
                    failure -> workspace.fire(listener -> listener.taskFailed(TaskKind.SAVE_JOURNAL, file, failure)));
            reportIfSlow(file, end);
        });
    }

    private void reportIfSlow(Path file, CompletableFuture<Void> end) {
        Timer timer = new Timer(SLOW_MILLIS, event -> {
            if (!end.isDone()) {
                workspace.fire(listener -> listener.saveSlow(file, () -> !end.isDone()));
            }
        });
        timer.setRepeats(false);
        timer.start();
    }
}
