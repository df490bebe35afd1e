package faultline.gui.timeline;

import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.EdtChecker;
import faultline.gui.change.Rename;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.KeyBindings;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.Cursor;
import java.awt.IllegalComponentStateException;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/** Mouse, keys, undo and redo in the lanes, in any order. */
@ExtendWith(EdtChecker.class)
class LaneViewTest {

    private static final int MENU = KeyBindings.menuMask();
    private static final int[] KEYS = {
        KeyEvent.VK_UP, KeyEvent.VK_DOWN, KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT, KeyEvent.VK_DELETE, KeyEvent.VK_ESCAPE
    };
    private static final int[] CLIPBOARD_KEYS = {KeyEvent.VK_C, KeyEvent.VK_X, KeyEvent.VK_V, KeyEvent.VK_D};
    private static final int[] MODIFIERS = {InputEvent.SHIFT_DOWN_MASK, InputEvent.ALT_DOWN_MASK, MENU};

    private OpenLanes lanes;
    private UndoController undo;
    private TimelineEditor editor;
    private LaneView view;

    @BeforeEach
    void open() {
        lanes = OpenLanes.open();
        undo = lanes.undo();
        editor = lanes.editor();
        view = lanes.view();
        runOnEdt(() -> {
            view.setSize(800, 100);
            List<Lane> shown = List.of(new Lane.SensorLane("left"), new Lane.SensorLane("front"), Lane.OTHER);
            view.update(shown, new TimeAxis(60, 800, 60), 0);
        });
    }

    @AfterEach
    void close() {
        lanes.close();
    }

    @Test
    void aRedoneDeletionEndsADrag() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            addStuck("left", 30, 40);
            editor.remove(0);
            undo.undo();
            updateView();
            mouse(MouseEvent.MOUSE_PRESSED, 35, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 45, MouseEvent.BUTTON1);
            assertTrue(view.preview().isPresent());
            undo.redo();
            List<TimedCommand> rest = editor.model().commands();
            assertEquals(2, rest.size());
            updateView();
            assertFalse(view.preview().isPresent(), "the drag has ended");
            mouse(MouseEvent.MOUSE_DRAGGED, 50, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_RELEASED, 50, MouseEvent.BUTTON1);
            assertEquals(rest, editor.model().commands());
            paint();
        });
    }

    @Test
    void theSelectedLaneStaysSelectedWhenTheSensorsChange() {
        Lane front = new Lane.SensorLane("front");
        runOnEdt(() -> {
            view.select(1, LaneLayout.NONE);
            showLanes(front, Lane.OTHER);
            assertEquals(front, view.selectedLane(), "left is deleted");
            view.select(1, LaneLayout.NONE);
            showLanes(front, new Lane.SensorLane("new"), Lane.OTHER);
            assertEquals(Lane.OTHER, view.selectedLane(), "one is added");
            view.select(1, LaneLayout.NONE);
            view.renameSensors(id -> id.equals("new") ? "rear" : id);
            showLanes(new Lane.SensorLane("left"), front, new Lane.SensorLane("rear"), Lane.OTHER);
            assertEquals(new Lane.SensorLane("rear"), view.selectedLane(), "one is renamed, and another one restored");
            showLanes(front, Lane.OTHER);
            assertEquals(Lane.OTHER, view.selectedLane(), "it is deleted");
            view.startScenario();
            showLanes(new Lane.SensorLane("left"), front, Lane.OTHER);
            assertEquals(new Lane.SensorLane("left"), view.selectedLane(), "the first one of another scenario");
        });
    }

    private void showLanes(Lane... shown) {
        view.update(List.of(shown), new TimeAxis(60, 800, 60), 0);
    }

    /** A dialog that opens during a drag gets the release of the button. */
    @Test
    void aMovementWithoutAButtonEndsADrag() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            List<TimedCommand> before = editor.model().commands();
            mouse(MouseEvent.MOUSE_PRESSED, 15, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 25, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_MOVED, 25, MouseEvent.NOBUTTON);
            assertEquals(Optional.empty(), view.preview());
            assertEquals(before, editor.model().commands());
        });
    }

    /** On Windows, the release of a button opens a menu, which the view cannot show without a display. */
    @Test
    void theReleaseOfAButtonOpensAMenuOnlyWhereAPressDoes() {
        runOnEdt(() -> {
            releaseForMenu(view.rulerTop() + 3);
            int lane = view.rulerTop() + 20;
            assertThrows(IllegalComponentStateException.class, () -> releaseForMenu(lane));
            view.setEnabled(false);
            releaseForMenu(lane);
        });
    }

    private void releaseForMenu(int y) {
        view.dispatchEvent(new MouseEvent(view, MouseEvent.MOUSE_RELEASED, 0, 0, 400, y, 1, true, MouseEvent.BUTTON3));
    }

    @Test
    void anotherScenarioGetsNoFaultThatWasAskedForBefore() {
        runOnEdt(() -> {
            view.addFault("front");
            view.startScenario();
            updateView();
        });
        runOnEdt(() -> assertEquals(new Lane.SensorLane("left"), view.selectedLane()));
    }

    @Test
    void anotherScenarioEndsADrag() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            mouse(MouseEvent.MOUSE_PRESSED, 15, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 25, MouseEvent.BUTTON1);
            view.startScenario();
            assertEquals(Optional.empty(), view.preview());
        });
    }

    @Test
    void anotherButtonDoesNotChangeWhatIsDragged() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            addStuck("left", 30, 40);
            updateView();
            mouse(MouseEvent.MOUSE_PRESSED, 15, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 16, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_PRESSED, 35, MouseEvent.BUTTON3);
            mouse(MouseEvent.MOUSE_RELEASED, 16, MouseEvent.BUTTON1);
            assertEquals(List.of(11.0, 21.0, 30.0, 40.0), lanes.times());
        });
    }

    @Test
    void theReleaseOfAnotherButtonDoesNotEndADrag() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            mouse(MouseEvent.MOUSE_PRESSED, 15, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 16, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_PRESSED, 16, MouseEvent.BUTTON3);
            mouse(MouseEvent.MOUSE_RELEASED, 16, MouseEvent.BUTTON3);
            assertEquals(List.of(10.0, 20.0), lanes.times());
            mouse(MouseEvent.MOUSE_DRAGGED, 18, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_RELEASED, 18, MouseEvent.BUTTON1);
            assertEquals(List.of(13.0, 23.0), lanes.times());
        });
    }

    /** The lanes are 740 pixels long. */
    @Test
    void zoomedLanesAreDraggedMorePrecisely() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            int x = (int) Math.round(view.axis().x(15));
            wheel(x, -6, InputEvent.CTRL_DOWN_MASK);
            assertEquals(x, view.axis().x(15), 0.5);
            double step = view.axis().step(0.01);
            assertTrue(step < new TimeAxis(60, 800, 60).step(0.01), "step " + step);
            mouse(MouseEvent.MOUSE_PRESSED, new Point(x, rowY()), MouseEvent.BUTTON1, 1);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(x + 40, rowY()), MouseEvent.BUTTON1, 1);
            mouse(MouseEvent.MOUSE_RELEASED, new Point(x + 40, rowY()), MouseEvent.BUTTON1, 1);
            double by = 40 * view.axis().length() / 740;
            assertEquals(10 + by, lanes.times().get(0), step);
            assertEquals(20 + by, lanes.times().get(1), step);
            assertEquals(10, lanes.times().get(1) - lanes.times().get(0), 1e-6);
        });
    }

    @Test
    void aDragGoesOnWhileTheLanesAreMovedInTime() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            int x = (int) Math.round(view.axis().x(15));
            wheel(x, -6, InputEvent.CTRL_DOWN_MASK);
            mouse(MouseEvent.MOUSE_PRESSED, new Point(x, rowY()), MouseEvent.BUTTON1, 1);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(x + 10, rowY()), MouseEvent.BUTTON1, 1);
            wheel(x, 1, InputEvent.SHIFT_DOWN_MASK);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(x, rowY()), MouseEvent.BUTTON1, 1);
            mouse(MouseEvent.MOUSE_RELEASED, new Point(x, rowY()), MouseEvent.BUTTON1, 1);
            assertEquals(10 + 60 * view.axis().length() / 740, lanes.times().get(0), 0.2);
        });
    }

    @Test
    void theLanesCatchUpWithTheRunAfterADrag() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            wheel(60, -8, InputEvent.CTRL_DOWN_MASK);
            mouse(MouseEvent.MOUSE_PRESSED, new Point(300, rowY() + 20), MouseEvent.BUTTON1, 1);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(400, rowY() + 20), MouseEvent.BUTTON1, 1);
            assertTrue(view.preview().isPresent());
            TimeAxis before = view.axis();
            view.update(view.allLanes(), before, 30);
            assertEquals(before, view.axis(), "nothing moves below the mouse");
            press(KeyEvent.VK_ESCAPE, 0);
            view.update(view.allLanes(), view.axis(), 31);
            assertTrue(view.axis().shows(31), view.axis().toString());
        });
    }

    @Test
    void theMiddleButtonAndShiftWithTheWheelMoveZoomedLanesAndNothingElse() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            mouse(MouseEvent.MOUSE_PRESSED, new Point(400, rowY()), MouseEvent.BUTTON2, 1);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(300, rowY()), MouseEvent.BUTTON2, 1);
            assertTrue(view.axis().isWhole());
            wheel(400, -6, InputEvent.CTRL_DOWN_MASK);
            double start = view.axis().start();
            mouse(MouseEvent.MOUSE_PRESSED, new Point(400, rowY()), MouseEvent.BUTTON2, 1);
            mouse(MouseEvent.MOUSE_DRAGGED, new Point(300, rowY()), MouseEvent.BUTTON2, 1);
            mouse(MouseEvent.MOUSE_RELEASED, new Point(300, rowY()), MouseEvent.BUTTON2, 1);
            assertEquals(start + 100 * view.axis().length() / 740, view.axis().start(), 1e-6);
            assertEquals(List.of(10.0, 20.0), lanes.times());
        });
    }

    @Test
    void anItemThatKeysSelectIsMadeVisibleAndAnotherScenarioShowsAllOfTheRun() {
        runOnEdt(() -> {
            addStuck("left", 5, 6);
            addStuck("left", 50, 55);
            updateView();
            wheel(60, -10, InputEvent.CTRL_DOWN_MASK);
            assertFalse(view.axis().shows(50));
            press(KeyEvent.VK_RIGHT, 0);
            press(KeyEvent.VK_RIGHT, 0);
            assertTrue(view.axis().shows(50), view.axis().toString());
            double length = view.axis().length();
            editor.remove(0);
            updateView();
            assertEquals(length, view.axis().length(), 1e-9, "an edit keeps the zoom");
            view.startScenario();
            assertTrue(view.axis().isWhole());
        });
    }

    @Test
    void aBarThatBeginsBeforeTheVisiblePartIsNotHitInTheColumnOfNames() {
        runOnEdt(() -> {
            addStuck("left", 0, 60);
            updateView();
            wheel(400, -6, InputEvent.CTRL_DOWN_MASK);
            assertNull(view.hit(new Point(20, rowY())));
            assertEquals(
                    LaneLayout.ItemPart.BODY, view.hit(new Point(62, rowY())).part());
            paint();
        });
    }

    private int rowY() {
        return view.lanes().laneTop(0) + view.lanes().rowHeight() / 2;
    }

    /** Turns the wheel in the first lane; negative notches are away from the user. */
    private void wheel(int x, int notches, int modifiers) {
        view.dispatchEvent(new MouseWheelEvent(
                view,
                MouseEvent.MOUSE_WHEEL,
                0,
                modifiers,
                x,
                rowY(),
                0,
                false,
                MouseWheelEvent.WHEEL_UNIT_SCROLL,
                3,
                notches));
    }

    /** Each position of the mouse, each frame and each key asks for it several times. */
    @Test
    void theLayoutIsMadeAgainOnlyForOtherItems() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            updateView();
            LaneLayout before = view.lanes();
            updateView();
            assertSame(before, view.lanes());
            addStuck("front", 10, 20);
            updateView();
            assertEquals(2, view.lanes().items().size());
            mouse(MouseEvent.MOUSE_PRESSED, 15, MouseEvent.BUTTON1);
            mouse(MouseEvent.MOUSE_DRAGGED, 16, MouseEvent.BUTTON1);
            assertSame(view.lanes(), view.lanes());
            assertEquals(11, view.lanes().items().get(0).start());
        });
    }

    @Test
    void aKeyBeforeTheNextFrameActsOnTheItemThatIsSelected() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            addStuck("left", 30, 40);
            updateView();
            view.select(0, 1);
            editor.remove(0);
            press(KeyEvent.VK_DELETE, 0);
            assertEquals(List.of(), lanes.times());
        });
    }

    @Test
    void anItemStaysSelectedWhenItsSensorIsRenamedButNotInPlaceOfAnother() {
        runOnEdt(() -> {
            addStuck("front", 10, 20);
            addStuck("left", 10, 20);
            addStuck("left", 30, 40);
            updateView();
            view.select(0, 1);
            lanes.run().rename(Rename.ofSensor("left", "port"));
            lanes.run().rename(Rename.ofSensor("front", "bow"));
            updateView();
            assertEquals(1, view.selection());
            assertEquals(
                    new Command.InjectFault("port", new Fault.Stuck(0.3)),
                    view.selectedItem().orElseThrow().command());
            view.select(0, 0);
            editor.remove(0);
            updateView();
            assertEquals(Optional.empty(), view.selectedItem(), "the next one is the same fault of another sensor");
        });
    }

    @Test
    void theRulerHidesTheItemsBelowItFromTheMouse() {
        runOnEdt(() -> {
            addStuck("left", 10, 20);
            JScrollPane pane = new JScrollPane(view);
            pane.setBorder(null);
            pane.setSize(400, 30);
            updateView();
            for (int pass = 0; pass < 2; pass++) {
                pane.doLayout();
                pane.getViewport().doLayout();
            }
            Rectangle2D item = view.lanes().bounds(0);
            pane.getViewport().setViewPosition(new Point(0, (int) item.getMinY() + 1));
            Point at = new Point((int) item.getCenterX(), view.rulerTop() + 1);
            assertTrue(item.contains(at), "the item is below the ruler");
            click(at);
            assertEquals(LaneLayout.NONE, view.selection());
            mouse(MouseEvent.MOUSE_MOVED, at, MouseEvent.NOBUTTON, 0);
            assertEquals(Cursor.DEFAULT_CURSOR, view.getCursor().getType());
            String tip = view.getToolTipText(event(MouseEvent.MOUSE_MOVED, at, MouseEvent.NOBUTTON, 0));
            assertFalse(tip.contains("stuck"), tip);
        });
    }

    /** Presses and releases the left button twice; without a display, the dialog of an item would throw. */
    private void click(Point at) {
        for (int count = 1; count <= 2; count++) {
            mouse(MouseEvent.MOUSE_PRESSED, at, MouseEvent.BUTTON1, count);
            mouse(MouseEvent.MOUSE_RELEASED, at, MouseEvent.BUTTON1, count);
            mouse(MouseEvent.MOUSE_CLICKED, at, MouseEvent.BUTTON1, count);
        }
    }

    @Test
    void noSequenceOfMouseKeysUndoAndRedoBreaksTheLanes() {
        for (int seed = 0; seed < 6; seed++) {
            Random random = new Random(seed);
            runOnEdt(() -> play(random));
        }
    }

    private void play(Random random) {
        for (int i = 0; i < 4; i++) {
            int start = random.nextInt(30);
            addStuck(random.nextBoolean() ? "left" : "front", start, start + 1.0 + random.nextInt(20));
        }
        updateView();
        boolean held = false;
        for (int i = 0; i < 60; i++) {
            int action = random.nextInt(14);
            if (action < 3 && !held) {
                mouse(MouseEvent.MOUSE_PRESSED, itemOrNot(random), MouseEvent.BUTTON1, 1);
                held = true;
            } else if (action < 6 && held) {
                mouse(MouseEvent.MOUSE_DRAGGED, anywhere(random), MouseEvent.BUTTON1, 1);
            } else if (action == 6 && held) {
                release(random);
                held = false;
            } else {
                playKey(action, random);
            }
            if (random.nextInt(3) > 0) {
                updateView();
                paint();
            }
        }
        if (held) {
            release(random);
        }
    }

    /** Releases the button; a new item is cancelled before, because it would be asked for in a dialog. */
    private void release(Random random) {
        if (view.selection() == LaneLayout.NONE) {
            press(KeyEvent.VK_ESCAPE, 0);
        }
        mouse(MouseEvent.MOUSE_RELEASED, anywhere(random), MouseEvent.BUTTON1, 1);
    }

    private void playKey(int action, Random random) {
        switch (action) {
            case 7, 12 -> undo.redo();
            case 8, 13 -> {
                if (!press(KeyEvent.VK_Z, MENU)) {
                    undo.undo();
                }
            }
            case 9 -> press(KEYS[random.nextInt(KEYS.length)], 0);
            case 10 ->
                press(
                        random.nextBoolean() ? KeyEvent.VK_LEFT : KeyEvent.VK_RIGHT,
                        MODIFIERS[random.nextInt(MODIFIERS.length)]);
            default -> press(CLIPBOARD_KEYS[random.nextInt(CLIPBOARD_KEYS.length)], MENU);
        }
    }

    private static Point anywhere(Random random) {
        return new Point(60 + random.nextInt(740), random.nextInt(80));
    }

    private Point itemOrNot(Random random) {
        int items = view.lanes().items().size();
        if (items == 0 || random.nextInt(4) == 0) {
            return anywhere(random);
        }
        Rectangle2D bounds = view.lanes().bounds(random.nextInt(items));
        return new Point((int) (bounds.getX() + random.nextDouble() * bounds.getWidth()), (int) bounds.getCenterY());
    }

    private void addStuck(String sensor, double start, double end) {
        Command stuck = new Command.InjectFault(sensor, new Fault.Stuck(0.3));
        editor.add(TimelineItem.from(stuck, start).withTimes(start, end), null);
    }

    private void updateView() {
        view.update(view.allLanes(), view.axis(), 0);
    }

    private void paint() {
        BufferedImage image = new BufferedImage(view.getWidth(), view.getHeight(), BufferedImage.TYPE_INT_RGB);
        view.paint(image.createGraphics());
    }

    /** Sends an event of a button at a time in the first lane. */
    private void mouse(int type, double time, int button) {
        int y = view.lanes().laneTop(0) + view.lanes().laneHeight(0) / 2;
        mouse(type, new Point((int) Math.ceil(view.axis().x(time)), y), button, 1);
    }

    private void mouse(int type, Point at, int button, int clicks) {
        view.dispatchEvent(event(type, at, button, clicks));
    }

    private MouseEvent event(int type, Point at, int button, int clicks) {
        int modifiers = Stream.of(button)
                .filter(pressed -> pressed != MouseEvent.NOBUTTON)
                .mapToInt(InputEvent::getMaskForButton)
                .sum();
        return new MouseEvent(view, type, 0, modifiers, at.x, at.y, clicks, false, button);
    }

    /** Returns whether the lanes consume a key. */
    private boolean press(int key, int modifiers) {
        return SwingUtilities.processKeyBindings(
                new KeyEvent(view, KeyEvent.KEY_PRESSED, 0, modifiers, key, KeyEvent.CHAR_UNDEFINED));
    }
}
