package faultline.gui.document;

import faultline.scenario.Journals;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;

/**
 * Holds the open scenario and its run. A new file, a restart or another moment of the run is a new session; the old one is closed when the new one is there.
 * What is done with files is {@link Filing}'s, what is done to the run {@link RunDesk}'s.
 */
public final class Bench implements AutoCloseable {

    private final Listener listener;
    private final List<BiConsumer<Task, Work>> desks = new ArrayList<>();
    private Optional<Work> work = Optional.empty();
    private Optional<Task> underWay = Optional.empty();
    private int orders;

    /** Told of what happens on the bench. */
    public interface Listener {

        /** A new session has begun: of another file, or of the same scenario anew. */
        void begun();

        /** The name of the file, or whether there are unsaved changes, is another now. */
        void renamed();

        /**
         * Something asked for could not be done; all is as it was before.
         *
         * @param what was being done
         * @param file with which file
         * @param why the exception
         */
        void failed(Task what, Path file, Throwable why);

        /** Another scenario is on the bench; told before its session begins. */
        default void opened() {
        }

        /** The scenario is in its file as it is edited by now. */
        default void saved() {
        }
    }

    /** What takes a while. */
    public enum Task {
        /** Reading a scenario. */
        OPEN,
        /** Writing the scenario. */
        SAVE,
        /** Writing the journal. */
        SAVE_JOURNAL,
        /** Beginning anew. */
        RESTART,
        /** Going to another moment of the run. */
        GO_TO
    }

    /**
     * An empty bench.
     *
     * @param listener told of everything, on the event dispatch thread
     */
    public Bench(Listener listener) {
        this.listener = Objects.requireNonNull(listener, "listener");
    }

    Listener listener() {
        return listener;
    }

    /** What lies here, empty before the first session. */
    Optional<Work> work() {
        assert EventQueue.isDispatchThread();
        return work;
    }

    /** What is being made to lie here next, empty where nothing is. */
    Optional<Task> underWay() {
        return underWay;
    }

    /** Tells of each new session before everybody else is told, and what it is for. */
    void addDesk(BiConsumer<Task, Work> desk) {
        desks.add(desk);
    }

    /** Makes something off the event dispatch thread and puts it in the place of what is here, unless something else is asked for in between. */
    void begin(Task task, Path name, Callable<Work> maker) {
        int order = ++orders;
        underWay = Optional.of(task);
        Background.run(maker, made -> adopt(made, task, order), why -> {
            arrive(order);
            listener.failed(task, name, why);
        });
    }

    private boolean arrive(int order) {
        boolean newest = order == orders;
        underWay = newest ? Optional.empty() : underWay;
        return newest;
    }

    private void adopt(Work made, Task task, int order) {
        if (!arrive(order)) {
            made.session().close();
            return;
        }
        close();
        work = Optional.of(made);
        desks.forEach(desk -> desk.accept(task, made));
        if (task == Task.OPEN) {
            listener.opened();
        }
        listener.begun();
        listener.renamed();
    }

    /** Changes the document, unless another session than that of the work given has begun since; a restart, too, has another document. */
    void change(Work before, UnaryOperator<Document> change) {
        work = work.map(now -> now.session() == before.session() ? now.with(change.apply(now.document())) : now);
    }

    /**
     * Where the scenario is kept.
     *
     * @return empty where it has no file
     */
    public Optional<Path> file() {
        return document().flatMap(Document::file);
    }

    /**
     * The scenario as it is edited by now.
     *
     * @return empty before the first session
     */
    public Optional<Scenario> scenario() {
        return document().map(Document::edited);
    }

    /**
     * The scenario as its file holds it, as far as is known here.
     *
     * @return empty before the first session, and where no file holds it
     */
    public Optional<Scenario> saved() {
        return document().flatMap(Document::saved);
    }

    /**
     * Whether the scenario differs from its file.
     *
     * @return true where a save would change the file
     */
    public boolean isChanged() {
        return document().filter(Document::isChanged).isPresent();
    }

    /**
     * The scenario that replays the run so far, to the bit.
     *
     * @return completed soon, off the event dispatch thread; exceptionally if the session is closed before; empty before the first session
     */
    public Optional<CompletableFuture<Scenario>> replay() {
        return work.map(now -> now.session().journal().thenApplyAsync(journal -> Journals.toScenario(now.document().begun(), journal)));
    }

    private Optional<Document> document() {
        return work.map(Work::document);
    }

    /** Ends the run. */
    @Override
    public void close() {
        work.ifPresent(now -> now.session().close());
        work = Optional.empty();
    }
}
