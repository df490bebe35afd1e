package faultline.gui.document;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup;
import faultline.external.ControllerChoice;
import faultline.external.ExternalController;
import faultline.external.ProcessControllerSource;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.scenario.Scenario;
import faultline.world.Command;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Programs that never answer, with time limits that exceed that of the tests, so that only the user ends them. */
@ExtendWith(EdtChecker.class)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the child is a shell script")
class HangingControllerTest {

    private static final ExternalController.Timeouts LONG = new ExternalController.Timeouts(1000, 1000);

    private static final Command OFF = new Command.SwitchSensor("left", false);

    /** Answers the observations before tick ANSWERS and hangs then, or as soon as its input is closed. */
    private static final String PROGRAM =
            """
            read hello
            echo $$ > 'PID'
            i=0
            [ ANSWERS -lt 0 ] || echo '{"type":"ready","protocol":1,"name":"program"}'
            while [ $i -lt ANSWERS ] && read line; do
              echo "{\\"type\\":\\"drive\\",\\"tick\\":$i,\\"left_v\\":1,\\"right_v\\":1}"
              i=$((i+1))
            done
            [ $i -lt ANSWERS ] || { read line; : > 'PID.hangs'; }
            while :; do sleep 0.1; done
            """;

    @TempDir
    private Path folder;

    private final List<Throwable> failures = new ArrayList<>();
    private int sessionCount;
    private int pauseRequests;
    private int programs;
    private Workspace workspace;
    private RunController run;
    private DocumentStore documentStore;

    @BeforeEach
    void open() throws IOException {
        Path file = Files.copy(Path.of("scenarios/yard.xml"), folder.resolve("room.xml"));
        workspace = callOnEdt(Workspace::new);
        runOnEdt(() -> {
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void sessionStarted() {
                    sessionCount++;
                }

                @Override
                public void pauseRequested() {
                    pauseRequests++;
                }

                @Override
                public void taskFailed(TaskKind task, Path taskFile, Throwable failure) {
                    failures.add(failure);
                }
            });
            run = new RunController(workspace);
            documentStore = new DocumentStore(workspace);
            documentStore.open(file);
        });
        awaitSession(1);
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
        assertEquals(List.of(), failures);
    }

    private void awaitSession(int number) {
        Await.until("session " + number, () -> sessionCount == number);
    }

    private UnaryOperator<SimulationSetup> program(int answers) throws IOException {
        programs++;
        String text = PROGRAM.replace("ANSWERS", Integer.toString(answers))
                .replace("PID", pidFile().toString());
        String command = "sh '" + Files.writeString(folder.resolve(programs + ".sh"), text) + "'";
        ProcessControllerSource.ChildSettings settings =
                new ProcessControllerSource.ChildSettings("test", "Yard", LONG, false, line -> {});
        return setup -> ControllerChoice.of(command).applyTo(setup, new ProcessControllerSource(command, settings));
    }

    private Path pidFile() {
        return folder.resolve(programs + ".pid");
    }

    private ProcessHandle runningProgram() throws IOException {
        Path file = pidFile();
        Await.until("the program", () -> Files.exists(file) && Files.size(file) > 0);
        return ProcessHandle.of(Long.parseLong(Files.readString(file).strip())).orElseThrow();
    }

    private static void awaitEnd(ProcessHandle program) {
        Await.until("the end of the program", () -> !program.isAlive());
    }

    private void choose(UnaryOperator<SimulationSetup> choice) {
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) -> choice.apply(setup));
            run.restart();
        });
    }

    /** Lets a program hang at tick 3, and sends an edit that it keeps from being made. */
    private ProcessHandle hangWithAnEdit() throws IOException {
        choose(program(3));
        awaitSession(2);
        ProcessHandle program = runningProgram();
        runOnEdt(run::toggleRunning);
        // The frame of the last tick may not be shown.
        Await.until("the last answer", () -> Files.exists(Path.of(pidFile() + ".hangs")));
        runOnEdt(() -> run.send(List.of(OFF), results -> {}));
        return program;
    }

    private void assertEdited() {
        Scenario edited = callOnEdt(() -> workspace.scenario().orElseThrow());
        assertTrue(
                edited.setup().timeline().stream()
                        .anyMatch(event -> event.command().equals(OFF)),
                () -> edited.setup().timeline().toString());
    }

    @Test
    void aCancelledStartEndsItsProgram() throws Exception {
        choose(program(-1));
        ProcessHandle program = runningProgram();
        runOnEdt(workspace::cancelTask);
        awaitEnd(program);
        assertEquals(1, callOnEdt(() -> sessionCount));
    }

    @Test
    void aStartThatAnotherOneReplacesEndsItsProgram() throws Exception {
        choose(program(-1));
        ProcessHandle program = runningProgram();
        choose(program(3));
        awaitEnd(program);
        awaitSession(2);
    }

    @Test
    void aGhostThatIsRemovedWhileItsProgramStartsEndsIt() throws Exception {
        ComparisonController comparison = callOnEdt(() -> new ComparisonController(workspace, run.navigator()));
        program(-1);
        String command = "sh '" + folder.resolve(programs + ".sh") + "'";
        runOnEdt(() -> comparison.compareWith(ControllerChoice.of(command), line -> {}, setup -> {}));
        ProcessHandle program = runningProgram();
        long removed = System.nanoTime();
        runOnEdt(comparison::removeReference);
        awaitEnd(program);
        assertTrue(System.nanoTime() - removed < 20e9, "by the limit for the start");
    }

    @Test
    void aGhostWhoseProgramStartsEndsWithItsWindow() throws Exception {
        ComparisonController comparison = callOnEdt(() -> new ComparisonController(workspace, run.navigator()));
        program(-1);
        String command = "sh '" + folder.resolve(programs + ".sh") + "'";
        runOnEdt(() -> comparison.compareWith(ControllerChoice.of(command), line -> {}, setup -> {}));
        ProcessHandle program = runningProgram();
        long closed = System.nanoTime();
        runOnEdt(() -> {
            workspace.close();
            assertTrue(comparison.pending().isEmpty());
        });
        awaitEnd(program);
        assertTrue(System.nanoTime() - closed < 20e9, "by the limit for the start");
    }

    @Test
    void aPauseThatHasToWaitForAProgramIsAnnounced() throws Exception {
        ProcessHandle program = hangWithAnEdit();
        assertEquals(0, callOnEdt(() -> pauseRequests), "resumed only");
        runOnEdt(run::toggleRunning);
        assertEquals(1, callOnEdt(() -> pauseRequests));
        assertTrue(callOnEdt(() -> workspace.session().orElseThrow().status()).running(), "still");
        choose(UnaryOperator.identity());
        awaitSession(3);
        awaitEnd(program);
        runOnEdt(run::step);
        assertEquals(1, callOnEdt(() -> pauseRequests), "a step of a run that is paused");
    }

    @Test
    void aRestartEndsAProgramThatHangsAndKeepsTheEdits() throws Exception {
        ProcessHandle program = hangWithAnEdit();
        choose(program(3));
        awaitSession(3);
        awaitEnd(program);
        assertEdited();
        runOnEdt(run::step);
        SessionFrames.awaitTick(workspace, 1);
    }

    @Test
    void theScenariosControllerReplacesAProgramThatHangs() throws Exception {
        ProcessHandle program = hangWithAnEdit();
        choose(UnaryOperator.identity());
        awaitSession(3);
        awaitEnd(program);
        assertEdited();
    }

    @Test
    void anotherScenarioIsOpenedAndTheProgramThatHangsEnds() throws Exception {
        ProcessHandle program = hangWithAnEdit();
        runOnEdt(() -> {
            workspace.setControllerChoice((setup, name) -> setup);
            documentStore.openShipped("office.xml");
        });
        awaitSession(3);
        awaitEnd(program);
    }

    @Test
    void aRestartThatIsCancelledLeavesTheRunFailedWithItsEdits() throws Exception {
        ProcessHandle program = hangWithAnEdit();
        choose(program(-1));
        awaitEnd(program);
        ProcessHandle second = runningProgram();
        runOnEdt(workspace::cancelTask);
        awaitEnd(second);
        assertEdited();
        assertEquals(
                "the run was interrupted at tick 3",
                callOnEdt(() -> workspace.session().orElseThrow().status())
                        .failure()
                        .orElseThrow()
                        .toString());
        AtomicInteger answers = new AtomicInteger();
        runOnEdt(() ->
                run.send(List.of(new Command.SwitchSensor("front", false)), results -> answers.set(results.size())));
        Await.until("an edit of the failed run", () -> answers.get() == 1);
    }
}
