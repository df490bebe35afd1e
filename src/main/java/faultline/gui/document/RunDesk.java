package faultline.gui.document;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Session;
import faultline.engine.Setup;
import faultline.geometry.Pose;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;

/** What is done to the run on the bench, and what is seen of it. */
public final class RunDesk {

    private final Bench bench;
    private final TimeTravel travel;
    private final Changes changes;
    private final List<Consumer<Session>> held = new ArrayList<>();
    private double speed = 1;

    /**
     * For a bench.
     *
     * @param bench whose run
     */
    public RunDesk(Bench bench) {
        this.bench = bench;
        travel = new TimeTravel(bench);
        changes = new Changes(bench);
        bench.addDesk(new Newcomers());
    }

    /** Makes each new session one like the last, and gives it what was meant for it before it was there. */
    private final class Newcomers implements Bench.Desk {
        @Override
        public void began(Task task, Work made) {
            if (task == Task.OPEN) {
                // They were meant for the scenario before.
                held.clear();
            }
            made.session().setSpeed(speed);
            travel.began(task, made.document().begun());
            travel.replayEnd().ifPresent(made.session()::holdAt);
            changes.suspect();
        }

        @Override
        public void settled() {
            List<Consumer<Session>> orders = List.copyOf(held);
            held.clear();
            orders.forEach(RunDesk.this::order);
        }
    }

    /**
     * Orders something of the run. While the same scenario is on its way to another moment or to a new beginning, orders wait: what the old
     * session were told now would be lost with it.
     */
    private void order(Consumer<Session> order) {
        if (bench.underWay().filter(way -> way.task() != Task.OPEN).isPresent()) {
            held.add(order);
        } else {
            session().ifPresent(order);
        }
    }

    /**
     * The way to other moments of the run.
     *
     * @return the same for every session
     */
    public TimeTravel travel() {
        return travel;
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
        bench.work().ifPresent(now -> {
            CompletableFuture<Journal> journal = now.session().wholeJournal();
            Document document = now.document();
            bench.begin(Task.RESTART, document.name(), way -> {
                Scenario edited = document.after(journal.join());
                return Work.begin(Document.begin(document.file(), document.saved(), edited.withSetup(change.apply(edited.setup()))));
            });
        });
    }

    /**
     * The newest frame; asking orders the next one.
     *
     * @return empty before the first session
     */
    public Optional<Frame> frame() {
        changes.look();
        Optional<Frame> newest = bench.work().map(now -> now.session().frame());
        newest.ifPresent(travel::see);
        return newest;
    }

    /**
     * How the run is.
     *
     * @return empty before the first session
     */
    public Optional<Session.Status> status() {
        return session().map(Session::status);
    }

    /**
     * Gives several commands to the run, which are carried out at the start of the same tick.
     *
     * @param commands what is to be done, in order
     * @param told gets what became of each, on the event dispatch thread, soon; never, where there is no run
     */
    public void send(List<Command> commands, Consumer<List<Session.Outcome>> told) {
        order(session -> session.send(commands, outcomes -> EventQueue.invokeLater(() -> {
            carriedOut(outcomes);
            told.accept(outcomes);
        })));
    }

    private void carriedOut(List<Session.Outcome> outcomes) {
        if (outcomes.stream().anyMatch(outcome -> outcome.refusal().isEmpty())) {
            changes.suspect();
            travel.turnOff();
            session().ifPresent(Session::holdNowhere);
        }
    }

    /** Lets time run, or holds it. */
    public void toggleRunning() {
        order(session -> {
            if (session.status().running()) {
                session.pause();
            } else {
                session.run();
            }
        });
    }

    /** Makes one tick and holds. */
    public void step() {
        order(Session::step);
    }

    /**
     * Sets the pace of this run and of all that follow.
     *
     * @param factor times real time, positive; positive infinity for as fast as possible
     */
    public void setSpeed(double factor) {
        speed = factor;
        session().ifPresent(session -> session.setSpeed(factor));
    }

    private Optional<Session> session() {
        return bench.work().map(Work::session);
    }
}
