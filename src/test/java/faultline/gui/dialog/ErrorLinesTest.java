package faultline.gui.dialog;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.action.Notes;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The lines of two controllers, one of which replaces the other. */
class ErrorLinesTest {

    private final List<String> shown = new ArrayList<>();
    private final ErrorLines lines = new ErrorLines(new Notes(shown::add, shown::add, shown::add, shown::remove));

    private void write(Consumer<String> controller, String line) {
        controller.accept(line);
        runOnEdt(() -> {});
    }

    @Test
    void aReloadRemovesTheLineOfTheOldController() {
        Consumer<String> old = lines.forNewController();
        runOnEdt(lines::controllerStarted);
        write(old, "old");
        assertEquals(List.of("old"), shown);
        lines.forNewController();
        runOnEdt(lines::controllerStarted);
        assertEquals(List.of(), shown);
    }

    @Test
    void theLastWordsOfTheOldControllerAreNotShown() {
        Consumer<String> old = lines.forNewController();
        runOnEdt(lines::controllerStarted);
        lines.forNewController();
        runOnEdt(lines::controllerStarted);
        write(old, "interrupted");
        assertEquals(List.of(), shown);
    }

    @Test
    void theLastWordsOfTheOldControllerDoNotDisplaceALineOfTheNewOne() {
        Consumer<String> old = lines.forNewController();
        Consumer<String> next = lines.forNewController();
        runOnEdt(() -> {
            lines.controllerStarted();
            next.accept("ready");
            old.accept("interrupted");
        });
        runOnEdt(() -> {});
        assertEquals(List.of("ready"), shown);
    }

    @Test
    void ofTwoLinesTheNewestIsShown() {
        Consumer<String> ghost = lines.forGhost();
        Consumer<String> run = lines.forNewController();
        runOnEdt(() -> {
            lines.controllerStarted();
            run.accept("run");
            ghost.accept("ghost");
            run.accept("run again");
        });
        runOnEdt(() -> {});
        assertEquals(List.of("run again"), shown);
    }

    /** Its tool tip would be wider than the screen. */
    @Test
    void aLongLineIsCut() {
        Consumer<String> ghost = lines.forGhost();
        write(ghost, "x".repeat(400));
        write(ghost, "x".repeat(401));
        assertEquals(List.of("x".repeat(400), "x".repeat(400) + "..."), shown);
    }

    @Test
    void aLineWrittenDuringTheStartStays() {
        lines.forNewController();
        runOnEdt(lines::controllerStarted);
        write(lines.forNewController(), "ready");
        runOnEdt(lines::controllerStarted);
        assertEquals(List.of("ready"), shown);
    }

    @Test
    void aControllerThatCannotStartReplacesNone() {
        Consumer<String> old = lines.forNewController();
        runOnEdt(lines::controllerStarted);
        lines.forNewController();
        write(old, "still driving");
        assertEquals(List.of("still driving"), shown);
    }

    private List<String> taken() {
        return callOnEdt(lines::takeNew);
    }

    @Test
    void theEventLogGetsTheLinesOfTheDrivingControllerAndOfGhosts() {
        Consumer<String> old = lines.forNewController();
        runOnEdt(lines::controllerStarted);
        write(old, "first");
        write(lines.forGhost(), "hello");
        write(old, "second");
        assertEquals(List.of("first", "Ghost: hello", "second"), taken());
        assertEquals(List.of(), taken());
        Consumer<String> next = lines.forNewController();
        write(next, "imports");
        write(old, "third");
        assertEquals(List.of("third"), taken(), "the next controller does not drive yet");
        runOnEdt(lines::controllerStarted);
        write(old, "last words");
        assertEquals(List.of("imports"), taken());
    }

    @Test
    void ofAFloodOnlyTheNewestLinesWait() {
        Consumer<String> controller = lines.forNewController();
        runOnEdt(lines::controllerStarted);
        for (int i = 0; i < 100_000; i++) {
            controller.accept("line " + i);
        }
        List<String> taken = taken();
        assertEquals(ErrorLines.MAX_WAITING, taken.size());
        assertEquals("line 99999", taken.get(taken.size() - 1));
    }

    @Test
    void theLinesOfAGhostStay() {
        write(lines.forGhost(), "ghost");
        lines.forNewController();
        runOnEdt(lines::controllerStarted);
        assertEquals(List.of("ghost"), shown);
    }
}
