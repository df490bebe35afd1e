package faultline.gui.document;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.RecordedRun;
import faultline.gui.EdtChecker;
import faultline.gui.Patience;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Predicate;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** An earlier run beside the one on the bench, without a display. */
@ExtendWith(EdtChecker.class)
class GhostDeskTest {

    private static final Path OFFICE = Path.of("scenarios/office.xml");
    private static final int TICKS = 60;
    private static final int CHANGED = 20;
    private static final double MANY_HOURS = 80_000;

    private final List<String> failures = new ArrayList<>();
    private Bench bench;
    private RunDesk run;
    private GhostDesk desk;

    @BeforeEach
    void runAndKeepTheGhost() {
        edt(() -> {
            bench = new Bench(new Quiet());
            run = new RunDesk(bench);
            desk = new GhostDesk(bench, run.travel());
        });
        open(OFFICE);
        step(TICKS);
        edt(desk::keep);
        waitFor("the ghost", haunting -> haunting.isPresent());
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    private void open(Path file) {
        edt(() -> new Filing(bench).open(file));
        Patience.waitFor("the scenario", () -> run.frame().isPresent());
    }

    private Optional<Haunting> look() {
        return run.frame().flatMap(desk::see);
    }

    private void waitFor(String what, Predicate<Optional<Haunting>> condition) {
        Patience.waitFor(what, () -> condition.test(look()));
    }

    private void waitForTick(long tick) {
        Patience.waitFor("tick " + tick, () -> {
            look();
            return tick() == tick;
        });
    }

    private long tick() {
        return run.frame().map(frame -> frame.world().tick()).orElse(-1L);
    }

    private void step(int ticks) {
        long from = onEdt(this::tick);
        for (int i = 0; i < ticks; i++) {
            edt(run::step);
        }
        waitForTick(from + ticks);
    }

    private void restart() {
        edt(run::restart);
        waitForTick(0);
    }

    private OptionalLong divergence() {
        return onEdt(() -> look().orElseThrow().divergence());
    }

    /** Switches the left sensor off at the start of tick CHANGED, and runs on. */
    private void runDifferently() {
        restart();
        step(CHANGED - 1);
        edt(() -> run.send(List.of(new Command.SwitchSensor("left", false)), told -> { }));
        step(TICKS - CHANGED + 1);
    }

    @Test
    void theSameRunAgainDoesNotDiverge() {
        restart();
        step(TICKS);
        assertEquals(OptionalLong.empty(), divergence());
        assertFalse(onEdt(() -> look().orElseThrow().otherSeed()));
    }

    @Test
    void anotherRunDivergesInTheTickInWhichTheFirstBitDiffers() {
        runDifferently();
        assertEquals(OptionalLong.of(CHANGED), divergence());
        RecordedRun ghost = onEdt(() -> look().orElseThrow().ghost().run());
        Frame frame = onEdt(() -> run.frame().orElseThrow());
        assertTrue(LongStream.range(0, CHANGED).allMatch(tick -> ghost.hashes().at(tick) == frame.recording().hashes().at(tick)));
        assertTrue(LongStream.rangeClosed(CHANGED, TICKS).allMatch(tick -> ghost.hashes().at(tick) != frame.recording().hashes().at(tick)));
    }

    @Test
    void takenBackBeforeTheDivergenceItIsStillKnownBecauseItWillComeAgain() {
        runDifferently();
        edt(() -> run.travel().goTo(CHANGED / 2));
        waitForTick(CHANGED / 2);
        assertEquals(OptionalLong.of(CHANGED), divergence());
    }

    @Test
    void takenBackAndGivenAnotherFutureItIsForgotten() {
        runDifferently();
        edt(() -> run.travel().goTo(CHANGED / 2));
        waitForTick(CHANGED / 2);
        edt(() -> run.send(List.of(new Command.SwitchSensor("rear", true)), told -> { }));
        step(TICKS);
        assertEquals(OptionalLong.empty(), divergence(), "the rear sensor was on already");
    }

    @Test
    void aRestartForgetsTheDivergenceAndKeepsTheGhost() {
        runDifferently();
        restart();
        assertEquals(OptionalLong.empty(), divergence());
    }

    @Test
    void anotherScenarioDrivesItOut() {
        open(Path.of("scenarios/yard.xml"));
        waitFor("no ghost", haunting -> haunting.isEmpty());
    }

    @Test
    void theRunOfAFileCanBeTheGhostAndItsOtherSeedIsTold(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("seed-7.xml");
        Scenario office = Scenario.load(OFFICE);
        office.withSetup(office.setup().withSeed(7).withDuration(0.3)).save(file);
        edt(() -> desk.open(file));
        waitFor("the other ghost", haunting -> haunting.filter(Haunting::otherSeed).isPresent());
        assertEquals(30, onEdt(() -> look().orElseThrow().ghost().run().lastTick()));
    }

    @Test
    void aFileThatIsNoScenarioIsToldAndTheOldGhostStays(@TempDir Path folder) {
        edt(() -> desk.open(folder.resolve("none.xml")));
        Patience.waitFor("the failure", () -> failures.contains("GHOST none.xml"));
        assertTrue(onEdt(() -> look().isPresent()));
    }

    @Test
    void itCanBeRemoved() {
        edt(desk::remove);
        assertTrue(onEdt(() -> look().isEmpty()));
    }

    @Test
    void removedWhileItIsBeingRunItNeverComesAndTheRunStops(@TempDir Path folder) throws Exception {
        edt(desk::remove);
        Path file = folder.resolve("long.xml");
        Scenario office = Scenario.load(OFFICE);
        office.withSetup(office.setup().withDuration(MANY_HOURS)).save(file);
        edt(() -> desk.open(file));
        Patience.waitFor("the ghost's run", () -> ghostRuns());
        assertTrue(onEdt(desk::isUnderWay));
        edt(desk::remove);
        assertFalse(onEdt(desk::isUnderWay));
        Patience.waitFor("the end of the ghost's run", () -> !ghostRuns());
        assertTrue(onEdt(() -> look().isEmpty()));
        assertEquals(List.of(), failures, "to be given up is no failure");
    }

    private static boolean ghostRuns() {
        return Thread.getAllStackTraces().values().stream().flatMap(Stream::of).anyMatch(call -> call.getClassName().equals(RecordedRun.class.getName()));
    }

    private final class Quiet implements BenchListener {
        @Override
        public void begun() {
            // The test looks.
        }

        @Override
        public void renamed() {
            // The test has no title.
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            failures.add(what + " " + file.getFileName());
        }
    }
}
