package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.UndoController;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The lanes of an open scenario with ticks of 0.01 s, with all that edits its timeline. */
record OpenLanes(
        Workspace workspace,
        RunController run,
        UndoController undo,
        TimelineEditor editor,
        LaneView view,
        List<String> notes) {

    /** Opens the scenario and waits for its first frame. Must not be called on the EDT. */
    static OpenLanes open() {
        Workspace workspace = callOnEdt(Workspace::new);
        RunController run = callOnEdt(() -> {
            RunController created = new RunController(workspace);
            new DocumentStore(workspace).open(Path.of("scenarios/mirror.xml"));
            return created;
        });
        SessionFrames.awaitScenario(workspace);
        return callOnEdt(() -> {
            UndoController undo = new UndoController(new CommandSender(run::send), () -> {});
            List<String> notes = new ArrayList<>();
            TimelineEditor editor = new TimelineEditor(workspace, run, undo, notes::add);
            return new OpenLanes(workspace, run, undo, editor, new LaneView(editor), notes);
        });
    }

    void close() {
        runOnEdt(workspace::close);
    }

    /** Returns the times of the commands of the timeline, seconds. Must be called on the EDT. */
    List<Double> times() {
        return editor.model().commands().stream().map(TimedCommand::time).toList();
    }
}
