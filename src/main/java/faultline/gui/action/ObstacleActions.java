package faultline.gui.action;

import static faultline.gui.action.Keystrokes.menuShortcut;
import static faultline.gui.action.Keystrokes.unmodified;

import faultline.geometry.Degrees;
import faultline.gui.canvas.tool.CanvasTools;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ObstacleCopies;
import faultline.gui.edit.ShapePreset;
import faultline.gui.edit.SnapSettings;
import faultline.gui.settings.Preference;
import faultline.gui.settings.WindowPreferences;
import faultline.gui.text.Messages;
import faultline.gui.theme.Glyph;
import faultline.scenario.ObstacleXml;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.WaypointPath;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.swing.KeyStroke;

/** The actions on obstacles: placing, copying, deleting, motion and snapping. */
public final class ObstacleActions {

    /** The keys of the actions that choose what the mouse does, in the order of the palette. */
    public static final List<String> PALETTE_KEYS = Stream.of(
                    Stream.of("select"),
                    Stream.of(ShapePreset.values()).map(shape -> UiAction.key("place", shape)),
                    Stream.of("drawWall", "drawPolygon"))
            .flatMap(keys -> keys)
            .toList();

    private static final double GRID_STEP = 0.05;
    private static final double ANGLE_STEP = Degrees.toRadians(15);

    private final CanvasTools tools;
    private final CommandSender sender;
    private final SensorActions sensorActions;
    private final Notes notes;
    private final DoubleFunction<OptionalDouble> askSpeed;
    private final WindowPreferences preferences;
    private final UiAction drawWaypoints = UiAction.of("drawWaypoints", this::drawMotionPath);
    private final UiAction motionSpeed = UiAction.of("motionSpeed", this::editMotionSpeed);
    private final UiAction stopMoving = UiAction.of("stopMoving", this::removeMotion);
    private final UiAction cut = UiAction.of("cut", this::cut);
    private final UiAction copy = UiAction.of("copy", this::copySelection);
    private final UiAction duplicate = UiAction.of("duplicate", this::duplicate);
    private final UiAction delete = UiAction.of("delete", this::delete);
    private final UiAction snapGrid;
    private final UiAction snapAngle;
    /** The note that was shown last about the use of a tool. */
    private String toolNote = "";

    private String pasteNote = "";

    /**
     * Creates the actions; those on the selection apply to a sensor if no obstacle is selected. {@code askSpeed} asks
     * for a speed, metres per second, given the present one, and returns empty if cancelled.
     */
    public ObstacleActions(
            CanvasTools tools,
            CommandSender sender,
            SensorActions sensorActions,
            Notes notes,
            DoubleFunction<OptionalDouble> askSpeed,
            WindowPreferences preferences) {
        this.tools = tools;
        this.sender = sender;
        this.sensorActions = sensorActions;
        this.notes = notes;
        this.askSpeed = askSpeed;
        this.preferences = preferences;
        snapGrid = UiAction.toggle("snapGrid", preferences.get(Preference.SNAP_GRID), on -> applySnap());
        snapAngle = UiAction.toggle("snapAngle", preferences.get(Preference.SNAP_ANGLE), on -> applySnap());
        applySnap();
    }

    public void addTo(ActionRegistry actions) {
        tools.addToolListener(inUse -> notes.remove(toolNote));
        tools.addSelectionListener(ids -> update());
        tools.addSensorListener(sensor -> update());
        actions.add(createSelectAction().withIcon(Glyph.SELECT).withAccelerator(unmodified(KeyEvent.VK_V)));
        for (ShapePreset shape : ShapePreset.values()) {
            actions.add(createToolAction(UiAction.key("place", shape), () -> tools.placeShape(shape))
                    .withIcon(Glyph.valueOf(shape.name())));
        }
        actions.add(createToolAction("drawWall", tools::drawWall).withIcon(Glyph.WALL));
        actions.add(createToolAction("drawPolygon", tools::drawPolygon).withIcon(Glyph.POLYGON));
        actions.add(drawWaypoints);
        actions.add(motionSpeed);
        actions.add(stopMoving);
        actions.add(cut.withAccelerator(menuShortcut(KeyEvent.VK_X)));
        actions.add(copy.withAccelerator(menuShortcut(KeyEvent.VK_C)));
        actions.add(UiAction.of("paste", this::paste).withAccelerator(menuShortcut(KeyEvent.VK_V)));
        actions.add(duplicate.withAccelerator(menuShortcut(KeyEvent.VK_D)));
        actions.add(delete.withAccelerator(unmodified(KeyEvent.VK_DELETE)));
        actions.add(UiAction.of("selectAll", tools::selectAll).withAccelerator(menuShortcut(KeyEvent.VK_A)));
        actions.add(UiAction.of("selectNext", () -> tools.selectNext(1)).withAccelerator(unmodified(KeyEvent.VK_N)));
        actions.add(UiAction.of("selectPrevious", () -> tools.selectNext(-1))
                .withAccelerator(KeyStroke.getKeyStroke(KeyEvent.VK_N, InputEvent.SHIFT_DOWN_MASK)));
        actions.add(snapGrid);
        actions.add(snapAngle);
        update();
    }

    /** Enables the actions that have something to act on: a selected obstacle, one that moves, or a sensor. */
    public void update() {
        List<Obstacle> selected = tools.selected();
        boolean moving = selected.stream().anyMatch(Obstacle::isMoving);
        drawWaypoints.setEnabled(selected.size() == 1);
        motionSpeed.setEnabled(moving);
        stopMoving.setEnabled(moving);
        cut.setEnabled(!selected.isEmpty());
        copy.setEnabled(!selected.isEmpty());
        boolean any = !selected.isEmpty() || tools.selectedSensor().isPresent();
        duplicate.setEnabled(any);
        delete.setEnabled(any);
    }

    /** Creates the action that ends the active tool. It is on while there is none. */
    private UiAction createSelectAction() {
        UiAction action = UiAction.ofSelf("select", self -> {
            tools.endTool();
            self.setOn(true);
        });
        action.setOn(true);
        tools.addToolListener(inUse -> action.setOn(!inUse));
        return action;
    }

    private UiAction createToolAction(String key, Runnable tool) {
        UiAction action = UiAction.ofSelf(key, self -> activateTool(self, tool));
        tools.addToolListener(inUse -> action.setOn(false));
        return action;
    }

    private void activateTool(UiAction action, Runnable tool) {
        tool.run();
        action.setOn(true);
        showToolNote(action.key());
    }

    /** Shows how a tool is used, until it ends. */
    private void showToolNote(String action) {
        toolNote = Messages.get("action." + action + ".tip");
        notes.show(toolNote);
    }

    private void applySnap() {
        tools.setSnap(new SnapSettings(snapGrid.isOn() ? GRID_STEP : 0, snapAngle.isOn() ? ANGLE_STEP : 0));
        preferences.set(Preference.SNAP_GRID, snapGrid.isOn());
        preferences.set(Preference.SNAP_ANGLE, snapAngle.isOn());
    }

    private void drawMotionPath() {
        tools.drawMotionPath();
        showToolNote("drawWaypoints");
    }

    private List<Obstacle> selectedMoving() {
        return tools.expectedSelection().stream().filter(Obstacle::isMoving).toList();
    }

    /** Sets the speed of all selected obstacles that move. */
    private void editMotionSpeed() {
        List<Obstacle> moving = selectedMoving();
        if (!moving.isEmpty()) {
            // The run goes forward while the dialog is open, and may move or remove obstacles.
            askSpeed.apply(moving.get(0).motion().speed())
                    .ifPresent(speed -> changeMotion(motion -> motion.withSpeed(speed)));
        }
    }

    private void removeMotion() {
        changeMotion(motion -> WaypointPath.NONE);
    }

    /** Changes the motion of all selected obstacles that move. */
    private void changeMotion(UnaryOperator<WaypointPath> change) {
        sender.send(selectedMoving().stream()
                .<Command>map(
                        obstacle -> new Command.PlaceObstacle(obstacle.withMotion(change.apply(obstacle.motion()))))
                .toList());
    }

    private void cut() {
        if (copySelection()) {
            deleteObstacles(tools.selected());
        }
    }

    private void duplicate() {
        selectedSensor().ifPresentOrElse(sensorActions::duplicate, () -> addCopies(tools.expectedSelection()));
    }

    private void delete() {
        selectedSensor().ifPresentOrElse(sensorActions::remove, () -> deleteObstacles(tools.selected()));
    }

    /** Returns the selected sensor; empty if obstacles are selected, to which a command then applies. */
    private Optional<String> selectedSensor() {
        return tools.selected().isEmpty() ? tools.selectedSensor() : Optional.empty();
    }

    private void deleteObstacles(List<Obstacle> obstacles) {
        sender.send(obstacles.stream()
                .<Command>map(obstacle -> new Command.RemoveObstacle(obstacle.id()))
                .toList());
    }

    /** Copies the selected obstacles to the clipboard; returns whether they are there. */
    private boolean copySelection() {
        try {
            clipboard().setContents(new StringSelection(ObstacleXml.format(tools.expectedSelection())), null);
            return true;
        } catch (IllegalStateException busy) {
            notes.show(Messages.get("note.clipboardBusy"));
            return false;
        }
    }

    private void paste() {
        if (!tools.hasFrame()) {
            return;
        }
        try {
            readClipboardText().ifPresent(this::paste);
        } catch (IllegalStateException busy) {
            notes.show(Messages.get("note.clipboardBusy"));
        }
    }

    /** Inserts the obstacles of a text; a note says why if it has none. */
    void paste(String text) {
        try {
            List<Obstacle> pasted = ObstacleXml.parse(text);
            notes.remove(pasteNote);
            if (!pasted.isEmpty()) {
                addCopies(ObstacleCopies.displaced(pasted, tools.displacementIntoView(pasted)));
            }
        } catch (ScenarioException exception) {
            int more = exception.problems().size() - 1;
            String first = Messages.get(exception.problems().get(0).message());
            pasteNote = more == 0
                    ? Messages.get("note.notPasted", first)
                    : Messages.get("note.notPasted.more", first, Integer.toString(more));
            notes.show(pasteNote);
        }
    }

    private static Optional<String> readClipboardText() {
        try {
            return Optional.of((String) clipboard().getData(DataFlavor.stringFlavor));
        } catch (UnsupportedFlavorException | IOException noText) {
            return Optional.empty();
        }
    }

    private static Clipboard clipboard() {
        return Toolkit.getDefaultToolkit().getSystemClipboard();
    }

    private void addCopies(List<Obstacle> originals) {
        if (originals.isEmpty()) {
            return;
        }
        List<Obstacle> copies = ObstacleCopies.copyOf(originals, tools.takenIds(), tools.offsetOfCopies(originals));
        tools.selectWhenPresent(copies.stream().map(Obstacle::id).toList());
        sender.send(copies.stream().<Command>map(Command.PlaceObstacle::new).toList());
    }
}
