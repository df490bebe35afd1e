package faultline.gui.document;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.geometry.Pose;
import faultline.gui.EdtChecker;
import faultline.gui.Patience;
import faultline.gui.edit.EditDesk;
import faultline.gui.edit.EditNews;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** What becomes of edits when the run is taken to another moment of its time. Two edits are made: at tick 10 and at tick 20, of 30. */
@ExtendWith(EdtChecker.class)
class TimeJumpTest {

    private static final Pose FIRST = new Pose(2, 3, 0);
    private static final Pose SECOND = new Pose(2, 3.2, 0);
    private static final long FAR = 1_000_000_000;

    @TempDir
    private Path folder;
    private final List<Integer> forks = new ArrayList<>();
    private final List<Long> undone = new ArrayList<>();
    private Bench bench;
    private RunDesk run;
    private Filing filing;
    private EditDesk edits;
    private Pose original;

    /** Keeps what the edit desk tells. */
    private final class Heard implements EditNews {
        @Override
        public void forked(int later) {
            forks.add(later);
        }

        @Override
        public void undone(long since) {
            undone.add(since);
        }
    }

    @BeforeEach
    void editTwice() {
        edt(() -> {
            bench = new Bench(new Passing());
            run = new RunDesk(bench);
            filing = new Filing(bench);
            edits = new EditDesk(run::send, () -> { });
            edits.tell(new Heard());
            filing.open(Path.of("scenarios/collision-on-purpose.xml"));
        });
        Patience.waitFor("the scenario", () -> run.frame().isPresent());
        original = pole();
        stepTo(10);
        edit(new Command.MoveObstacle("pole", FIRST));
        stepTo(20);
        edit(new Command.MoveObstacle("pole", SECOND));
        stepTo(30);
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void backBeforeAnEditItCanBeRedoneAndOnPastItUndoneAgain() {
        goTo(15);
        assertEquals(FIRST, pole());
        assertTrue(onEdt(() -> edits.undoName().isPresent() && edits.redoName().isPresent()));
        goTo(5);
        assertEquals(original, pole());
        assertEquals(Optional.empty(), onEdt(edits::undoName));
        stepTo(30);
        assertEquals(SECOND, pole());
        assertEquals(Optional.empty(), onEdt(edits::redoName));
        assertEquals(List.of(), forks, "nothing else happened than before");
    }

    @Test
    void anUndoTellsSinceWhenTheEditHadStood() {
        edt(edits::undo);
        waitForPole(FIRST);
        edt(run::restart);
        Patience.waitFor("the restart", () -> run.frame().orElseThrow().world().tick() == 0);
        edt(edits::undo);
        waitForPole(original);
        assertEquals(List.of(21L, 0L), undone);
    }

    @Test
    void theScenarioStaysAsEditedAtWhateverMomentTheRunIs() throws ScenarioException {
        goTo(5);
        waitForEdited(SECOND);
        Path file = folder.resolve("saved.xml");
        edt(() -> filing.save(file, () -> { }));
        Patience.waitFor("the save", () -> !bench.isChanged());
        assertEquals(SECOND, pole(Scenario.load(file).setup().world().obstacles()));
        edt(run::restart);
        Patience.waitFor("the restart", () -> run.frame().orElseThrow().world().tick() == 0);
        assertEquals(SECOND, pole());
    }

    @Test
    void aRestartFromAnEarlierMomentLeavesEveryEditToBeUndone() {
        goTo(5);
        edt(run::restart);
        Patience.waitFor("the restart", () -> run.frame().orElseThrow().world().tick() == 0);
        edt(edits::undo);
        waitForPole(FIRST);
        edt(edits::undo);
        waitForPole(original);
    }

    @Test
    void anEditInThePastKeepsTheLaterOnesToBeRedoneAndTellsOfIt() {
        goTo(5);
        edit(new Command.SetPlatform(0.2, 0.2, 0.4));
        assertEquals(List.of(2), forks);
        stepTo(30);
        assertEquals(original, pole(), "it does not happen by itself any more");
        edt(edits::redo);
        waitForPole(FIRST);
        edt(edits::redo);
        waitForPole(SECOND);
        edt(edits::undo);
        edt(edits::undo);
        waitForPole(original);
        edt(edits::undo);
        Patience.waitFor("the platform as it was", () -> run.frame().orElseThrow().world().robot().length() != 0.2);
        assertEquals(Optional.empty(), onEdt(edits::undoName));
    }

    @Test
    void severalEditsInThePastStandBeforeTheLaterOnes() {
        goTo(15);
        edit(new Command.SetPlatform(0.2, 0.2, 0.4));
        edit(new Command.SwitchSensor("left", false));
        edt(edits::redo);
        waitForPole(SECOND);
        for (int i = 0; i < 4; i++) {
            edt(edits::undo);
        }
        waitForPole(original);
        assertTrue(onEdt(() -> run.frame().orElseThrow().world().robot().sensor("left").orElseThrow().on()));
        assertEquals(Optional.empty(), onEdt(edits::undoName));
    }

    @Test
    void anEditThatWasUndoneLaterIsThereAtTheMomentBetween() {
        edt(edits::undo);
        waitForPole(FIRST);
        stepTo(40);
        goTo(25);
        assertEquals(SECOND, pole());
        edt(edits::undo);
        waitForPole(FIRST);
    }

    @Test
    void whatIsDoneOnTheWayToAnotherMomentIsDoneThere() {
        edt(() -> {
            run.travel().goTo(15);
            edits.send(new Command.SwitchSensor("left", false));
            run.step();
        });
        Patience.waitFor("the arrival and one tick", () -> run.frame().orElseThrow().world().tick() == 16);
        assertFalse(onEdt(() -> run.frame().orElseThrow().world().robot().sensor("left").orElseThrow().on()));
        assertEquals(FIRST, pole());
    }

    @Test
    void aLongWayTellsHowFarItIsAndGivenUpLeavesTheRunWhereItWas() {
        edt(() -> run.travel().goTo(FAR));
        Patience.waitFor("some of the way", () -> bench.underWay().orElseThrow().share().orElse(0) > 1e-6);
        edt(bench::cancel);
        assertEquals(Optional.empty(), onEdt(bench::underWay));
        assertEquals(30, tick());
        edt(run::step);
        Patience.waitFor("the run to go on", () -> run.frame().orElseThrow().world().tick() == 31);
        assertEquals(SECOND, pole());
    }

    @Test
    void aFileThatIsGivenUpWhileItOpensChangesNothing() {
        Optional<Path> before = onEdt(bench::file);
        edt(() -> {
            filing.open(Path.of("scenarios/office.xml"));
            bench.cancel();
        });
        edt(run::step);
        Patience.waitFor("the run to go on", () -> run.frame().orElseThrow().world().tick() == 31);
        assertEquals(before, onEdt(bench::file));
        assertEquals(SECOND, pole());
    }

    private void edit(Command command) {
        Optional<String> before = onEdt(edits::undoName);
        Frame frame = onEdt(() -> run.frame().orElseThrow());
        edt(() -> {
            edits.begin();
            edits.send(command);
            edits.end();
        });
        Patience.waitFor("the edit after " + before, () -> run.frame().orElseThrow() != frame && edits.undoName().isPresent());
    }

    private void goTo(long tick) {
        edt(() -> run.travel().goTo(tick));
        Patience.waitFor("tick " + tick, () -> bench.underWay().isEmpty() && run.frame().orElseThrow().world().tick() == tick);
    }

    private void stepTo(long tick) {
        for (long now = tick(); now < tick; now++) {
            edt(run::step);
        }
        Patience.waitFor("tick " + tick, () -> run.frame().orElseThrow().world().tick() == tick);
        edt(() -> edits.passed(tick));
    }

    private long tick() {
        return onEdt(() -> run.frame().orElseThrow().world().tick());
    }

    /** What commands have made of the scenario is found out without waiting for it. */
    private void waitForEdited(Pose pose) {
        Patience.waitFor("the scenario's pole at " + pose, () -> {
            run.frame();
            return pole(bench.scenario().orElseThrow().setup().world().obstacles()).equals(pose);
        });
    }

    private Pose pole() {
        return onEdt(() -> pole(run.frame().orElseThrow().world().obstacles()));
    }

    private static Pose pole(List<Obstacle> obstacles) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals("pole")).findFirst().orElseThrow().pose();
    }

    private void waitForPole(Pose pose) {
        Patience.waitFor("the pole at " + pose, () -> pole(run.frame().orElseThrow().world().obstacles()).equals(pose));
    }

    /** Passes on what the edit desk must know, as the window does. */
    private final class Passing implements BenchListener {
        @Override
        public void begun() {
            // Frames are asked for.
        }

        @Override
        public void renamed() {
            // Nobody reads the title.
        }

        @Override
        public void restarted() {
            edits.restarted();
        }

        @Override
        public void travelled(long tick) {
            edits.travelled(tick);
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
