package faultline.gui.document;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.geometry.Pose;
import faultline.gui.Patience;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The bench on the event dispatch thread, without a window and without a display. */
class BenchTest {

    private static final String OBSTACLE = "pole";
    private static final Pose ELSEWHERE = new Pose(2, 3, 0);

    @TempDir
    private Path folder;
    private Path file;
    private final List<Throwable> failures = new ArrayList<>();
    private int begun;
    private Bench bench;

    @BeforeEach
    void openAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("room.xml"));
        bench = onEdt(() -> new Bench(new Bench.Listener() {
            @Override
            public void begun() {
                begun++;
            }

            @Override
            public void renamed() {
                assertTrue(EventQueue.isDispatchThread());
            }

            @Override
            public void failed(Bench.Task what, Path with, Throwable why) {
                failures.add(why);
            }
        }));
        edt(() -> bench.open(file));
        waitFor("the first session", () -> begun == 1);
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void aFileOpensPausedAtTimeZeroAndUnchanged() {
        assertEquals(0, frame().world().tick());
        assertFalse(onEdt(() -> bench.status().orElseThrow().running()));
        assertFalse(onEdt(bench::isChanged));
        assertEquals(Optional.of(file), onEdt(bench::file));
    }

    @Test
    void aMovedObstacleMarksTheScenarioAsChangedUntilItIsSavedAndReadsBackAsItStands() throws ScenarioException {
        move();
        waitFor("the mark", bench::isChanged);
        edt(() -> bench.save(file, () -> begun = 7));
        waitFor("the save", () -> begun == 7);
        assertFalse(onEdt(bench::isChanged));
        assertEquals(onEdt(bench::scenario), Optional.of(Scenario.load(file)));
        assertEquals(ELSEWHERE, obstacle(Scenario.load(file).setup().world().obstacles()).pose());
    }

    @Test
    void aRestartGoesBackToTimeZeroWithEditsKeptAndSwitchesAsInTheFile() {
        move();
        edt(() -> {
            bench.send(new Command.SwitchSensor("left", false));
            bench.step();
        });
        waitFor("the tick", () -> bench.frame().orElseThrow().world().tick() == 1);
        edt(bench::restart);
        waitFor("the second session", () -> begun == 2);
        assertEquals(0, frame().world().tick());
        assertEquals(ELSEWHERE, obstacle(frame().world().obstacles()).pose());
        assertTrue(frame().world().robot().sensor("left").orElseThrow().on());
        assertTrue(onEdt(bench::isChanged));
    }

    @Test
    void aBrokenFileIsToldWithItsComplaintsAndLeavesTheOldRunAsItIs() throws IOException {
        Frame before = frame();
        Path broken = Files.writeString(folder.resolve("broken.xml"), "<scenario/>");
        edt(() -> bench.open(broken));
        waitFor("the failure", () -> !failures.isEmpty());
        assertInstanceOf(ScenarioException.class, failures.get(0));
        assertSame(before, frame());
        assertEquals(Optional.of(file), onEdt(bench::file));
    }

    @Test
    void aFileThatCannotBeWrittenIsToldAndTheChangeStaysUnsaved() {
        move();
        waitFor("the mark", bench::isChanged);
        edt(() -> bench.save(folder.resolve("no/such/folder/room.xml"), () -> begun = 7));
        waitFor("the failure", () -> !failures.isEmpty());
        assertTrue(onEdt(bench::isChanged));
        assertEquals(1, begun);
    }

    @Test
    void aSavedJournalReplaysTheRunToTheBit() throws ScenarioException {
        edt(() -> {
            bench.setSpeed(Double.POSITIVE_INFINITY);
            bench.toggleRunning();
        });
        waitFor("some time", () -> bench.frame().orElseThrow().world().tick() > 50);
        edt(() -> bench.send(new Command.SetPlatform(0.3, 0.2, 0.5)));
        edt(bench::toggleRunning);
        waitFor("the pause", () -> !bench.status().orElseThrow().running());
        Path journal = folder.resolve("journal.xml");
        edt(() -> bench.saveJournal(journal));
        waitFor("the journal", () -> Files.exists(journal));
        waitFor("the last frame", () -> bench.frame().orElseThrow().world().robot().length() == 0.3);
        String hash = Scenario.load(journal).run().trajectoryHash();
        assertEquals(String.format("%016x", frame().trajectoryHash()), hash);
    }

    @Test
    void ofTwoFilesOpenedAtOnceTheLaterOneStays() throws IOException {
        Path other = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("other.xml"));
        edt(() -> {
            bench.open(file);
            bench.open(other);
        });
        waitFor("the other file", () -> bench.file().equals(Optional.of(other)));
        assertEquals(2, begun);
    }

    private void move() {
        edt(() -> bench.send(new Command.MoveObstacle(OBSTACLE, ELSEWHERE)));
    }

    private Frame frame() {
        return onEdt(() -> bench.frame().orElseThrow());
    }

    private static Obstacle obstacle(List<Obstacle> obstacles) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals(OBSTACLE)).findFirst().orElseThrow();
    }

    private void waitFor(String what, Callable<Boolean> condition) {
        Patience.waitFor(what, () -> {
            bench.frame();
            return condition.call();
        });
    }
}
