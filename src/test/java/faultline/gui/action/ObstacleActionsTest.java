package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class ObstacleActionsTest {

    private static final String CIRCLE = "Add a circle: click, drag from corner to corner, or arrow keys and Enter";
    private static final String ELLIPSE = "Add an ellipse: click, drag from corner to corner, or arrow keys and Enter";

    private final ActionRegistry actions = new ActionRegistry();
    private final List<String> notes = new ArrayList<>();
    private SimulationCanvas canvas;

    @Test
    void theNoteAboutAToolDisappearsWithTheTool() {
        runOnEdt(() -> {
            addActions();
            assertNotesAfter("placeCircle", CIRCLE);
            assertNotesAfter("placeEllipse", ELLIPSE);
            assertNotesAfter("select");
        });
    }

    @Test
    void anActionOnTheSelectionAsksForOneIfNothingIsSelected() {
        runOnEdt(() -> {
            addActions();
            for (String action : List.of("cut", "copy", "duplicate", "delete")) {
                assertNotesAfter(
                        action,
                        action.startsWith("d") ? "Select an obstacle or a sensor first" : "Select an obstacle first");
                notes.clear();
            }
        });
    }

    @Test
    void beforeThereIsAWorldNothingIsPasted() {
        runOnEdt(() -> {
            addActions();
            assertNotesAfter("paste");
        });
    }

    @Test
    void theNoteAboutARefusedPasteDisappearsWithTheNextPaste() {
        runOnEdt(() -> {
            ObstacleActions obstacles = addActions();
            canvas.setFrame(SampleFrames.fullFrame());
            obstacles.paste("<desk/>");
            assertEquals(1, notes.size());
            assertTrue(notes.get(0).startsWith("Not pasted: "), notes.get(0));
            obstacles.paste("<circle id=\"pole\" x=\"1\" y=\"1\" radius=\"0.1\"/>");
            assertEquals(List.of(), notes);
        });
    }

    private ObstacleActions addActions() {
        Theme.LIGHT.install();
        Workspace workspace = new Workspace();
        RunController run = new RunController(workspace);
        UndoController edits = new UndoController(run::send, () -> {});
        canvas = new SimulationCanvas(edits);
        SensorEditor sensors = new SensorEditor(workspace, new ScenarioEditor(run, edits), notes::add);
        ObstacleActions obstacles = new ObstacleActions(
                canvas.tools(),
                edits,
                new SensorActions(workspace, edits, sensors, canvas.tools()),
                new Notes(notes::add, notes::remove),
                now -> OptionalDouble.empty(),
                WindowPreferences.nonPersistent());
        obstacles.addTo(actions);
        return obstacles;
    }

    private void assertNotesAfter(String action, String... expected) {
        actions.get(action).actionPerformed(null);
        assertEquals(List.of(expected), notes);
    }
}
