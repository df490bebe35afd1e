package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
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
                assertNotesAfter(action, "Select an obstacle first");
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

    private void addActions() {
        Theme.LIGHT.install();
        UndoController edits = new UndoController(new RunController(new Workspace())::send, () -> {});
        new ObstacleActions(
                        new SimulationCanvas(edits).tools(),
                        edits,
                        new Notes(notes::add, notes::remove),
                        now -> OptionalDouble.empty(),
                        WindowPreferences.nonPersistent())
                .addTo(actions);
    }

    private void assertNotesAfter(String action, String... expected) {
        actions.get(action).actionPerformed(null);
        assertEquals(List.of(expected), notes);
    }
}
