package faultline.gui.document;

import faultline.scenario.JournalScenario;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.UnaryOperator;

/**
 * Holds the open scenario and its run. A new file, a restart or another moment of the run is a new session; the old one
 * is closed when the new one is there. What is done with files is {@link DocumentStore}'s, what is done to the run
 * {@link RunController}'s.
 */
public final class Workspace implements AutoCloseable {

    private final WorkspaceListener listener;
    private final List<SessionListener> sessionListeners = new ArrayList<>();
    private Optional<OpenDocument> openDocument = Optional.empty();
    private Optional<TaskProgress> taskProgress = Optional.empty();

    /** A part of the bench, told before everybody else. */
    interface SessionListener {

        /** A new session has begun, by a task. */
        void sessionStarted(TaskKind task, OpenDocument made);

        /** Nothing is under way any more: the session that is there stays. */
        default void taskFinished() {}
    }

    /**
     * An empty bench.
     *
     * @param listener told of everything, on the event dispatch thread
     */
    public Workspace(WorkspaceListener listener) {
        this.listener = Objects.requireNonNull(listener, "listener");
    }

    WorkspaceListener listener() {
        return listener;
    }

    /** What lies here, empty before the first session. */
    Optional<OpenDocument> openDocument() {
        assert EventQueue.isDispatchThread();
        return openDocument;
    }

    /**
     * What is on its way here.
     *
     * @return empty where nothing is
     */
    public Optional<TaskProgress> taskProgress() {
        assert EventQueue.isDispatchThread();
        return taskProgress;
    }

    void addSessionListener(SessionListener desk) {
        sessionListeners.add(desk);
    }

    /**
     * Makes something off the event dispatch thread and puts it in the place of what is here, unless something else is
     * asked for in between.
     */
    void startTask(TaskKind task, Path name, ProgressCallable<OpenDocument> maker) {
        TaskProgress way = new TaskProgress(task, name);
        taskProgress.ifPresent(TaskProgress::cancel);
        taskProgress = Optional.of(way);
        BackgroundTasks.run(() -> maker.call(way), made -> openResult(made, way), why -> taskFailed(way, why));
    }

    /** Gives up what is on its way here; all stays as it was before it was asked for. */
    public void cancelTask() {
        taskProgress.ifPresent(TaskProgress::cancel);
        finishTask();
    }

    private void finishTask() {
        taskProgress = Optional.empty();
        sessionListeners.forEach(SessionListener::taskFinished);
    }

    private void taskFailed(TaskProgress way, Throwable why) {
        if (way.isActive()) {
            finishTask();
            listener.taskFailed(way.task(), way.name(), why);
        }
    }

    private void openResult(OpenDocument made, TaskProgress way) {
        if (!way.isActive()) {
            made.session().close();
            return;
        }
        OpenDocument adopted = way.task() == TaskKind.OPEN ? made : withCurrentFile(made);
        endRun();
        openDocument = Optional.of(adopted);
        sessionListeners.forEach(desk -> desk.sessionStarted(way.task(), adopted));
        notifyListener(way.task(), adopted);
        listener.sessionStarted();
        listener.titleChanged();
        finishTask();
    }

    /** The same scenario anew; it may have been saved, elsewhere too, since that was asked for. */
    private OpenDocument withCurrentFile(OpenDocument made) {
        return document()
                .map(now -> made.withDocument(made.document().withFileOf(now)))
                .orElse(made);
    }

    private void notifyListener(TaskKind task, OpenDocument made) {
        if (task == TaskKind.OPEN) {
            listener.scenarioOpened();
        } else if (task == TaskKind.RESTART) {
            listener.scenarioRestarted();
        } else {
            listener.runRepositioned(made.session().frame().snapshot().tick());
        }
    }

    /**
     * Changes the document, unless another session than that of the work given has begun since; a restart, too, has
     * another document.
     */
    void updateDocument(OpenDocument before, UnaryOperator<ScenarioDocument> change) {
        openDocument = openDocument.map(
                now -> now.session() == before.session() ? now.withDocument(change.apply(now.document())) : now);
    }

    /**
     * Somebody else has written the file, or broken it: what is here is unsaved from now on, unless it is the same or
     * read again.
     */
    void setSavedScenario(Optional<Scenario> found) {
        openDocument = openDocument.map(now -> now.withDocument(now.document().withSaved(found)));
        listener.titleChanged();
    }

    /**
     * Where the scenario is kept.
     *
     * @return empty where it has no file
     */
    public Optional<Path> file() {
        return document().flatMap(ScenarioDocument::file);
    }

    /**
     * The scenario as it is edited by now.
     *
     * @return empty before the first session
     */
    public Optional<Scenario> scenario() {
        return document().map(ScenarioDocument::edited);
    }

    /**
     * The scenario as its file holds it, as far as is known here.
     *
     * @return empty before the first session, and where no file holds it
     */
    public Optional<Scenario> savedScenario() {
        return document().flatMap(ScenarioDocument::saved);
    }

    /**
     * Whether the scenario differs from its file.
     *
     * @return true where a save would change the file
     */
    public boolean isChanged() {
        return document().filter(ScenarioDocument::isChanged).isPresent();
    }

    /**
     * The scenario that replays the run so far, to the bit.
     *
     * @return completed soon, off the event dispatch thread; exceptionally if the session is closed before; empty
     *     before the first session
     */
    public Optional<CompletableFuture<Scenario>> replayScenario() {
        return openDocument.map(now -> now.session()
                .journal()
                .thenApplyAsync(journal -> JournalScenario.create(now.document().initial(), journal)));
    }

    private Optional<ScenarioDocument> document() {
        return openDocument.map(OpenDocument::document);
    }

    /** Ends the run, and gives up what is on its way here. */
    @Override
    public void close() {
        taskProgress.ifPresent(TaskProgress::cancel);
        taskProgress = Optional.empty();
        endRun();
    }

    private void endRun() {
        openDocument.ifPresent(now -> now.session().close());
        openDocument = Optional.empty();
    }
}
