package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.RecordedRun;
import faultline.engine.record.Hashes;
import faultline.gui.document.Bench.Task;
import faultline.scenario.Scenario;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;

/** Keeps an earlier run beside the one on the bench, and finds where the two first differ. Another scenario on the bench drives it out. */
public final class GhostDesk {

    private final Bench bench;
    private final TimeTravel travel;
    private Optional<Haunting> haunting = Optional.empty();
    private Hashes compared = Hashes.EMPTY;
    private int orders;

    /**
     * For a bench.
     *
     * @param bench whose run is compared
     * @param travel knows how far the run has been
     */
    public GhostDesk(Bench bench, TimeTravel travel) {
        this.bench = bench;
        this.travel = travel;
        bench.addDesk((task, made) -> {
            if (task == Task.OPEN) {
                remove();
            }
        });
    }

    /** Makes the run as far as it has been the ghost, soon. */
    public void keep() {
        bench.work().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().wholeJournal();
            Document document = now.document();
            summon(document.name(), () -> ghost(document.begun().name(), journal.join()));
        });
    }

    /**
     * Runs a scenario, a saved journal for one, and makes that run the ghost, soon.
     *
     * @param file the scenario file
     */
    public void open(Path file) {
        summon(file, () -> {
            Scenario scenario = Scenario.load(file);
            return ghost(scenario.name(), new Journal(scenario.setup(), List.of(), scenario.setup().ticks()));
        });
    }

    private static Ghost ghost(String name, Journal journal) {
        return new Ghost(name, journal.setup().seed(), journal.setup().dt(), RecordedRun.of(journal));
    }

    private void summon(Path name, Callable<Ghost> maker) {
        int order = ++orders;
        Background.run(maker, made -> {
            if (order == orders) {
                appear(made);
            }
        }, why -> bench.listener().failed(Task.GHOST, name, why));
    }

    private void appear(Ghost ghost) {
        bench.scenario().ifPresent(scenario -> {
            compared = Hashes.EMPTY;
            haunting = Optional.of(new Haunting(ghost, OptionalLong.empty(), ghost.seed() != scenario.setup().seed()));
        });
    }

    /** Shows no earlier run any more. */
    public void remove() {
        orders++;
        haunting = Optional.empty();
    }

    /**
     * Compares what has been run since the last look.
     *
     * @param frame the newest
     * @return the earlier run and how the two differ so far, empty where none is kept; the same object as before where nothing is new
     */
    public Optional<Haunting> see(Frame frame) {
        assert EventQueue.isDispatchThread();
        Hashes now = frame.recording().hashes();
        int from = now.continues(compared) ? compared.size() : 0;
        haunting = haunting.map(last -> compare(last, now, from));
        compared = now;
        return haunting;
    }

    private Haunting compare(Haunting last, Hashes now, int from) {
        if (last.divergence().isPresent() && isSettled(last.divergence().getAsLong(), now, from)) {
            return last;
        }
        OptionalLong divergence = now.firstDifference(last.ghost().run().hashes(), from);
        return divergence.equals(last.divergence()) ? last : new Haunting(last.ghost(), divergence, last.otherSeed());
    }

    /**
     * Whether a divergence that was found stands: it lies behind what is new, or ahead of a run that was taken back to an earlier moment
     * and will come there again.
     */
    private boolean isSettled(long divergence, Hashes now, int from) {
        return divergence < from || divergence >= now.size() && divergence <= travel.furthest();
    }
}
