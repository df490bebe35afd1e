package faultline.gui.canvas.tool;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.ShapePreset;
import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import faultline.paint.surface.Camera;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** The canvas while frames lag behind commands, or never show their effect. No display is needed. */
class CanvasKeysTest {

    private static final Pose ROBOT = new Pose(1, 1, 0);
    private static final Frame WITH_BOX = SampleFrames.frameOf(
            ROBOT, new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), new Pose(4, 2, 0)));
    private static final Frame EMPTY = SampleFrames.frameOf(ROBOT);

    private final List<Command> sent = new ArrayList<>();
    private final List<Runnable> refusals = new ArrayList<>();
    private final CommandSender sender = callOnEdt(() -> new CommandSender(this::execute));
    private final SimulationCanvas canvas = callOnEdt(() -> {
        SimulationCanvas made = new SimulationCanvas(sender);
        made.setSize(600, 440);
        made.setFrame(WITH_BOX);
        made.tools().select(List.of("box"));
        return made;
    });

    /** Records commands, and how to refuse them. */
    private void execute(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        sent.addAll(commands);
        refusals.add(() -> onExecuted.accept(List.of()));
    }

    @Test
    void nudgesBetweenTwoFramesAddUp() {
        key("RIGHT");
        key("RIGHT");
        assertEquals(List.of(moveTo(4.01), moveTo(4.02)), callOnEdt(() -> List.copyOf(sent)));
    }

    @Test
    void manyNudgesDoNotAddRoundingErrors() {
        for (int i = 1; i <= 33; i++) {
            key("RIGHT");
            assertEquals(moveTo((400 + i) / 100.0), callOnEdt(() -> sent.get(sent.size() - 1)));
        }
    }

    @Test
    void obstaclesAreSelectedOneAfterTheOtherByKey() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(5, 3, 0));
        runOnEdt(() -> canvas.setFrame(
                SampleFrames.frameOf(ROBOT, WITH_BOX.snapshot().obstacles().get(0), pole)));
        List<String> ids = callOnEdt(() -> {
            List<String> selected = new ArrayList<>();
            for (int step : new int[] {1, 1, -1}) {
                canvas.tools().selectNext(step);
                selected.add(canvas.tools().selected().get(0).id());
            }
            return selected;
        });
        assertEquals(List.of("pole", "box", "pole"), ids);
    }

    @Test
    void enterPlacesAShapeInTheCentreOfTheView() {
        runOnEdt(() -> canvas.tools().placeShape(ShapePreset.CIRCLE));
        key("ENTER");
        Vector2 centre =
                callOnEdt(() -> new Vector2(canvas.camera().x(), canvas.camera().y()));
        Command.PlaceObstacle placed = (Command.PlaceObstacle) callOnEdt(() -> sent.get(0));
        assertEquals(0, placed.obstacle().pose().position().distanceTo(centre), 1e-3);
    }

    @Test
    void aNewObstacleHasNoIdThatTheScenarioUsesAtAnotherTime() {
        runOnEdt(() -> {
            canvas.tools().setReservedIds(() -> Set.of("circle", "circle-2"));
            canvas.tools().placeShape(ShapePreset.CIRCLE);
        });
        key("ENTER");
        Command.PlaceObstacle placed = (Command.PlaceObstacle) callOnEdt(() -> sent.get(0));
        assertEquals("circle-3", placed.obstacle().id());
        assertEquals(Set.of("box", "circle", "circle-2"), callOnEdt(() -> canvas.tools()
                .takenIds()));
    }

    @Test
    void aWallIsDrawnPointByPointWithKeysAlone() {
        runOnEdt(() -> canvas.tools().drawWall());
        keys("INSERT", "shift RIGHT", "shift RIGHT", "RIGHT", "INSERT", "shift UP", "shift UP", "INSERT");
        keys("shift LEFT", "shift LEFT", "INSERT", "BACK_SPACE", "ENTER");
        Command.PlaceObstacle placed = (Command.PlaceObstacle) callOnEdt(() -> sent.get(0));
        List<Vector2> points = ((ObstacleShape.WallShape) placed.obstacle().shape()).points();
        assertEquals(3, points.size());
        assertEquals(new Vector2(0.21, 0), rounded(points.get(1).minus(points.get(0))));
        assertEquals(new Vector2(0, 0.2), rounded(points.get(2).minus(points.get(1))));
    }

    private static Vector2 rounded(Vector2 offset) {
        return new Vector2(Math.round(offset.x() * 1e6) / 1e6, Math.round(offset.y() * 1e6) / 1e6);
    }

    @Test
    void withoutASelectionTheArrowKeysMoveTheView() {
        key("ESCAPE");
        Camera before = callOnEdt(canvas::camera);
        key("RIGHT");
        assertEquals(60, pixelsMoved(before, new Vector2(1, 0)), 1e-9);
        key("shift UP");
        assertEquals(300, pixelsMoved(before, new Vector2(0, 1)), 1e-9);
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(sent)));
    }

    /** Returns how far the view has moved in a direction of the world. */
    private double pixelsMoved(Camera before, Vector2 direction) {
        Camera now = callOnEdt(canvas::camera);
        Vector2 moved = new Vector2(now.x() - before.x(), now.y() - before.y());
        return (moved.x() * direction.x() + moved.y() * direction.y()) * now.scale();
    }

    private void keys(String... keys) {
        Stream.of(keys).forEach(this::key);
    }

    @Test
    void obstaclesFromElsewhereArePastedIntoTheView() {
        Obstacle outside = new Obstacle("far", new ObstacleShape.CircleShape(0.1), new Pose(50, -3, 0));
        Obstacle inside = new Obstacle("near", new ObstacleShape.CircleShape(0.1), new Pose(3, 3, 0));
        Vector2 target = callOnEdt(() -> canvas.tools().displacementIntoView(List.of(outside)))
                .plus(outside.pose().position());
        Vector2 centre =
                callOnEdt(() -> new Vector2(canvas.camera().x(), canvas.camera().y()));
        assertEquals(0, target.distanceTo(centre), 1e-9);
        assertEquals(Vector2.ZERO, callOnEdt(() -> canvas.tools().displacementIntoView(List.of(inside))));
    }

    @Test
    void turningThereAndBackLeavesSeveralWhereTheyWere() {
        Obstacle pole = new Obstacle("pole", new ObstacleShape.CircleShape(0.1), new Pose(5, 3, 0));
        runOnEdt(() -> canvas.setFrame(
                SampleFrames.frameOf(ROBOT, WITH_BOX.snapshot().obstacles().get(0), pole)));
        runOnEdt(() -> canvas.tools().select(List.of("box", "pole")));
        for (String key : List.of("Q", "Q", "E", "E")) {
            key(key);
        }
        Command.MoveObstacle there = (Command.MoveObstacle) callOnEdt(() -> sent.get(3));
        Command.MoveObstacle back = (Command.MoveObstacle) callOnEdt(() -> sent.get(7));
        assertEquals("pole", back.obstacle());
        assertNotEquals(pole.pose().position(), there.pose().position());
        assertEquals(0, back.pose().position().distanceTo(pole.pose().position()), 1e-12);
    }

    @Test
    void theSelectedSensorTurnsUnlessObstaclesAreSelected() {
        SensorSpec back = sensor("back", 178);
        Frame frame = SampleFrames.frameOf(
                ROBOT,
                SampleFrames.pathThrough(ROBOT.position()),
                List.of(SampleFrames.sensor(back, ROBOT, SampleFrames.NOTHING)),
                WITH_BOX.snapshot().obstacles().get(0));
        runOnEdt(() -> {
            canvas.setFrame(frame);
            sender.pendingEdits().setRobot(frame.snapshot().robot());
        });
        keys("ESCAPE", "Q");
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(sent)), "nothing is selected");
        runOnEdt(() -> canvas.tools().selectSensor("back"));
        keys("Q", "Q", "E");
        List<Command> turns = Stream.of(-177, -172, -177)
                .<Command>map(degrees -> new Command.ConfigureSensor(sensor("back", degrees)))
                .toList();
        assertEquals(turns, callOnEdt(() -> List.copyOf(sent)));
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        key("Q");
        assertTrue(callOnEdt(() -> sent.get(3)) instanceof Command.MoveObstacle);
    }

    @Test
    void aDragOfASensorKeepsAChangeThatTheRunHasNotAnswered() {
        SensorSpec front = sensor("front", 0);
        SensorSnapshot shown = SampleFrames.sensor(front, ROBOT, SampleFrames.NOTHING);
        Frame frame = SampleFrames.frameOf(ROBOT, SampleFrames.pathThrough(ROBOT.position()), List.of(shown));
        runOnEdt(() -> {
            canvas.setFrame(frame);
            sender.pendingEdits().setRobot(frame.snapshot().robot());
            canvas.tools().selectSensor("front");
            sender.send(new Command.ConfigureSensor(front.withNoise(0.01)));
        });
        Vector2 edge = shown.sector().apex().plus(new Vector2(front.range(), 0));
        Vector2 arc = callOnEdt(() -> canvas.camera().toScreen(edge));
        mouse(MouseEvent.MOUSE_PRESSED, arc);
        mouse(MouseEvent.MOUSE_DRAGGED, arc.plus(new Vector2(20, 0)));
        SensorSpec dragged = ((Command.ConfigureSensor) callOnEdt(() -> sent.get(1))).sensor();
        assertNotEquals(front.range(), dragged.range());
        assertEquals(0.01, dragged.noise());
        SensorSpec noisier = front.withNoise(0.02);
        runOnEdt(() -> {
            sender.send(new Command.ConfigureSensor(noisier));
            sent.clear();
        });
        mouse(MouseEvent.MOUSE_DRAGGED, arc.plus(new Vector2(30, 0)));
        assertEquals(
                0.02,
                ((Command.ConfigureSensor) callOnEdt(() -> sent.get(0)))
                        .sensor()
                        .noise());
    }

    private static SensorSpec sensor(String id, double bearing) {
        return RobotSpec.DEFAULT.sensors().get(0).withId(id).withBearing(Degrees.toRadians(bearing));
    }

    @Test
    void afterARefusalTheNextNudgeStartsWhereTheObstacleReallyIs() {
        key("RIGHT");
        runOnEdt(refusals.get(0)::run);
        runOnEdt(() -> sender.pendingEdits().setRobot(WITH_BOX.snapshot().robot()));
        runOnEdt(() -> canvas.setFrame(WITH_BOX));
        key("RIGHT");
        assertEquals(List.of(moveTo(4.01), moveTo(4.01)), callOnEdt(() -> List.copyOf(sent)));
    }

    @Test
    void withoutASelectionNothingIsNudged() {
        key("ESCAPE");
        key("UP");
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(sent)));
    }

    @Test
    void anObstacleThatIsGoneIsNoLongerSelected() {
        List<Set<String>> selections = new ArrayList<>();
        runOnEdt(() -> canvas.tools().addSelectionListener(selections::add));
        runOnEdt(() -> canvas.setFrame(EMPTY));
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
        assertEquals(List.of(Set.of()), callOnEdt(() -> List.copyOf(selections)));
    }

    @Test
    void anObstacleThatVanishesDuringADragEndsIt() {
        Vector2 box = callOnEdt(() -> canvas.camera().toScreen(new Vector2(4, 2)));
        mouse(MouseEvent.MOUSE_PRESSED, box);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(20, 0)));
        assertFalse(callOnEdt(sent::isEmpty), "the drag has begun");
        runOnEdt(sent::clear);
        runOnEdt(() -> canvas.setFrame(EMPTY));
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(40, 0)));
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(sent)));
    }

    @Test
    void theKeyOfUndoCancelsADrag() {
        assertFalse(pressUndo(), "without a drag the key is that of the menu");
        Vector2 box = callOnEdt(() -> canvas.camera().toScreen(new Vector2(4, 2)));
        mouse(MouseEvent.MOUSE_PRESSED, box);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(20, 0)));
        assertTrue(pressUndo());
        assertEquals(moveTo(4), callOnEdt(() -> sent.get(sent.size() - 1)));
        runOnEdt(sent::clear);
        mouse(MouseEvent.MOUSE_DRAGGED, box.plus(new Vector2(40, 0)));
        mouse(MouseEvent.MOUSE_RELEASED, box.plus(new Vector2(40, 0)));
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(sent)));
        assertFalse(pressUndo());
    }

    @Test
    void theKeyOfUndoCancelsADragOfTheRobot() {
        List<Pose> starts = new ArrayList<>();
        runOnEdt(() -> canvas.tools().listeners().addStartListener(starts::add));
        Vector2 robot = callOnEdt(() -> canvas.camera().toScreen(ROBOT.position()));
        mouse(MouseEvent.MOUSE_PRESSED, robot);
        mouse(MouseEvent.MOUSE_DRAGGED, robot.plus(new Vector2(20, 0)));
        assertTrue(pressUndo());
        mouse(MouseEvent.MOUSE_RELEASED, robot.plus(new Vector2(20, 0)));
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(starts)));
    }

    /** Returns whether the canvas consumes the key. */
    private boolean pressUndo() {
        return callOnEdt(() -> SwingUtilities.processKeyBindings(new KeyEvent(
                canvas, KeyEvent.KEY_PRESSED, 0, KeyBindings.menuMask(), KeyEvent.VK_Z, KeyEvent.CHAR_UNDEFINED)));
    }

    @Test
    void whatIsNotThereCannotBeSelected() {
        runOnEdt(() -> canvas.tools().select(List.of("sofa")));
        assertEquals(List.of(), callOnEdt(canvas.tools()::selected));
    }

    @Test
    void theCanvasHasAnAccessibleNameAndRole() {
        AccessibleContext context = callOnEdt(canvas::getAccessibleContext);
        assertEquals(Messages.get("canvas"), context.getAccessibleName());
        assertEquals(AccessibleRole.CANVAS, context.getAccessibleRole());
    }

    private static Command moveTo(double x) {
        return new Command.MoveObstacle("box", new Pose(x, 2, 0));
    }

    private void key(String key) {
        runOnEdt(() -> canvas.getActionMap()
                .get(key)
                .actionPerformed(new ActionEvent(canvas, ActionEvent.ACTION_PERFORMED, key)));
    }

    private void mouse(int type, Vector2 at) {
        runOnEdt(() -> canvas.dispatchEvent(new MouseEvent(
                canvas,
                type,
                0,
                InputEvent.BUTTON1_DOWN_MASK,
                (int) at.x(),
                (int) at.y(),
                1,
                false,
                MouseEvent.BUTTON1)));
    }
}
