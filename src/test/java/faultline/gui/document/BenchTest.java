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
import faultline.sensor.Fault;
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
import java.util.concurrent.CompletableFuture;
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
    private final List<Boolean> saves = new ArrayList<>();
    private final List<Path> journals = new ArrayList<>();
    private int begun;
    private Bench bench;
    private RunDesk run;
    private Filing filing;

    @BeforeEach
    void openAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("room.xml"));
        bench = onEdt(() -> new Bench(new BenchListener() {
            @Override
            public void begun() {
                begun++;
            }

            @Override
            public void saved(Path where, boolean whole) {
                saves.add(whole);
            }

            @Override
            public void journalSaved(Path where) {
                journals.add(where);
            }

            @Override
            public void renamed() {
                assertTrue(EventQueue.isDispatchThread());
            }

            @Override
            public void failed(Task what, Path with, Throwable why) {
                failures.add(why);
            }
        }));
        edt(() -> {
            run = new RunDesk(bench);
            filing = new Filing(bench);
            filing.open(file);
        });
        waitFor("the first session", () -> begun == 1);
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void aFileOpensPausedAtTimeZeroAndUnchanged() {
        assertEquals(0, frame().world().tick());
        assertFalse(onEdt(() -> run.status().orElseThrow().running()));
        assertFalse(onEdt(bench::isChanged));
        assertEquals(Optional.of(file), onEdt(bench::file));
    }

    @Test
    void aMovedObstacleMarksTheScenarioAsChangedUntilItIsSavedAndReadsBackAsItStands() throws ScenarioException {
        move();
        waitFor("the mark", bench::isChanged);
        edt(() -> filing.save(file, () -> begun = 7));
        waitFor("the save", () -> begun == 7);
        assertFalse(onEdt(bench::isChanged));
        assertEquals(onEdt(bench::scenario), Optional.of(Scenario.load(file)));
        assertEquals(ELSEWHERE, obstacle(Scenario.load(file).setup().world().obstacles()).pose());
        assertEquals(List.of(true), saves);
    }

    @Test
    void aSaveKeepsTheCommentsOfTheFileInThatFileAndInAnother() throws IOException {
        Files.writeString(file, Files.readString(file).replace("<robot", "<!-- the robot -->\n  <robot"));
        Path other = folder.resolve("other.xml");
        move();
        waitFor("the mark", bench::isChanged);
        edt(() -> filing.save(file, () -> filing.save(other, () -> begun = 7)));
        waitFor("the saves", () -> begun == 7);
        assertTrue(Files.readString(file).contains("  <!-- the robot -->\n  <robot x="), Files.readString(file));
        assertEquals(Files.readString(file), Files.readString(other));
    }

    @Test
    void aSaveSaysWhereItLeavesOutWhatWasDoneToSensorsByHand() {
        edt(() -> send(new Command.InjectFault("left", new Fault.Stuck(0.4))));
        edt(() -> filing.save(file, () -> begun = 7));
        waitFor("the save", () -> begun == 7);
        assertEquals(List.of(false), saves);
    }

    @Test
    void aRestartGoesBackToTimeZeroWithEditsKeptAndSwitchesAsInTheFile() {
        move();
        edt(() -> {
            send(new Command.SwitchSensor("left", false));
            run.step();
        });
        waitFor("the tick", () -> run.frame().orElseThrow().world().tick() == 1);
        edt(run::restart);
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
        edt(() -> filing.open(broken));
        waitFor("the failure", () -> !failures.isEmpty());
        assertInstanceOf(ScenarioException.class, failures.get(0));
        assertSame(before, frame());
        assertEquals(Optional.of(file), onEdt(bench::file));
    }

    @Test
    void aFileThatCannotBeWrittenIsToldAndTheChangeStaysUnsaved() {
        move();
        waitFor("the mark", bench::isChanged);
        edt(() -> filing.save(folder.resolve("no/such/folder/room.xml"), () -> begun = 7));
        waitFor("the failure", () -> !failures.isEmpty());
        assertTrue(onEdt(bench::isChanged));
        assertEquals(1, begun);
    }

    @Test
    void aSavedJournalReplaysTheRunToTheBit() throws ScenarioException {
        edt(() -> {
            run.setSpeed(Double.POSITIVE_INFINITY);
            run.toggleRunning();
        });
        waitFor("some time", () -> run.frame().orElseThrow().world().tick() > 50);
        edt(() -> send(new Command.SetPlatform(0.3, 0.2, 0.5)));
        edt(run::toggleRunning);
        waitFor("the pause", () -> !run.status().orElseThrow().running());
        Path journal = folder.resolve("journal.xml");
        edt(() -> filing.saveJournal(journal));
        waitFor("the journal", () -> journals.equals(List.of(journal)));
        waitFor("the last frame", () -> run.frame().orElseThrow().world().robot().length() == 0.3);
        String hash = Scenario.load(journal).run().trajectoryHash();
        assertEquals(String.format("%016x", frame().trajectoryHash()), hash);
    }

    @Test
    void ofTwoFilesOpenedAtOnceTheLaterOneStays() throws IOException {
        Path other = Files.copy(Path.of("scenarios/office.xml"), folder.resolve("other.xml"));
        edt(() -> {
            filing.open(file);
            filing.open(other);
        });
        waitFor("the other file", () -> bench.file().equals(Optional.of(other)));
        assertEquals(2, begun);
    }

    @Test
    void whatIsEditedWhileAFileIsWrittenStaysUnsaved() {
        Work asked = onEdt(() -> bench.work().orElseThrow());
        move();
        waitFor("the mark", bench::isChanged);
        Scenario edited = onEdt(() -> bench.scenario().orElseThrow());
        edt(() -> filing.noteSaved(asked, file, asked.document().edited(), true));
        assertTrue(onEdt(bench::isChanged));
        assertEquals(edited, onEdt(() -> bench.scenario().orElseThrow()));
    }

    @Test
    void whatIsSavedElsewhereWhileTheRunBeginsAnewStaysInThatFile() {
        Path other = folder.resolve("other.xml");
        CompletableFuture<Work> made = new CompletableFuture<>();
        edt(() -> {
            Work now = bench.work().orElseThrow();
            bench.begin(Task.RESTART, file, way -> made.get());
            filing.noteSaved(now, other, now.document().edited(), true);
            made.complete(Work.begin(now.document()));
        });
        waitFor("the second session", () -> begun == 2);
        assertEquals(Optional.of(other), onEdt(bench::file));
        assertFalse(onEdt(bench::isChanged));
    }

    @Test
    void whatIsOnItsWayWhenTheBenchClosesNeverBegins() {
        CompletableFuture<Work> made = new CompletableFuture<>();
        edt(() -> {
            Document document = bench.work().orElseThrow().document();
            bench.begin(Task.OPEN, file, way -> {
                made.complete(Work.begin(document));
                return made.join();
            });
            bench.close();
        });
        Patience.waitFor("the end of a session that nobody wants", () -> made.isDone() && made.join().session().journal().isCompletedExceptionally());
        assertEquals(1, begun);
        assertEquals(Optional.empty(), onEdt(bench::file));
    }

    @Test
    void whatWasOrderedOfOneScenarioIsNotDoneToTheNext() throws IOException {
        Path other = Files.copy(file, folder.resolve("other.xml"));
        edt(() -> {
            run.restart();
            send(new Command.MoveObstacle(OBSTACLE, ELSEWHERE));
            filing.open(other);
        });
        waitFor("the other file", () -> bench.file().equals(Optional.of(other)));
        edt(run::step);
        waitFor("a tick", () -> run.frame().orElseThrow().world().tick() == 1);
        assertFalse(obstacle(frame().world().obstacles()).pose().equals(ELSEWHERE));
    }

    private void send(Command command) {
        run.send(List.of(command), outcomes -> {
        });
    }

    private void move() {
        edt(() -> send(new Command.MoveObstacle(OBSTACLE, ELSEWHERE)));
    }

    private Frame frame() {
        return onEdt(() -> run.frame().orElseThrow());
    }

    private static Obstacle obstacle(List<Obstacle> obstacles) {
        return obstacles.stream().filter(obstacle -> obstacle.id().equals(OBSTACLE)).findFirst().orElseThrow();
    }

    private void waitFor(String what, Callable<Boolean> condition) {
        Patience.waitFor(what, () -> {
            run.frame();
            return condition.call();
        });
    }
}
