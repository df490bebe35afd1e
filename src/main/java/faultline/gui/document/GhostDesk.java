package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.RecordedRun;
import faultline.engine.record.Hashes;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/** Keeps an earlier run beside the one on the bench, and finds where the two first differ. Another scenario on the bench drives it out. */
public final class GhostDesk {

    private final Bench bench;
    private final TimeTravel travel;
    private Optional<Haunting> haunting = Optional.empty();
    private Hashes compared = Hashes.EMPTY;
    private Optional<UnderWay> summoned = Optional.empty();

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
            summon(document.name(), way -> ghost(document.begun().name(), journal.join(), way));
        });
    }

    /**
     * Runs a scenario, a saved journal for one, and makes that run the ghost, soon.
     *
     * @param file the scenario file
     */
    public void open(Path file) {
        summon(file, way -> {
            Scenario scenario = Scenario.load(file);
            return ghost(scenario.name(), new Journal(scenario.setup(), List.of(), scenario.setup().ticks()), way);
        });
    }

    private static Ghost ghost(String name, Journal journal, UnderWay way) {
        return new Ghost(name, journal.setup().seed(), journal.setup().dt(), RecordedRun.of(journal, tick -> way.isWanted()));
    }

    /** Runs something in the place of whatever is being run. */
    private void summon(Path name, Maker<Ghost> maker) {
        giveUp();
        UnderWay way = new UnderWay(Task.GHOST, name);
        summoned = Optional.of(way);
        Background.run(() -> maker.make(way), made -> settle(way, () -> appear(made)),
                why -> settle(way, () -> bench.listener().failed(Task.GHOST, name, why)));
    }

    private void settle(UnderWay way, Runnable outcome) {
        if (way.isWanted()) {
            summoned = Optional.empty();
            outcome.run();
        }
    }

    private void giveUp() {
        summoned.ifPresent(UnderWay::cancel);
        summoned = Optional.empty();
    }

    private void appear(Ghost ghost) {
        bench.scenario().ifPresent(scenario -> {
            compared = Hashes.EMPTY;
            haunting = Optional.of(new Haunting(ghost, OptionalLong.empty(), ghost.seed() != scenario.setup().seed()));
        });
    }

    /** Shows no earlier run any more, and gives up the one that is being run. */
    public void remove() {
        giveUp();
        haunting = Optional.empty();
    }

    /**
     * Whether an earlier run is being run again, to be shown soon.
     *
     * @return true until it is there, or has failed or been removed
     */
    public boolean isUnderWay() {
        return summoned.isPresent();
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
