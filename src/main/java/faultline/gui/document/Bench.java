package faultline.gui.document;

import faultline.scenario.Journals;
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
 * Holds the open scenario and its run. A new file, a restart or another moment of the run is a new session; the old one is closed when the
 * new one is there. What is done with files is {@link Filing}'s, what is done to the run {@link RunDesk}'s.
 */
public final class Bench implements AutoCloseable {

    private final BenchListener listener;
    private final List<Desk> desks = new ArrayList<>();
    private Optional<Work> work = Optional.empty();
    private Optional<UnderWay> underWay = Optional.empty();

    /** A part of the bench, told before everybody else. */
    interface Desk {

        /** A new session has begun, by a task. */
        void began(Task task, Work made);

        /** Nothing is under way any more: the session that is there stays. */
        default void settled() {
        }
    }

    /**
     * An empty bench.
     *
     * @param listener told of everything, on the event dispatch thread
     */
    public Bench(BenchListener listener) {
        this.listener = Objects.requireNonNull(listener, "listener");
    }

    BenchListener listener() {
        return listener;
    }

    /** What lies here, empty before the first session. */
    Optional<Work> work() {
        assert EventQueue.isDispatchThread();
        return work;
    }

    /**
     * What is on its way here.
     *
     * @return empty where nothing is
     */
    public Optional<UnderWay> underWay() {
        assert EventQueue.isDispatchThread();
        return underWay;
    }

    void addDesk(Desk desk) {
        desks.add(desk);
    }

    /**
     * Makes something off the event dispatch thread and puts it in the place of what is here, unless something else is asked for in
     * between.
     */
    void begin(Task task, Path name, Maker<Work> maker) {
        UnderWay way = new UnderWay(task, name);
        underWay.ifPresent(UnderWay::cancel);
        underWay = Optional.of(way);
        Background.run(() -> maker.make(way), made -> adopt(made, way), why -> fail(way, why));
    }

    /** Gives up what is on its way here; all stays as it was before it was asked for. */
    public void cancel() {
        underWay.ifPresent(UnderWay::cancel);
        settle();
    }

    private void settle() {
        underWay = Optional.empty();
        desks.forEach(Desk::settled);
    }

    private void fail(UnderWay way, Throwable why) {
        if (way.isWanted()) {
            settle();
            listener.failed(way.task(), way.name(), why);
        }
    }

    private void adopt(Work made, UnderWay way) {
        if (!way.isWanted()) {
            made.session().close();
            return;
        }
        Work adopted = way.task() == Task.OPEN ? made : filed(made);
        endRun();
        work = Optional.of(adopted);
        desks.forEach(desk -> desk.began(way.task(), adopted));
        tell(way.task(), adopted);
        listener.begun();
        listener.renamed();
        settle();
    }

    /** The same scenario anew; it may have been saved, elsewhere too, since that was asked for. */
    private Work filed(Work made) {
        return document().map(now -> made.with(made.document().filedAs(now))).orElse(made);
    }

    private void tell(Task task, Work made) {
        if (task == Task.OPEN) {
            listener.opened();
        } else if (task == Task.RESTART) {
            listener.restarted();
        } else {
            listener.travelled(made.session().frame().world().tick());
        }
    }

    /** Changes the document, unless another session than that of the work given has begun since; a restart, too, has another document. */
    void change(Work before, UnaryOperator<Document> change) {
        work = work.map(now -> now.session() == before.session() ? now.with(change.apply(now.document())) : now);
    }

    /** Somebody else has written the file, or broken it: what is here is unsaved from now on, unless it is the same or read again. */
    void fileHolds(Optional<Scenario> found) {
        work = work.map(now -> now.with(now.document().withSaved(found)));
        listener.renamed();
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

    /** Ends the run, and gives up what is on its way here. */
    @Override
    public void close() {
        underWay.ifPresent(UnderWay::cancel);
        underWay = Optional.empty();
        endRun();
    }

    private void endRun() {
        work.ifPresent(now -> now.session().close());
        work = Optional.empty();
    }
}
