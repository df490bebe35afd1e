package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import faultline.world.Obstacle;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
    void actionsOnTheSelectionAreEnabledIfItSuitsThem() {
        runOnEdt(() -> {
            addActions();
            assertEquals(Set.of(), enabled());
            Frame frame = SampleFrames.fullFrame();
            canvas.setFrame(frame);
            List<Obstacle> all = frame.snapshot().obstacles();
            Obstacle still = all.stream().filter(o -> !o.isMoving()).findFirst().orElseThrow();
            Obstacle moving =
                    all.stream().filter(Obstacle::isMoving).findFirst().orElseThrow();
            canvas.tools().select(Set.of(still.id()));
            assertEquals(Set.of("drawWaypoints", "cut", "copy", "duplicate", "delete"), enabled());
            canvas.tools().select(Set.of(still.id(), moving.id()));
            assertEquals(Set.of("motionSpeed", "stopMoving", "cut", "copy", "duplicate", "delete"), enabled());
            canvas.tools().select(Set.of());
            canvas.tools()
                    .selectSensor(frame.snapshot().robot().sensors().get(0).id());
            assertEquals(Set.of("duplicate", "delete"), enabled());
            canvas.tools().clearSelection();
            assertEquals(Set.of(), enabled());
        });
    }

    private Set<String> enabled() {
        return Stream.of("drawWaypoints", "motionSpeed", "stopMoving", "cut", "copy", "duplicate", "delete")
                .filter(action -> actions.get(action).isEnabled())
                .collect(Collectors.toSet());
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
        CommandSender sender = new CommandSender(run::send);
        UndoController undo = new UndoController(sender, () -> {});
        canvas = new SimulationCanvas(sender);
        SensorEditor sensors = new SensorEditor(workspace, new ScenarioEditor(run, undo), notes::add);
        ObstacleActions obstacles = new ObstacleActions(
                canvas.tools(),
                sender,
                new SensorActions(workspace, sender, sensors, canvas.tools()),
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
