package faultline.gui.document;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.gui.Patience;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What becomes of edits when the program dies, when they are given up, and when somebody else writes the file. */
class CrashTest {

    /** No process has such a number. */
    private static final long DEAD = Integer.MAX_VALUE - 7;
    private static final Pose ELSEWHERE = new Pose(2, 3, 0);

    @TempDir
    private Path folder;
    private Path file;
    private Bench bench;
    private RunDesk run;
    private Filing filing;
    private final List<Path> told = new ArrayList<>();
    private final List<ScenarioException> broken = new ArrayList<>();

    @BeforeEach
    void openAFile() throws IOException {
        file = Files.copy(Path.of("scenarios/collision-on-purpose.xml"), folder.resolve("room.xml"));
        bench = onEdt(() -> new Bench(new Quiet()));
        edt(() -> {
            run = new RunDesk(bench);
            filing = new Filing(bench);
            filing.open(file);
        });
        waitForTheFile();
    }

    @AfterEach
    void close() {
        edt(bench::close);
    }

    @Test
    void unsavedEditsOutliveACrashAndAreStillUnsavedThen() throws Exception {
        edit();
        Scenario edited = onEdt(() -> bench.scenario().orElseThrow());
        Recovery dying = new Recovery(folder.resolve("kept"), DEAD, Instant.EPOCH);
        autosave(dying);
        Patience.waitFor("the kept edits", () -> dying.left().isPresent());
        Recovery.Rescue rescue = new Recovery(folder.resolve("kept")).left().orElseThrow();
        assertEquals(Optional.of(file.toAbsolutePath()), rescue.origin());
        assertEquals(edited, rescue.scenario());
        edt(() -> filing.open(file));
        Patience.waitFor("the file without the edits", () -> !bench.scenario().equals(Optional.of(edited)));
        edt(() -> filing.recover(rescue));
        Patience.waitFor("the edits", () -> bench.scenario().equals(Optional.of(edited)));
        assertTrue(onEdt(bench::isChanged));
        assertEquals(Optional.of(Scenario.load(file)), onEdt(bench::saved), "what the file holds is known, so nobody has changed it");
        assertEquals(rescue.origin(), onEdt(bench::file));
    }

    @Test
    void theEditsOfAWindowThatStillRunsAreNotOffered() throws IOException {
        Recovery own = new Recovery(folder.resolve("kept"));
        own.keep(Optional.empty(), onEdt(() -> bench.scenario().orElseThrow()));
        assertEquals(Optional.empty(), own.left());
    }

    @Test
    void editsOfAProcessWhoseNumberAnotherHasByNowAreOfferedUntilTheyAreAnswered() throws IOException {
        Recovery before = new Recovery(folder.resolve("kept"), ProcessHandle.current().pid(), Instant.EPOCH);
        before.keep(Optional.of(file), onEdt(() -> bench.scenario().orElseThrow()));
        Recovery own = new Recovery(folder.resolve("kept"));
        own.keep(Optional.empty(), onEdt(() -> bench.scenario().orElseThrow()));
        own.forget();
        Recovery.Rescue rescue = own.left().orElseThrow();
        assertEquals(Optional.of(file.toAbsolutePath()), rescue.origin());
        own.adopt(rescue);
        assertEquals(Optional.empty(), own.left());
        assertEquals(2, kept().size(), "they are this process's own now: " + kept());
    }

    private List<Path> kept() throws IOException {
        try (Stream<Path> kept = Files.list(folder.resolve("kept"))) {
            return kept.toList();
        }
    }

    @Test
    void editsThatCouldNotBeKeptAreKeptAsSoonAsTheyCanBe() throws IOException {
        Recovery dying = new Recovery(folder.resolve("kept"), DEAD, Instant.EPOCH);
        Path obstacle = Files.createFile(folder.resolve("kept"));
        AtomicBoolean failed = new AtomicBoolean();
        Logger log = Logger.getLogger(Autosave.class.getName());
        log.setFilter(record -> {
            failed.set(true);
            return false;
        });
        edit();
        Autosave autosave = autosave(dying);
        Patience.waitFor("the failure", failed::get);
        log.setFilter(null);
        Files.delete(obstacle);
        edt(autosave::keep);
        Patience.waitFor("the kept edits", () -> dying.left().isPresent());
    }

    @Test
    void savedEditsAreKeptNoLonger() {
        Recovery dying = new Recovery(folder.resolve("kept"), DEAD, Instant.EPOCH);
        edit();
        Autosave autosave = autosave(dying);
        Patience.waitFor("the kept edits", () -> dying.left().isPresent());
        edt(() -> filing.save(file, autosave::keep));
        Patience.waitFor("nothing to be kept", () -> dying.left().isEmpty());
    }

    @Test
    void aWindowThatClosesInGoodOrderLeavesNothingAndWritesNothingAfterwards() throws IOException {
        Recovery dying = new Recovery(folder.resolve("kept"), DEAD, Instant.EPOCH);
        edit();
        Autosave autosave = autosave(dying);
        Patience.waitFor("the kept edits", () -> dying.left().isPresent());
        edt(autosave::close);
        Patience.waitFor("an empty folder", () -> kept().isEmpty());
        autosave.write(Optional.empty(), onEdt(bench::scenario));
        assertEquals(List.of(), kept());
    }

    @Test
    void revertingGivesEditsUp() {
        Scenario before = onEdt(() -> bench.scenario().orElseThrow());
        edit();
        edt(filing::revert);
        Patience.waitFor("the scenario as it was", () -> bench.scenario().equals(Optional.of(before)));
        assertFalse(onEdt(bench::isChanged));
    }

    @Test
    void anotherScenarioInTheFileIsToldOnce() throws IOException {
        FileWatch watch = onEdt(() -> new FileWatch(bench, told::add, broken::add));
        look(watch, 3);
        assertEquals(List.of(), told);
        rewrite(Files.readString(file).replaceFirst("seed=\"\\d+\"", "").replaceFirst("<scenario ", "<scenario seed=\"4711\" "));
        look(watch, 1);
        assertEquals(List.of(), told, "the file may still be growing");
        look(watch, 4);
        assertEquals(List.of(file), told);
        edt(watch::close);
    }

    @Test
    void theSameScenarioWrittenOtherwiseIsNotTold() throws IOException {
        FileWatch watch = onEdt(() -> new FileWatch(bench, told::add, broken::add));
        rewrite(Files.readString(file).replace("\n", "\n\n"));
        look(watch, 4);
        assertEquals(List.of(), told);
        edt(watch::close);
    }

    @Test
    void aFileThatSomebodyBreaksIsToldOnceAndReadAgainWhenItIsMended() throws IOException {
        FileWatch watch = onEdt(() -> new FileWatch(bench, told::add, broken::add));
        String whole = Files.readString(file);
        rewrite("<scenario");
        look(watch, 1);
        assertEquals(List.of(), broken, "the file may still be growing");
        look(watch, 4);
        assertEquals(1, broken.size());
        assertEquals(1, broken.get(0).complaints().get(0).place().line());
        assertEquals(List.of(), told);
        assertTrue(onEdt(() -> bench.scenario().isPresent()), "what is open stays");
        assertTrue(onEdt(bench::isChanged), "no file holds it now");
        rewrite(whole);
        look(watch, 4);
        assertFalse(onEdt(bench::isChanged));
        assertEquals(List.of(), told, "it is what is open");
        rewrite(whole.replaceFirst("seed=\"\\d+\"", "").replaceFirst("<scenario ", "<scenario seed=\"4711\" "));
        look(watch, 4);
        assertEquals(List.of(file), told);
        assertEquals(1, broken.size());
        edt(watch::close);
    }

    private void rewrite(String text) throws IOException {
        Files.writeString(file, text);
        Files.setLastModifiedTime(file, FileTime.fromMillis(Files.getLastModifiedTime(file).toMillis() + 5000));
    }

    private static void look(FileWatch watch, int times) {
        for (int i = 0; i < times; i++) {
            edt(watch::look);
            Patience.waitFor("the end of a look", () -> !watch.isLooking());
        }
    }

    private Autosave autosave(Recovery recovery) {
        Autosave autosave = onEdt(() -> new Autosave(bench, recovery));
        edt(autosave::keep);
        return autosave;
    }

    private void send(Command command) {
        run.send(List.of(command), outcomes -> {
        });
    }

    private void edit() {
        edt(() -> send(new Command.MoveObstacle("pole", ELSEWHERE)));
        Patience.waitFor("the edit", () -> {
            run.frame();
            return bench.isChanged();
        });
    }

    private void waitForTheFile() {
        Patience.waitFor("the scenario", () -> bench.scenario().isPresent());
    }

    /** Nothing here fails. */
    private static final class Quiet implements BenchListener {
        @Override
        public void begun() {
            // Asked for.
        }

        @Override
        public void renamed() {
            // Asked for.
        }

        @Override
        public void failed(Task what, Path with, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
