package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Session;
import faultline.engine.Setup;
import faultline.geometry.Pose;
import faultline.scenario.Journals;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** Holds the open scenario and its run. A new file or a restart is a new session; the old one is closed when the new one is there. */
public final class Bench implements AutoCloseable {

    private final Listener listener;
    private Optional<Work> work = Optional.empty();
    private double speed = 1;
    private int orders;
    private boolean asking;
    private boolean travelling;
    private boolean stale;
    private long furthest;

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
     * A scenario and a session of it.
     *
     * @param file where it is kept, empty for one that ships with the program
     * @param saved as the file holds it, empty where no file holds it
     * @param begun as the session began
     * @param edited as it is by now
     * @param session the run
     */
    private record Work(Optional<Path> file, Optional<Scenario> saved, Scenario begun, Scenario edited, Session session) {

        static Work begin(Optional<Path> file, Optional<Scenario> saved, Scenario begun) {
            return new Work(file, saved, begun, begun, Session.start(begun.setup()));
        }

        Work withEdited(Scenario newEdited) {
            return new Work(file, saved, begun, newEdited, session);
        }

        Work at(Journal journal, long tick) {
            return new Work(file, saved, begun, edited, Session.replay(journal, tick));
        }

        Work savedAs(Path newFile, Scenario newSaved) {
            return new Work(Optional.of(newFile), Optional.of(newSaved), begun, newSaved, session);
        }

        Scenario after(Journal journal) {
            return begun.withSetup(EditedSetup.of(journal));
        }

        boolean isChanged() {
            return !saved.equals(Optional.of(edited));
        }
    }

    /**
     * An empty bench.
     *
     * @param listener told of everything, on the event dispatch thread
     */
    public Bench(Listener listener) {
        this.listener = Objects.requireNonNull(listener, "listener");
    }

    /**
     * Reads a file and begins a session of it, soon.
     *
     * @param file the scenario file
     */
    public void open(Path file) {
        begin(Task.OPEN, file, () -> {
            Scenario scenario = Scenario.load(file);
            return Work.begin(Optional.of(file), Optional.of(scenario), scenario);
        });
    }

    /**
     * Begins a session of a scenario that ships with the program, soon.
     *
     * @param name its file's name
     */
    public void openShipped(String name) {
        begin(Task.OPEN, Path.of(name), () -> {
            Scenario scenario = Scenario.shipped(name);
            return Work.begin(Optional.empty(), Optional.of(scenario), scenario);
        });
    }

    /** Begins anew, soon, with the scenario as its file holds it; edits are given up. */
    public void revert() {
        work.ifPresent(now -> now.file().ifPresentOrElse(this::open, () -> now.saved().ifPresent(
                saved -> begin(Task.OPEN, path(now), () -> Work.begin(Optional.empty(), now.saved(), saved)))));
    }

    /**
     * Begins a session of edits that a crash has left, soon; they are unsaved still.
     *
     * @param rescue what was left
     */
    public void recover(Recovery.Rescue rescue) {
        Path file = rescue.origin().orElse(rescue.kept());
        begin(Task.OPEN, file, () -> Work.begin(rescue.origin(), Optional.empty(), rescue.scenario()));
    }

    /** Begins anew, soon, with the scenario as it is edited by now. */
    public void restart() {
        restart(UnaryOperator.identity());
    }

    /**
     * Begins anew, soon, with the scenario as it is edited by now and the robot elsewhere.
     *
     * @param start where the robot starts; there is room for it
     */
    public void startAt(Pose start) {
        restart(setup -> setup.withStart(start));
    }

    private void restart(UnaryOperator<Setup> change) {
        work.ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().journal();
            begin(Task.RESTART, path(now), () -> {
                Scenario edited = now.after(journal.join());
                return Work.begin(now.file(), now.saved(), edited.withSetup(change.apply(edited.setup())));
            });
        });
    }

    /**
     * Goes to another moment of the run, soon, and holds there. What was done later is done again when its tick comes, unless something else is done before.
     *
     * @param tick not negative
     */
    public void goTo(long tick) {
        work.ifPresent(now -> {
            now.session().pause();
            CompletableFuture<Journal> journal = now.session().wholeJournal();
            travelling = true;
            begin(Task.GO_TO, path(now), () -> now.at(journal.join(), tick));
        });
    }

    /** Goes back by one tick, soon, and holds there; while it is on its way there, nothing. */
    public void stepBack() {
        if (travelling) {
            return;
        }
        frame().map(frame -> frame.world().tick()).filter(tick -> tick > 0).ifPresent(tick -> goTo(tick - 1));
    }

    private void begin(Task task, Path file, Callable<Work> maker) {
        int order = ++orders;
        Background.run(maker, made -> adopt(made, task, order), why -> {
            travelling = false;
            listener.failed(task, file, why);
        });
    }

    private void adopt(Work made, Task task, int order) {
        travelling = false;
        if (order != orders) {
            made.session().close();
            return;
        }
        close();
        made.session().setSpeed(speed);
        work = Optional.of(made);
        stale = true;
        furthest = task == Task.GO_TO ? furthest : 0;
        if (task == Task.OPEN) {
            listener.opened();
        }
        listener.begun();
        listener.renamed();
    }

    /**
     * Writes the scenario as it is edited by now, soon.
     *
     * @param file where to
     * @param then done when it is written, and only then
     */
    public void save(Path file, Runnable then) {
        work.ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().journal();
            Background.run(() -> {
                Scenario scenario = now.after(journal.join());
                scenario.save(file);
                return scenario;
            }, scenario -> {
                noteSaved(now, file, scenario);
                then.run();
            }, why -> listener.failed(Task.SAVE, file, why));
        });
    }

    /** Another file may have been opened while this one was written. */
    private void noteSaved(Work before, Path file, Scenario scenario) {
        work = work.map(now -> now.session() == before.session() ? now.savedAs(file, scenario) : now);
        stale = true;
        listener.saved();
        listener.renamed();
    }

    /**
     * Writes a scenario that replays what was done in this run, soon.
     *
     * @param file where to
     */
    public void saveJournal(Path file) {
        work.ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().journal();
            Background.run(() -> {
                Journals.toScenario(now.begun(), journal.join()).save(file);
                return file;
            }, written -> {
            }, why -> listener.failed(Task.SAVE_JOURNAL, file, why));
        });
    }

    /**
     * The scenario that replays the run so far, to the bit.
     *
     * @return completed soon, off the event dispatch thread; exceptionally if the session is closed before; empty before the first session
     */
    public Optional<CompletableFuture<Scenario>> replay() {
        return work.map(now -> now.session().journal().thenApplyAsync(journal -> Journals.toScenario(now.begun(), journal)));
    }

    /**
     * The newest frame; asking orders the next one.
     *
     * @return empty before the first session
     */
    public Optional<Frame> frame() {
        assert EventQueue.isDispatchThread();
        look();
        Optional<Frame> newest = work.map(now -> now.session().frame());
        newest.ifPresent(frame -> furthest = Math.max(furthest, frame.world().tick()));
        return newest;
    }

    /**
     * How far the run has been, whatever moment it was taken back to since; what is done to it there gives it another future.
     *
     * @return ticks
     */
    public long furthest() {
        return furthest;
    }

    /** Finds out, without waiting, what the commands since the last look have made of the scenario. */
    private void look() {
        if (stale && !asking && work.isPresent()) {
            Work now = work.get();
            stale = false;
            asking = true;
            now.session().journal().thenApplyAsync(now::after)
                    .whenComplete((edited, closed) -> EventQueue.invokeLater(() -> looked(now, Optional.ofNullable(edited))));
        }
    }

    private void looked(Work asked, Optional<Scenario> edited) {
        asking = false;
        boolean changedBefore = isChanged();
        edited.ifPresent(scenario -> work = work.map(now -> now.session() == asked.session() ? now.withEdited(scenario) : now));
        if (isChanged() != changedBefore) {
            listener.renamed();
        }
    }

    /**
     * Gives a command to the run.
     *
     * @param command what is to be done
     */
    public void send(Command command) {
        assert EventQueue.isDispatchThread();
        stale = true;
        furthest = 0;
        work.ifPresent(now -> now.session().send(command));
    }

    /**
     * Gives several commands to the run, which are carried out at the start of the same tick.
     *
     * @param commands what is to be done, in order
     * @param told gets what became of each, on the event dispatch thread, soon; never, where there is no run
     */
    public void send(List<Command> commands, Consumer<List<Session.Outcome>> told) {
        assert EventQueue.isDispatchThread();
        stale = true;
        furthest = 0;
        work.ifPresent(now -> now.session().send(commands, outcomes -> EventQueue.invokeLater(() -> told.accept(outcomes))));
    }

    /** Lets time run, or holds it. */
    public void toggleRunning() {
        work.map(Work::session).ifPresent(session -> {
            if (session.status().running()) {
                session.pause();
            } else {
                session.run();
            }
        });
    }

    /** Makes one tick and holds. */
    public void step() {
        work.ifPresent(now -> now.session().step());
    }

    /**
     * Sets the pace of this run and of all that follow.
     *
     * @param factor times real time, positive; positive infinity for as fast as possible
     */
    public void setSpeed(double factor) {
        speed = factor;
        work.ifPresent(now -> now.session().setSpeed(factor));
    }

    /**
     * How the run is.
     *
     * @return empty before the first session
     */
    public Optional<Session.Status> status() {
        return work.map(now -> now.session().status());
    }

    /**
     * Where the scenario is kept.
     *
     * @return empty where it has no file
     */
    public Optional<Path> file() {
        return work.flatMap(Work::file);
    }

    /**
     * The scenario as it is edited by now.
     *
     * @return empty before the first session
     */
    public Optional<Scenario> scenario() {
        return work.map(Work::edited);
    }

    /**
     * The scenario as its file holds it, as far as is known here.
     *
     * @return empty before the first session, and where no file holds it
     */
    public Optional<Scenario> saved() {
        return work.flatMap(Work::saved);
    }

    /**
     * Whether the scenario differs from its file.
     *
     * @return true where a save would change the file
     */
    public boolean isChanged() {
        return work.filter(Work::isChanged).isPresent();
    }

    private static Path path(Work work) {
        return work.file().orElse(Path.of(work.begun().name()));
    }

    /** Ends the run. */
    @Override
    public void close() {
        work.ifPresent(now -> now.session().close());
        work = Optional.empty();
    }
}
