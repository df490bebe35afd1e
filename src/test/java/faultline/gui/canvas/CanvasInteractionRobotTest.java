package faultline.gui.canvas;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SampleFrames;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.edit.CommandSender;
import faultline.paint.scene.SelectionPainter;
import faultline.paint.surface.Camera;
import faultline.world.Command;
import faultline.world.CommandResult;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Cursor;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javax.swing.JFrame;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Drives the canvas in a real window with mouse and keyboard. The test executes commands immediately instead of using a
 * session.
 */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class CanvasInteractionRobotTest {

    private static final int LEFT = InputEvent.BUTTON1_DOWN_MASK;
    private static final int MIDDLE = InputEvent.BUTTON2_DOWN_MASK;
    private static final int RIGHT = InputEvent.BUTTON3_DOWN_MASK;
    private static final Pose ROBOT = new Pose(1, 1, 0);
    private static final Pose START = new Pose(4, 2, 0);
    /** The tolerance of a mouse position, metres, at about 100 pixels per metre. */
    private static final double PIXEL = 0.02;

    private final GuiRobot robot = new GuiRobot();
    private final List<Command.MoveObstacle> moves = new ArrayList<>();
    private SimulationCanvas canvas;
    private JFrame window;

    @BeforeEach
    void open() {
        window = callOnEdt(() -> {
            canvas = new SimulationCanvas(new CommandSender(this::execute));
            JFrame frame = new JFrame("Canvas");
            frame.add(canvas);
            frame.setSize(760, 560);
            frame.setLocation(60, 40);
            canvas.setFrame(SampleFrames.frameOf(ROBOT, boxAt(START)));
            return frame;
        });
        robot.open(window);
    }

    @AfterEach
    void close() {
        robot.close(window);
    }

    private void execute(List<Command> commands, Consumer<List<CommandResult>> onExecuted) {
        Command.MoveObstacle move = (Command.MoveObstacle) commands.get(0);
        moves.add(move);
        canvas.setFrame(SampleFrames.frameOf(ROBOT, boxAt(move.pose())));
    }

    private static Obstacle boxAt(Pose pose) {
        return new Obstacle("box", new ObstacleShape.RectangleShape(0.8, 0.5), pose);
    }

    @Test
    void draggingAnObstacleMovesItWithTheMouse() {
        drag(new Vector2(4.1, 2.1), new Vector2(3.1, 3.1), LEFT);
        assertPose(new Pose(3, 3, 0), lastMove());
        assertTrue(callOnEdt(moves::size) > 3, "it moves while it is dragged");
        assertEquals(List.of("box"), selection());
    }

    @Test
    void aClickSelectsAndMovesNothingAndOneOnEmptyGroundClears() {
        click(new Vector2(4, 2));
        assertEquals(List.of("box"), selection());
        click(new Vector2(2, 3));
        assertEquals(List.of(), selection());
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(moves)));
    }

    @Test
    void escapeSendsADraggedObstacleBackAndEndsTheDrag() {
        Vector2 from = screen(new Vector2(4, 2));
        Vector2 to = screen(new Vector2(3, 3));
        AtomicInteger sent = new AtomicInteger();
        robot.moveTo(canvas, from.x(), from.y());
        robot.whilePressing(LEFT, () -> {
            robot.moveSmoothly(canvas, from.x(), from.y(), to.x(), to.y());
            robot.pressKeys(KeyEvent.VK_ESCAPE);
            assertPose(START, lastMove());
            sent.set(callOnEdt(moves::size));
            robot.moveSmoothly(canvas, to.x(), to.y(), from.x(), from.y());
        });
        assertEquals(sent.get(), callOnEdt(moves::size), "the drag is over");
    }

    @Test
    void theHandleTurnsTheSelectedObstacle() {
        click(new Vector2(4, 2));
        Vector2 handle = callOnEdt(() -> SelectionPainter.handlePosition(canvas.camera(), boxAt(START)));
        Vector2 left = screen(new Vector2(3, 2));
        robot.drag(canvas, handle.x(), handle.y(), left.x(), left.y(), LEFT);
        assertPose(new Pose(4, 2, Math.PI / 2), lastMove());
    }

    @Test
    void theRightButtonTurns() {
        drag(new Vector2(4.3, 2), new Vector2(4, 2.6), RIGHT);
        assertPose(new Pose(4, 2, Math.PI / 2), lastMove());
    }

    @Test
    void theLeftButtonWithCtrlTurns() {
        robot.whileHolding(KeyEvent.VK_CONTROL, () -> drag(new Vector2(4.3, 2), new Vector2(4, 1.4), LEFT));
        assertPose(new Pose(4, 2, -Math.PI / 2), lastMove());
    }

    @Test
    void theWheelZoomsOnThePointUnderTheCursor() {
        Vector2 at = new Vector2(550, 140);
        robot.moveTo(canvas, at.x(), at.y());
        Vector2 before = under(at);
        double scale = camera().scale();
        robot.rotateWheel(-3);
        robot.waitFor("the canvas has zoomed in", () -> canvas.camera().scale() > 1.3 * scale);
        assertEquals(0, under(at).distanceTo(before), 1e-9);
        robot.rotateWheel(3);
        robot.waitFor(
                "the canvas has zoomed out", () -> Math.abs(canvas.camera().scale() - scale) < 1e-6);
    }

    @Test
    void draggingEmptyGroundPansAndKeepsTheSelection() {
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        Vector2 before = screen(new Vector2(2, 3));
        robot.drag(canvas, before.x(), before.y(), before.x() + 50, before.y() + 30, LEFT);
        assertEquals(0, screen(new Vector2(2, 3)).distanceTo(before.plus(new Vector2(50, 30))), 1e-6);
        assertEquals(List.of("box"), selection());
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(moves)));
    }

    @Test
    void theMiddleButtonPansOverAnObstacleToo() {
        Vector2 before = screen(new Vector2(4, 2));
        robot.drag(canvas, before.x(), before.y(), before.x() - 40, before.y() + 20, MIDDLE);
        assertEquals(0, screen(new Vector2(4, 2)).distanceTo(before.plus(new Vector2(-40, 20))), 1e-6);
        assertEquals(List.of(), callOnEdt(() -> List.copyOf(moves)));
    }

    @Test
    void arrowsNudgeTheSelectedObstacleAndQAndETurnIt() {
        click(new Vector2(4, 2));
        robot.waitFor("the canvas has the focus", canvas::isFocusOwner);
        robot.pressKeys(KeyEvent.VK_RIGHT);
        robot.pressKeys(KeyEvent.VK_SHIFT, KeyEvent.VK_UP);
        assertExactly(new Pose(4.01, 2.1, 0), lastMove());
        robot.pressKeys(KeyEvent.VK_Q);
        robot.pressKeys(KeyEvent.VK_Q);
        robot.pressKeys(KeyEvent.VK_E);
        assertExactly(new Pose(4.01, 2.1, Degrees.toRadians(5)), lastMove());
    }

    @Test
    void theCursorsPositionIsReportedAndItsShapeSaysWhatADragWouldDo() {
        List<Optional<Vector2>> cursors = new ArrayList<>();
        runOnEdt(() -> canvas.addCursorListener(cursors::add));
        Vector2 box = screen(new Vector2(4, 2));
        robot.moveTo(canvas, box.x(), box.y());
        robot.waitFor(
                "the cursor says that the box can be moved",
                () -> canvas.getCursor().getType() == Cursor.MOVE_CURSOR);
        assertEquals(
                0,
                callOnEdt(() -> cursors.get(cursors.size() - 1)).orElseThrow().distanceTo(new Vector2(4, 2)),
                PIXEL);
        robot.moveTo(canvas, -20, 100);
        robot.waitFor(
                "the cursor has left", () -> cursors.get(cursors.size() - 1).isEmpty());
    }

    private void click(Vector2 world) {
        Vector2 at = screen(world);
        robot.click(canvas, at.x(), at.y(), LEFT);
    }

    private void drag(Vector2 from, Vector2 to, int button) {
        Vector2 start = screen(from);
        Vector2 end = screen(to);
        robot.drag(canvas, start.x(), start.y(), end.x(), end.y(), button);
    }

    private List<String> selection() {
        return callOnEdt(
                () -> canvas.tools().selected().stream().map(Obstacle::id).toList());
    }

    private Camera camera() {
        return callOnEdt(canvas::camera);
    }

    private Vector2 screen(Vector2 world) {
        return camera().toScreen(world);
    }

    private Vector2 under(Vector2 screen) {
        return camera().toWorld(screen);
    }

    private Pose lastMove() {
        return callOnEdt(() -> moves.get(moves.size() - 1).pose());
    }

    /** Asserts a pose within the rounding of the mouse to pixels. */
    private static void assertPose(Pose expected, Pose actual) {
        assertEquals(0, expected.position().distanceTo(actual.position()), PIXEL, expected + " and " + actual);
        assertEquals(
                0,
                Math.IEEEremainder(expected.heading() - actual.heading(), 2 * Math.PI),
                0.05,
                expected + " and " + actual);
    }

    private static void assertExactly(Pose expected, Pose actual) {
        assertEquals(0, expected.position().distanceTo(actual.position()), 1e-12, expected + " and " + actual);
        assertEquals(expected.heading(), actual.heading(), 1e-12);
    }
}
