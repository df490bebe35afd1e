package faultline.gui.edit;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Vector2;
import faultline.gui.Await;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.gui.document.WorkspaceListener;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.scenario.xml.ScenarioLimits;
import faultline.sensor.Fault;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;

/** Tests changes of the robot's sensors at tick 40 of a run, which is simulated again. */
@ExtendWith(EdtChecker.class)
class SensorEditorTest {

    private static final int TICKS = 40;
    private static final Command FAULT = new Command.InjectFault("left", new Fault.Stuck(0.13));

    @TempDir
    private Path folder;

    private final List<String> notes = new ArrayList<>();
    private final List<String> restored = new ArrayList<>();
    private final AtomicBoolean journalSaved = new AtomicBoolean();
    private final EditedRun edited = new EditedRun();
    private final Workspace workspace = edited.workspace();
    private final RunController run = edited.controller();
    private final DocumentStore documentStore = edited.documents();
    private final CommandSender sender = edited.sender();
    private final UndoController edits = edited.edits();
    private SensorEditor sensors;
    private SimulationSetup original;

    @BeforeEach
    void runAWhile() {
        runOnEdt(() -> {
            sensors = new SensorEditor(workspace, new ScenarioEditor(run, edits), notes::add);
            workspace.addListener(new WorkspaceListener() {
                @Override
                public void journalSaved(Path file) {
                    journalSaved.set(true);
                }
            });
        });
        original = setup();
        edited.advanceTo(TICKS);
    }

    @AfterEach
    void close() {
        edited.close();
    }

    private SimulationSetup setup() {
        return edited.scenario().setup();
    }

    private Optional<String> add() {
        Optional<String> id = callOnEdt(sensors::add);
        edited.rest();
        return id;
    }

    private Optional<String> duplicate(String id) {
        Optional<String> copy = callOnEdt(() -> sensors.duplicate(id));
        edited.rest();
        return copy;
    }

    private void remove(String id) {
        runOnEdt(() -> sensors.remove(id, restored::add));
        edited.rest();
    }

    private void send(Command command) {
        runOnEdt(() -> sender.send(command));
        Await.until("the edit", () -> !workspace.awaitsCommands());
    }

    private void assertRunIsThatOf(SimulationSetup setup) {
        assertEquals(TICKS, SessionFrames.tick(workspace));
        assertEquals(setup.robot().sensorIds(), idsInTheRun());
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            for (int i = 0; i < TICKS; i++) {
                simulation.tick();
            }
            assertEquals(simulation.trajectoryHash(), SessionFrames.trajectoryHash(workspace));
        }
    }

    private List<String> idsInTheRun() {
        return callOnEdt(() -> SessionFrames.frame(workspace).snapshot().sensors().stream()
                .map(sensor -> sensor.spec().id())
                .toList());
    }

    private static List<String> withLast(List<String> ids, String last) {
        return Stream.concat(ids.stream(), Stream.of(last)).toList();
    }

    @Test
    void aNewSensorIsReadFromTheStartOfTheRunAndUndoTakesItAway() {
        assertEquals(Optional.of("sensor-9"), add());
        assertEquals(
                withLast(original.robot().sensorIds(), "sensor-9"),
                setup().robot().sensorIds());
        assertRunIsThatOf(setup());
        assertEquals(Optional.of("Add sensor-9"), callOnEdt(edits::undoName));
        edited.undo();
        assertEquals(original, setup());
        assertRunIsThatOf(original);
        runOnEdt(edits::redo);
        edited.rest();
        assertEquals(9, idsInTheRun().size());
        assertEquals(Optional.of("sensor-10"), add());
    }

    @Test
    void aCopyComesLastSoThatTheOthersKeepTheirNumbers() {
        assertEquals(Optional.of("front-2"), duplicate("front"));
        assertEquals(withLast(original.robot().sensorIds(), "front-2"), idsInTheRun());
        SensorSpec front = original.robot().sensor("front").orElseThrow();
        SensorSpec copy = setup().robot().sensor("front-2").orElseThrow();
        assertEquals(front, copy.withId("front").withBearing(front.bearing()));
        assertEquals(Optional.empty(), duplicate("none"));
        edited.undo();
        assertEquals(original, setup());
    }

    @Test
    void theCommandsAboutARemovedSensorComeBackWithItAtTheirPlaces() {
        List<TimedCommand> timeline = List.of(
                new TimedCommand(0.1, new Command.SwitchSensor("right", false)),
                new TimedCommand(0.2, FAULT),
                new TimedCommand(0.2, new Command.SwitchSensor("right", true)),
                new TimedCommand(0.3, new Command.ClearFaults("left")),
                new TimedCommand(0.3, new Command.SwitchSensor("rear", false)));
        runOnEdt(() -> run.change(old -> old.withSetup(old.setup().withTimeline(timeline))));
        edited.rest();
        SimulationSetup before = setup();
        remove("left");
        assertEquals(List.of("Timeline entries deleted with left: 2"), notes);
        assertEquals(List.of(timeline.get(0), timeline.get(2), timeline.get(4)), setup().timeline());
        assertEquals(7, setup().robot().sensors().size());
        assertRunIsThatOf(setup());
        assertEquals(List.of(), restored);
        edited.undo();
        assertEquals(List.of("left"), restored);
        assertEquals(before, setup());
        assertRunIsThatOf(before);
    }

    @Test
    void whatWasDoneToASensorDuringTheRunIsRemovedWithItToo() {
        send(FAULT);
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        send(new Command.ConfigureSensor(farther));
        SimulationSetup before = setup();
        remove("left");
        assertEquals(1, notes.size());
        assertFalse(
                setup().timeline().stream().anyMatch(timed -> timed.command().equals(FAULT)));
        assertRunIsThatOf(setup());
        edited.undo();
        assertEquals(before, setup());
        assertEquals(farther, setup().robot().sensor("left").orElseThrow());
    }

    @Test
    void aCommandThatIsExecutedAfterItsSensorWasRemovedIsIgnored() {
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        runOnEdt(() -> {
            sender.send(List.of(FAULT, new Command.ConfigureSensor(farther)));
            sensors.remove("left", restored -> {});
        });
        edited.rest();
        Await.until("the results of the commands", () -> edits.undoName().equals(Optional.of("2 changes")));
        assertEquals(7, setup().robot().sensors().size());
        assertRunIsThatOf(setup());
        send(new Command.SwitchSensor("right", false));
        assertEquals(
                new Command.SwitchSensor("right", false),
                setup().timeline().get(setup().timeline().size() - 1).command());
    }

    @Test
    void aDeletionIsUndoneAfterAnEditOfTheSensorThatTheRunHasNotReachedAgain() {
        send(new Command.ConfigureSensor(
                original.robot().sensor("left").orElseThrow().withRange(1.5)));
        runOnEdt(() -> run.navigator().seek(10));
        edited.rest();
        SimulationSetup before = setup();
        remove("left");
        runOnEdt(() -> edits.runAdvanced(TICKS + 1));
        assertNotEquals(Optional.of("Delete left"), callOnEdt(edits::undoName), "the edit is above it again");
        runOnEdt(edits::undo);
        Await.until("the refusal", () -> edits.undoName().equals(Optional.of("Delete left")));
        edited.undo();
        assertEquals(before, setup());
    }

    /** What was done during the run acts there again, and can be undone. */
    @Test
    void settingsKeepTheirTicksWhenTheDeletionOfTheirSensorIsUndone() {
        send(new Command.ConfigureSensor(left().withRange(1.5)));
        edited.advance(20);
        send(new Command.ConfigureSensor(left().withRange(1.2)));
        edited.advance(20);
        SimulationSetup before = setup();
        long hash = SessionFrames.trajectoryHash(workspace);
        remove("left");
        edited.advance(5);
        edited.undo();
        assertEquals(before, setup());
        seek(TICKS + 40);
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        seek(10);
        assertEquals(0.8, sensorInTheRun("left").range(), "not yet changed");
        edited.advance(40);
        assertEquals(1.5, sensorInTheRun("left").range());
        runOnEdt(edits::redo);
        edited.rest();
        edited.undo();
        edited.advance(20);
        assertEquals(1.2, sensorInTheRun("left").range(), "also when the deletion was redone and undone");
        undoAllEdits();
        assertEquals(original, setup());
    }

    private SensorSpec left() {
        return original.robot().sensor("left").orElseThrow();
    }

    /** Nothing of the run before the restart is left but the scenario. */
    @Test
    void settingsHoldFromTheStartAfterARestartWithoutTheirSensor() {
        send(new Command.ConfigureSensor(left().withRange(1.5)));
        SimulationSetup before = setup();
        remove("left");
        runOnEdt(run::restart);
        edited.rest();
        edited.undo();
        assertEquals(before, setup());
        assertEquals(1.5, sensorInTheRun("left").range());
        undoAllEdits();
        assertEquals(original, setup());
    }

    @Test
    void anotherSensorOfTheIdOfADeletedOneHasNoneOfItsSettings() {
        add();
        SensorSpec added = setup().robot().sensor("sensor-9").orElseThrow();
        send(new Command.ConfigureSensor(added.withRange(1.5)));
        remove("sensor-9");
        SensorSpec other = callOnEdt(() -> sensors.add(1.0))
                .flatMap(id -> setup().robot().sensor(id))
                .orElseThrow();
        edited.rest();
        edited.advance(20);
        assertEquals("sensor-9", other.id());
        assertEquals(other, setup().robot().sensor("sensor-9").orElseThrow());
        assertEquals(other, sensorInTheRun("sensor-9"));
        undoAllEdits();
        assertEquals(original, setup());
    }

    /** The run has not reached the settings when it is continued in another way. */
    @Test
    void settingsThatAnEarlierEditHasDroppedDoNotReturnWithTheirSensor() {
        send(new Command.ConfigureSensor(left().withRange(1.5)));
        seek(10);
        remove("left");
        send(new Command.SetPlatform(0.2, 0.15, 0.3));
        edited.undo();
        edited.undo();
        assertEquals(original.robot().sensors(), setup().robot().sensors());
        edited.advance(60);
        assertEquals(0.8, sensorInTheRun("left").range());
        assertRunIsAsPlanned();
    }

    private void assertRunIsAsPlanned() {
        assertEquals(
                setup().robot().sensors(),
                SessionFrames.frame(workspace).snapshot().robot().sensors());
    }

    @Test
    void settingsFollowAnotherNameOfTheirSensorThroughItsDeletion() {
        send(new Command.ConfigureSensor(left().withRange(1.5)));
        edited.advance(10);
        rename("left", "port");
        remove("port");
        rename("right", "port");
        edited.undo();
        edited.undo();
        edited.undo();
        seek(10);
        assertEquals(0.8, sensorInTheRun("left").range());
        edited.advance(60);
        assertEquals(1.5, sensorInTheRun("left").range());
        undoAllEdits();
        assertEquals(original, setup());
    }

    private Optional<String> rename(String id, String newId) {
        Optional<String> refusal = callOnEdt(() -> sensors.rename(id, newId));
        edited.rest();
        return refusal;
    }

    /** Returns a timeline with one command of each kind about a sensor, and one about another. */
    private List<TimedCommand> timelineAbout(String id) {
        SensorSpec nearer =
                original.robot().sensor("left").orElseThrow().withId(id).withRange(0.7);
        return List.of(
                new TimedCommand(0.1, new Command.SwitchSensor("right", false)),
                new TimedCommand(0.2, new Command.InjectFault(id, new Fault.Stuck(0.13))),
                new TimedCommand(0.25, new Command.ClearFault(id, new Fault.Stuck(0.13))),
                new TimedCommand(0.3, new Command.ClearFaults(id)),
                new TimedCommand(0.3, new Command.SwitchSensor(id, true)),
                new TimedCommand(0.35, new Command.ConfigureSensor(nearer)));
    }

    @Test
    void aRenamedSensorKeepsItsPlaceAndAllThatNamesIt() {
        runOnEdt(() -> run.change(old -> old.withSetup(old.setup().withTimeline(timelineAbout("left")))));
        edited.rest();
        SimulationSetup before = setup();
        long hash = SessionFrames.trajectoryHash(workspace);
        assertEquals(Optional.empty(), rename("left", "port side"));
        List<SensorSpec> sensors = new ArrayList<>(original.robot().sensors());
        sensors.set(2, sensors.get(2).withId("port side"));
        assertEquals(sensors, setup().robot().sensors());
        assertEquals(timelineAbout("port side"), setup().timeline());
        assertRunIsThatOf(setup());
        assertEquals(hash, SessionFrames.trajectoryHash(workspace), "the name has no influence on the run");
        assertEquals(Optional.of("Rename left to port side"), callOnEdt(edits::undoName));
        edited.undo();
        assertEquals(before, setup());
        assertRunIsThatOf(before);
        runOnEdt(edits::redo);
        edited.rest();
        assertEquals("port side", idsInTheRun().get(2));
    }

    @Test
    void aFileWithARenamedSensorIsValidAndRunsAsBefore() throws ScenarioException {
        String hash = Scenario.load(Path.of("scenarios/office.xml")).run().trajectoryHash();
        send(FAULT);
        edited.undo();
        rename("front", "a & <b> 'ä'");
        rename("rear", "front");
        Path file = folder.resolve("renamed.xml");
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> !workspace.isChanged());
        Scenario saved = Scenario.load(file);
        assertEquals(setup(), saved.setup());
        assertEquals(
                hash,
                saved.withSetup(saved.setup().withTimeline(original.timeline()))
                        .run()
                        .trajectoryHash());
    }

    @Test
    void anIdThatIsTakenOrThatAFileCannotHaveIsRefused() {
        String invalid = "An id has 1 to 100 characters, none of them a comma, a double quote or a control character";
        assertEquals(Optional.of("The robot already has a sensor with the id rear"), rename("left", "rear"));
        for (String wrong : List.of("", "a,b", "a\"b", "a\tb", "x".repeat(101))) {
            assertEquals(Optional.of(invalid), rename("left", wrong), wrong);
        }
        assertEquals(Optional.empty(), rename("left", "left"));
        assertEquals(Optional.empty(), rename("none", "other"));
        assertEquals(original, setup());
        assertEquals(Optional.empty(), callOnEdt(edits::undoName));
        assertEquals(Optional.empty(), rename("left", "x".repeat(100)));
        assertEquals("x".repeat(100), setup().robot().sensorIds().get(2));
    }

    /** What was done during the run stays there: nothing holds from the start, and all of it can be undone. */
    @Test
    void theCommandsOfTheRunKeepTheirTicksWhenTheirSensorIsRenamed() {
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        send(new Command.ConfigureSensor(farther));
        send(FAULT);
        edited.advance(20);
        long hash = SessionFrames.trajectoryHash(workspace);
        rename("left", "port");
        assertEquals(hash, SessionFrames.trajectoryHash(workspace));
        assertEquals(
                new Command.InjectFault("port", new Fault.Stuck(0.13)),
                setup().timeline().get(setup().timeline().size() - 1).command());
        seek(10);
        assertEquals(0.8, sensorInTheRun("port").range(), "not yet changed");
        edited.advance(60);
        assertEquals(1.5, sensorInTheRun("port").range());
        undoAllEdits();
        assertEquals(original, setup());
    }

    /** An edit that is redone as the run reaches its tick has the id that the sensor has by then. */
    @Test
    void anEditThatTheRunReachesAgainAfterARenamingCanBeUndone() {
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        send(new Command.ConfigureSensor(farther));
        seek(10);
        rename("left", "port");
        edited.advance(60);
        assertEquals(1.5, sensorInTheRun("port").range());
        assertEquals(Optional.of("Range of port"), callOnEdt(edits::undoName));
        runOnEdt(edits::undo);
        Await.until("the undo", () -> edits.undoName().equals(Optional.of("Rename left to port")));
        edited.advance(1);
        assertEquals(0.8, sensorInTheRun("port").range());
        seek(5);
        edited.undo();
        assertEquals(original, setup());
        edited.advance(60);
        assertEquals(1.5, sensorInTheRun("left").range(), "again as when the edit was made");
        undoAllEdits();
        assertEquals(original, setup());
    }

    @Test
    void aCommandThatIsOnItsWayWhenItsSensorIsRenamedIsNotLost() {
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        runOnEdt(() -> {
            sender.send(new Command.ConfigureSensor(farther));
            sensors.rename("left", "port");
            sender.send(FAULT);
        });
        edited.rest();
        Await.until("both commands", () -> edits.undoName().equals(Optional.of("Fault in port")));
        assertEquals(1.5, setup().robot().sensor("port").orElseThrow().range());
        assertEquals(
                new Command.InjectFault("port", new Fault.Stuck(0.13)),
                setup().timeline().get(setup().timeline().size() - 1).command());
        undoAllEdits();
        assertEquals(original.robot(), setup().robot());
    }

    /** The run still has the old id, so what the window shows can be used, and what was done before can be undone. */
    @Test
    void aSensorCanBeUsedAfterTheSimulationOfItsRenamingWasCancelled() {
        SensorSpec farther = original.robot().sensor("left").orElseThrow().withRange(1.5);
        send(new Command.ConfigureSensor(farther));
        runOnEdt(() -> {
            sensors.rename("left", "middle");
            sensors.rename("middle", "port");
            workspace.cancelTask();
        });
        assertEquals("left", idsInTheRun().get(2));
        send(FAULT);
        assertEquals(Optional.of("Fault in port"), callOnEdt(edits::undoName));
        send(new Command.SwitchSensor("port", false));
        assertFalse(sensorInTheRun("left").on());
        List<TimedCommand> timeline = setup().timeline();
        assertEquals(
                List.of(
                        new Command.InjectFault("port", new Fault.Stuck(0.13)),
                        new Command.SwitchSensor("port", false)),
                timeline.subList(original.timeline().size(), timeline.size()).stream()
                        .map(TimedCommand::command)
                        .toList());
        seek(TICKS);
        assertFalse(sensorInTheRun("port").on());
        undoAllEdits();
        assertEquals(original, setup());
    }

    private SensorSpec sensorInTheRun(String id) {
        return callOnEdt(() ->
                SessionFrames.frame(workspace).snapshot().robot().sensor(id).orElseThrow());
    }

    private void seek(long tick) {
        runOnEdt(() -> run.navigator().seek(tick));
        edited.rest();
    }

    private void undoAllEdits() {
        for (int i = 0; i < 10; i++) {
            edited.undo();
            Await.until("the undo", () -> !workspace.awaitsCommands());
        }
        assertEquals(Optional.empty(), callOnEdt(edits::undoName));
    }

    @Test
    void theJournalOfAChangedRunRepeatsIt() throws ScenarioException {
        send(FAULT);
        add();
        remove("right");
        send(new Command.SwitchSensor("sensor-9", false));
        for (int i = 0; i < 60; i++) {
            runOnEdt(run::step);
        }
        SessionFrames.awaitTick(workspace, TICKS + 60);
        Path file = folder.resolve("journal.xml");
        runOnEdt(() -> documentStore.saveJournal(file));
        Await.until("the journal", journalSaved::get);
        Scenario journal = Scenario.load(file);
        assertEquals(setup().robot().sensorIds(), journal.setup().robot().sensorIds());
        assertEquals(
                String.format("%016x", SessionFrames.trajectoryHash(workspace)),
                journal.run().trajectoryHash());
    }

    @Test
    void aRobotWithoutSensorsIsSavedAndOpenedAgain() throws ScenarioException {
        original.robot().sensorIds().forEach(this::remove);
        assertEquals(List.of(), idsInTheRun());
        assertRunIsThatOf(setup());
        Path file = folder.resolve("blind.xml");
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> !workspace.isChanged());
        assertEquals(setup(), Scenario.load(file).setup());
        assertEquals(Optional.of("sensor-1"), add());
        assertEquals(0, setup().robot().sensors().get(0).bearing(), "straight ahead");
    }

    @Test
    void oneRemovedSensorStaysRemovedInTheFile() throws ScenarioException {
        remove("rear");
        Path file = folder.resolve("seven.xml");
        runOnEdt(() -> documentStore.save(file, () -> {}));
        Await.until("the save", () -> !workspace.isChanged());
        assertEquals(setup(), Scenario.load(file).setup());
    }

    @Test
    void aRobotHasNoMoreSensorsThanAFileMayHave() {
        SensorSpec front = original.robot().sensor("front").orElseThrow();
        RobotSpec full = original.robot()
                .withSensors(IntStream.range(0, ScenarioLimits.MAX_SENSORS)
                        .mapToObj(i -> front.withId("s" + i).withMountPosition(new Vector2(0.1, 0)))
                        .toList());
        runOnEdt(() -> run.change(old -> old.withSetup(old.setup().withRobot(full))));
        edited.rest();
        assertEquals(Optional.empty(), add());
        assertEquals(Optional.empty(), duplicate("s0"));
        String note = "A robot can have at most " + ScenarioLimits.MAX_SENSORS + " sensors";
        assertEquals(List.of(note, note), notes);
        assertEquals(full, setup().robot());
        remove("s7");
        assertTrue(add().isPresent());
        assertNotEquals(full, setup().robot());
    }

    @Test
    void sensorsThatAreAddedDuringADragAreEditsOfTheirOwn() {
        RobotSpec before = setup().robot();
        runOnEdt(sender::beginGesture);
        add();
        RobotSpec between = setup().robot();
        add();
        runOnEdt(sender::endGesture);
        runOnEdt(edits::undo);
        edited.rest();
        assertEquals(between, setup().robot());
        runOnEdt(edits::undo);
        edited.rest();
        assertEquals(before, setup().robot());
    }

    /** Each switch is a command of the timeline. */
    @Test
    void allSwitchesDuringADragAreUndoneAfterARestart() {
        runOnEdt(sender::beginGesture);
        for (boolean on : List.of(false, true, false)) {
            runOnEdt(() -> sender.send(new Command.SwitchSensor("left", on)));
            Await.until("the switch", () -> !workspace.awaitsCommands());
            runOnEdt(run::step);
        }
        runOnEdt(sender::endGesture);
        SessionFrames.awaitTick(workspace, TICKS + 3);
        runOnEdt(run::restart);
        edited.rest();
        assertEquals(3, setup().timeline().size());
        while (callOnEdt(edits::canUndo)) {
            runOnEdt(edits::undo);
            edited.rest();
        }
        assertEquals(List.of(), setup().timeline());
    }
}
