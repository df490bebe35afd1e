package faultline.gui.action;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.RunController;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.edit.SensorEditor;
import faultline.gui.edit.UndoController;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.theme.Theme;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WaypointPath;
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
    private final List<Command> commands = new ArrayList<>();
    private OptionalDouble speed = OptionalDouble.empty();
    /** Runs while the dialog for a speed is open. */
    private Runnable whileAsked = () -> {};

    private CommandSender sender;
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

    @Test
    void aMoveThatTheRunHasNotAnsweredIsKept() {
        runOnEdt(() -> {
            addActions();
            Obstacle moving = selectMoving();
            Obstacle moved = moving.withPose(new Pose(0.5, 0.5, 0));
            sender.send(new Command.MoveObstacle(moving.id(), moved.pose()));
            speed = OptionalDouble.of(1.5);
            actions.get("motionSpeed").actionPerformed(null);
            actions.get("stopMoving").actionPerformed(null);
            actions.get("duplicate").actionPerformed(null);
            assertEquals(moved.withMotion(moving.motion().withSpeed(1.5)), placed(1));
            assertEquals(moved.withMotion(WaypointPath.NONE), placed(2));
            assertFalse(placed(3).isMoving(), "a copy of the one that stands still");
        });
    }

    @Test
    void anObstacleThatIsBeingRemovedStaysRemoved() {
        runOnEdt(() -> {
            addActions();
            selectMoving();
            actions.get("delete").actionPerformed(null);
            actions.get("stopMoving").actionPerformed(null);
            assertEquals(1, commands.size());
        });
    }

    /** The run goes forward while the dialog is open. */
    @Test
    void anObstacleThatIsMovedWhileTheSpeedIsAskedStaysThere() {
        runOnEdt(() -> {
            addActions();
            Obstacle moving = selectMoving();
            Obstacle moved = moving.withPose(new Pose(0.5, 0.5, 0));
            speed = OptionalDouble.of(1.5);
            whileAsked = () -> canvas.setFrame(SampleFrames.frameOf(new Pose(3, 2, 0), moved));
            actions.get("motionSpeed").actionPerformed(null);
            assertEquals(moved.withMotion(moving.motion().withSpeed(1.5)), placed(0));
            whileAsked = () -> canvas.setFrame(SampleFrames.frameOf(new Pose(3, 2, 0)));
            actions.get("motionSpeed").actionPerformed(null);
            assertEquals(1, commands.size(), "it has been removed");
        });
    }

    private Obstacle selectMoving() {
        Frame frame = SampleFrames.fullFrame();
        canvas.setFrame(frame);
        Obstacle moving = frame.snapshot().obstacles().stream()
                .filter(Obstacle::isMoving)
                .findFirst()
                .orElseThrow();
        canvas.tools().select(Set.of(moving.id()));
        return moving;
    }

    private Obstacle placed(int index) {
        return ((Command.PlaceObstacle) commands.get(index)).obstacle();
    }

    private OptionalDouble askSpeed() {
        whileAsked.run();
        return speed;
    }

    private ObstacleActions addActions() {
        Theme.LIGHT.install();
        Workspace workspace = new Workspace();
        RunController run = new RunController(workspace);
        sender = new CommandSender((sent, onExecuted) -> commands.addAll(sent));
        UndoController undo = new UndoController(sender, () -> {});
        canvas = new SimulationCanvas(sender);
        SensorEditor sensors = new SensorEditor(workspace, new ScenarioEditor(run, undo), notes::add);
        ObstacleActions obstacles = new ObstacleActions(
                canvas.tools(),
                sender,
                new SensorActions(workspace, sender, sensors, canvas.tools()),
                new Notes(notes::add, notes::add, notes::add, notes::remove),
                now -> askSpeed(),
                WindowPreferences.nonPersistent());
        obstacles.addTo(actions);
        return obstacles;
    }

    private void assertNotesAfter(String action, String... expected) {
        actions.get(action).actionPerformed(null);
        assertEquals(List.of(expected), notes);
    }
}
