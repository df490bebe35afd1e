package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.action.Keystrokes;
import faultline.gui.change.Rename;
import faultline.gui.edit.UndoController;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import faultline.robot.MotorFaultKind;
import faultline.robot.MotorSide;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The times of items that are copied and moved, in a scenario with ticks of 0.01 s. */
@ExtendWith(EdtChecker.class)
class LaneActionsTest {

    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.CircleShape(0.1), new Pose(1, 1, 0));
    private static final Fault STUCK = new Fault.Stuck(0.3);
    /** Times of a file, which need not be whole ticks. */
    private static final double START = 4.1234;

    private static final double END = 9.4567;

    private OpenLanes lanes;
    private UndoController undo;
    private TimelineEditor editor;
    private LaneView view;
    private LaneActions actions;

    @BeforeEach
    void openWithOneFault() {
        lanes = OpenLanes.open();
        undo = lanes.undo();
        editor = lanes.editor();
        view = lanes.view();
        runOnEdt(() -> {
            actions = new LaneActions(view, editor);
            lanes.run()
                    .change(old -> old.withSetup(old.setup()
                            .withTimeline(List.of(
                                    new TimedCommand(START, new Command.InjectFault("left", STUCK)),
                                    new TimedCommand(END, new Command.ClearFault("left", STUCK))))));
            view.update(Stream.<Lane>of(new Lane.SensorLane("left"), Lane.OTHER).toList(), new TimeAxis(0, 800, 60), 0);
            view.select(0, 0);
        });
    }

    @AfterEach
    void close() {
        lanes.close();
    }

    private List<Double> times() {
        return callOnEdt(lanes::times);
    }

    @Test
    void aPastedFaultStartsAndEndsAtWholeTicks() {
        runOnEdt(() -> {
            actions.copy();
            actions.paste(13.29);
        });
        assertEquals(List.of(START, END, 13.29, 18.62), times());
    }

    /** The clipboard keeps an item when another scenario is opened. */
    @Test
    void anItemIsNotPastedIntoAScenarioWithoutItsSensor() {
        runOnEdt(() -> {
            actions.copy();
            lanes.run()
                    .change(old -> old.withSetup(old.setup()
                            .withRobot(old.setup().robot().withSensors(List.of()))
                            .withTimeline(List.of())));
            view.select(1, LaneLayout.NONE);
            actions.paste(13.29);
        });
        assertEquals(List.of(), times());
        assertFalse(callOnEdt(() -> menuItem("Paste here").isEnabled()));
    }

    @Test
    void aMoveIsNotPastedIntoAScenarioWithoutItsObstacle() {
        TimelineItem put = TimelineItem.from(new Command.PlaceObstacle(BOX), 5);
        runOnEdt(() -> {
            editor.add(put, null);
            editor.add(TimelineItem.from(new Command.MoveObstacle("box", new Pose(2, 1, 0)), 6), null);
            editor.copy(2);
            actions.paste(13.29);
        });
        assertEquals(List.of(START, END, 5.0, 6.0, 13.29), times());
        runOnEdt(() -> editor.remove(1));
        assertEquals(List.of(START, END), times(), "a move of nothing is not in the scenario");
        runOnEdt(() -> actions.paste(15));
        assertEquals(List.of(START, END), times());
        String note = "\"box moved to 2.000, 1.000, 0.0°\" is not pasted: the scenario lacks its sensor or obstacle";
        assertEquals(List.of(note), lanes.notes());
        runOnEdt(undo::undo);
        assertEquals(List.of(START, END, 5.0, 6.0, 13.29), times());
    }

    @Test
    void aMoveThatIsCopiedSelectedOrRestoredFollowsItsObstacle() {
        TimelineItem move = TimelineItem.from(new Command.MoveObstacle("box", new Pose(2, 1, 0)), 6);
        TimelineItem renamed = TimelineItem.from(new Command.MoveObstacle("crate", new Pose(2, 1, 0)), 6);
        runOnEdt(() -> {
            editor.add(TimelineItem.from(new Command.PlaceObstacle(BOX), 5), null);
            editor.add(move, null);
            view.select(move);
            actions.copy();
            lanes.run().rename(Rename.ofObstacle("box", "crate"));
            updateView();
            assertEquals(Optional.of(renamed), view.selectedItem());
            actions.paste(13.29);
            assertEquals(Optional.of(renamed.withTimes(13.29, 13.29)), view.selectedItem());
            undo.undo();
            lanes.run().rename(Rename.ofObstacle("crate", "chest"));
            updateView();
            TimelineItem last = TimelineItem.from(new Command.MoveObstacle("chest", new Pose(2, 1, 0)), 6);
            assertEquals(Optional.of(last), view.selectedItem());
        });
    }

    private JMenuItem menuItem(String text) {
        return Stream.of(actions.createMenu(0).getComponents())
                .filter(JMenuItem.class::isInstance)
                .map(JMenuItem.class::cast)
                .filter(item -> item.getText().equals(text))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aDuplicateFollowsAtWholeTicks() {
        runOnEdt(actions::duplicate);
        assertEquals(List.of(START, END, 9.46, 14.79), times());
    }

    @Test
    void aDuplicateOfAFaultWithoutAnEndIsOneStepLater() {
        runOnEdt(() -> {
            TimelineItem open = TimelineItem.from(new Command.InjectFault("left", new Fault.Stuck(0.5)), 20);
            editor.add(open, null);
            view.select(open);
            actions.duplicate();
            assertEquals(20 + actions.step(), view.selectedItem().orElseThrow().start());
        });
    }

    @Test
    void aDigitIsTypedIntoTheLanes() {
        assertTrue(callOnEdt(() -> Keystrokes.isTypedInto(view, Keystrokes.unmodified(KeyEvent.VK_3))));
    }

    @Test
    void theKeysOfTheClipboardHaveTheMenuModifier() {
        List<String> keys = callOnEdt(() -> Stream.of(KeyEvent.VK_C, KeyEvent.VK_X, KeyEvent.VK_V, KeyEvent.VK_D)
                .map(Keystrokes::menuShortcut)
                .map(stroke -> String.valueOf(view.getInputMap().get(stroke)))
                .toList());
        assertEquals(List.of("menu C", "menu X", "menu V", "menu D"), keys);
    }

    @Test
    void theKeyOfUndoCancelsADrag() {
        runOnEdt(() -> {
            view.setSize(800, 100);
            actions.duplicate();
            updateView();
            assertFalse(pressUndo(), "without a drag the key is that of the menu");
            List<TimedCommand> before = editor.model().commands();
            drag(MouseEvent.MOUSE_PRESSED, 11);
            drag(MouseEvent.MOUSE_DRAGGED, 20);
            assertTrue(view.preview().isPresent());
            assertTrue(pressUndo());
            drag(MouseEvent.MOUSE_DRAGGED, 30);
            drag(MouseEvent.MOUSE_RELEASED, 30);
            assertEquals(before, editor.model().commands());
        });
    }

    @Test
    void escapeCancelsADragThatDrawsAFault() {
        runOnEdt(() -> {
            view.setSize(800, 100);
            drag(MouseEvent.MOUSE_PRESSED, 20);
            drag(MouseEvent.MOUSE_DRAGGED, 30);
            assertTrue(view.preview().isPresent());
            press(KeyEvent.VK_ESCAPE, 0);
            drag(MouseEvent.MOUSE_DRAGGED, 40);
            assertEquals(Optional.empty(), view.preview());
        });
    }

    /** Sends an event of the left button at a time in the first lane. */
    private void drag(int type, double time) {
        drag(type, time, 0);
    }

    /** Sends an event of the left button at a time in a lane. */
    private void drag(int type, double time, int lane) {
        view.dispatchEvent(new MouseEvent(
                view,
                type,
                0,
                InputEvent.BUTTON1_DOWN_MASK,
                (int) view.axis().x(time),
                view.lanes().laneTop(lane) + view.lanes().laneHeight(lane) / 2,
                1,
                false,
                MouseEvent.BUTTON1));
    }

    /** Returns whether the lanes consume the key. */
    private boolean pressUndo() {
        return press(KeyEvent.VK_Z, KeyBindings.menuMask());
    }

    private boolean press(int key, int modifiers) {
        return SwingUtilities.processKeyBindings(
                new KeyEvent(view, KeyEvent.KEY_PRESSED, 0, modifiers, key, KeyEvent.CHAR_UNDEFINED));
    }

    private void updateView() {
        view.update(view.allLanes(), view.axis(), 0);
    }

    @Test
    void undoSelectsWhatWasSelectedBeforeAndRedoWhatTheEditMade() {
        runOnEdt(() -> {
            TimelineItem original = view.selectedItem().orElseThrow();
            actions.duplicate();
            TimelineItem copy = view.selectedItem().orElseThrow();
            assertNotEquals(original, copy);
            undo.undo();
            updateView();
            assertEquals(Optional.of(original), view.selectedItem());
            undo.redo();
            updateView();
            assertEquals(Optional.of(copy), view.selectedItem());
            actions.delete();
            undo.undo();
            updateView();
            assertEquals(Optional.of(copy), view.selectedItem(), "it is back");
            undo.redo();
            updateView();
            assertEquals(Optional.empty(), view.selectedItem());
        });
    }

    @Test
    void theSelectionStaysWhenAnotherItemIsAdded() {
        runOnEdt(() -> {
            TimelineItem selected = view.selectedItem().orElseThrow();
            editor.add(TimelineItem.from(new Command.InjectFault("left", new Fault.Stuck(0.5)), 1), null);
            updateView();
            assertEquals(Optional.of(selected), view.selectedItem());
            assertEquals(1, view.selection());
        });
    }

    @Test
    void lanesStayAtTheirTopIfTheFirstItemIsVisibleThere() {
        List<Lane> lanes = Stream.of("1", "left", "3", "4", "5", "6")
                .<Lane>map(Lane.SensorLane::new)
                .toList();
        runOnEdt(() -> {
            JScrollPane pane = new JScrollPane(view);
            pane.setBorder(null);
            view.startScenario();
            view.update(lanes, view.axis(), 0);
            pane.setSize(400, 14 + 5 * 15);
            for (int pass = 0; pass < 2; pass++) {
                pane.doLayout();
                pane.getViewport().doLayout();
            }
        });
        runOnEdt(() -> {
            assertEquals(15, view.getHeight() - view.getVisibleRect().height, "one of six rows of 15 pixels is hidden");
            assertEquals(0, view.rulerTop());
        });
    }

    @Test
    void theLanesOfAnotherScenarioBeginWithTheFirstThatHasAnItemBelowTheRuler() {
        List<Lane> ten = Stream.of("1", "2", "3", "4", "5", "left", "7", "8", "9", "10", "11", "12")
                .<Lane>map(Lane.SensorLane::new)
                .toList();
        JScrollPane scroll = callOnEdt(() -> {
            JScrollPane pane = new JScrollPane(view);
            pane.setSize(400, 70);
            view.startScenario();
            view.update(ten, view.axis(), 0);
            for (int pass = 0; pass < 2; pass++) {
                pane.doLayout();
                pane.getViewport().doLayout();
            }
            return pane;
        });
        runOnEdt(() -> {
            LaneLayout lanes = view.lanes();
            assertEquals(5, lanes.laneAt(view.rulerTop() + lanes.top() + 1.0));
            assertTrue(view.rulerTop() > 0);
            view.select(11, LaneLayout.NONE);
            assertTrue(view.getVisibleRect().contains(1, lanes.laneTop(11) + lanes.laneHeight(11) - 1));
            view.select(2, LaneLayout.NONE);
            assertTrue(lanes.laneTop(2) >= view.rulerTop() + lanes.top(), "not below the ruler");
        });
        assertEquals(scroll.getViewport(), callOnEdt(view::getParent));
    }

    @Test
    void theEndThatIsNotMovedKeepsTheTimeOfTheFile() {
        runOnEdt(() -> actions.move(0, 1));
        assertEquals(START, times().get(0));
        runOnEdt(() -> {
            editor.replace(0, editor.model().items().get(0).withTimes(START, END));
            view.update(view.allLanes(), view.axis(), 1);
            view.select(0, 0);
            actions.move(-1, 0);
        });
        assertEquals(END, times().get(1));
    }

    @Test
    void arrowKeysMoveTheEndOrTheStartOrBothByAStep() {
        runOnEdt(() -> {
            editor.replace(0, editor.model().items().get(0).withTimes(10, 20));
            updateView();
            view.select(0, 0);
            double step = actions.step();
            assertMoved(KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK, 10, 20 + step);
            assertMoved(KeyEvent.VK_RIGHT, InputEvent.ALT_DOWN_MASK, 10 + step, 20 + step);
            assertMoved(KeyEvent.VK_RIGHT, KeyBindings.menuMask(), 10 + 2 * step, 20 + 2 * step);
            assertMoved(KeyEvent.VK_LEFT, KeyBindings.menuMask(), 10 + step, 20 + step);
            assertMoved(KeyEvent.VK_LEFT, InputEvent.SHIFT_DOWN_MASK, 10 + step, 20);
            assertMoved(KeyEvent.VK_LEFT, InputEvent.ALT_DOWN_MASK, 10, 20);
        });
    }

    private void assertMoved(int key, int modifiers, double start, double end) {
        assertTrue(press(key, modifiers));
        TimelineItem moved = view.selectedItem().orElseThrow();
        assertEquals(start, moved.start(), 1e-9);
        assertEquals(end, moved.end(), 1e-9);
        assertEquals(List.of(moved.start(), moved.end()), lanes.times());
    }

    @Test
    void arrowKeysSelectLanesAndItemsUpToTheLastAndBackspaceDeletes() {
        runOnEdt(() -> {
            actions.duplicate();
            updateView();
            view.select(0, LaneLayout.NONE);
            press(KeyEvent.VK_LEFT, 0);
            assertEquals(1, view.selection(), "the last one");
            press(KeyEvent.VK_LEFT, 0);
            press(KeyEvent.VK_LEFT, 0);
            assertEquals(0, view.selection());
            press(KeyEvent.VK_RIGHT, 0);
            press(KeyEvent.VK_RIGHT, 0);
            assertEquals(1, view.selection());
            view.select(0, LaneLayout.NONE);
            press(KeyEvent.VK_RIGHT, 0);
            assertEquals(0, view.selection(), "the first one");
            press(KeyEvent.VK_BACK_SPACE, 0);
            assertEquals(2, lanes.times().size());
            for (int lane : new int[] {1, 1}) {
                press(KeyEvent.VK_DOWN, 0);
                assertEquals(lane, view.lane());
            }
            for (int lane : new int[] {0, 0}) {
                press(KeyEvent.VK_UP, 0);
                assertEquals(lane, view.lane());
            }
        });
    }

    @Test
    void aStartThatIsMovedBehindTheEndStaysATickBeforeIt() {
        runOnEdt(() -> {
            TimelineItem item = view.selectedItem().orElseThrow().withTimes(10, 20);
            TimelineItem moved = actions.withEnds(item, 25, 20);
            assertEquals(List.of(19.99, 20.0), List.of(moved.start(), moved.end()));
            moved = actions.withEnds(item, 10, 5);
            assertEquals(List.of(10.0, 10.01), List.of(moved.start(), moved.end()));
        });
    }

    @Test
    void aNewFaultIsLikeTheLastOneOfItsKindOfLane() {
        runOnEdt(() -> {
            actions.copy();
            actions.paste(20);
            TimelineItem item = actions.newFault(30, 35).orElseThrow();
            assertEquals(new Command.InjectFault("left", STUCK), item.command());
            Lane motors = new Lane.MotorLane(MotorSide.RIGHT);
            view.update(List.of(motors, Lane.OTHER), view.axis(), 0);
            view.select(0, LaneLayout.NONE);
            double weak = MotorFaultKind.WEAK.defaultValue();
            assertEquals(
                    new Command.InjectMotorFault(MotorSide.RIGHT, MotorFaultKind.WEAK.createFault(weak)),
                    actions.newFault(30, 35).orElseThrow().command());
        });
    }

    @Test
    void theMenuOffersWhatTheLaneAndTheItemAllow() {
        assertEquals(List.of(true, true, true, false, true, true, false, true, true), enabledMenuItems());
        runOnEdt(() -> view.select(1, LaneLayout.NONE));
        assertEquals(List.of(false, false, false, true, false, false, false, false, false), enabledMenuItems());
    }

    private List<Boolean> enabledMenuItems() {
        return callOnEdt(() -> ComponentFinder.findAll(actions.createMenu(0), JMenuItem.class)
                .map(JMenuItem::isEnabled)
                .toList());
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void everyItemOfTheMenuHasAUniqueMnemonic(Language language) {
        List<JMenuItem> items = callOnEdt(() -> {
            Messages.setLanguage(language);
            try {
                return ComponentFinder.findAll(actions.createMenu(0), JMenuItem.class)
                        .toList();
            } finally {
                Messages.setLanguage(Language.ENGLISH);
            }
        });
        assertEquals(9, items.size());
        for (JMenuItem item : items) {
            String letter = String.valueOf((char) item.getMnemonic()).toLowerCase(Locale.ROOT);
            assertTrue(item.getText().toLowerCase(Locale.ROOT).contains(letter), item.getText() + " " + letter);
            assertEquals(
                    1,
                    items.stream()
                            .filter(other -> other.getMnemonic() == item.getMnemonic())
                            .count(),
                    item.getText());
        }
    }

    @Test
    void aFaultThatOverlapsAnEqualOneIsNoted() {
        TimelineItem equal = TimelineItem.from(new Command.InjectFault("left", STUCK), 0);
        runOnEdt(() -> {
            editor.add(equal.withTimes(END, 20), null);
            editor.add(TimelineItem.from(new Command.InjectFault("left", new Fault.Stuck(0.4)), 5), null);
            editor.add(TimelineItem.from(new Command.InjectFault("front", STUCK), 5), null);
            assertEquals(List.of(), lanes.notes());
            editor.add(equal.withTimes(END - 1, END), null);
        });
        assertEquals(
                List.of("\"left: stuck 0.30 m\" overlaps an equal fault; an end is that of the older one"),
                lanes.notes());
    }

    @Test
    void aFaultIsNotPastedIntoALaneThatCannotHaveIt() {
        runOnEdt(() -> {
            actions.copy();
            view.select(1, LaneLayout.NONE);
            actions.paste(13.29);
        });
        assertEquals(List.of(START, END), times());
        assertEquals(
                List.of("\"left: stuck 0.30 m\" is not pasted: it cannot be in the lane \"other\""), lanes.notes());
        assertFalse(callOnEdt(() -> menuItem("Paste here").isEnabled()));
    }

    @Test
    void aDragMovesAFaultToAnotherLaneThatCanHaveIt() {
        runOnEdt(() -> {
            view.setSize(800, 100);
            List<Lane> shown = List.of(new Lane.SensorLane("left"), new Lane.SensorLane("front"), Lane.OTHER);
            view.update(shown, view.axis(), 0);
            double middle = (START + END) / 2;
            drag(MouseEvent.MOUSE_PRESSED, middle, 0);
            drag(MouseEvent.MOUSE_DRAGGED, middle, 2);
            assertEquals(Optional.empty(), view.preview(), "it cannot be there");
            drag(MouseEvent.MOUSE_DRAGGED, middle, 1);
            drag(MouseEvent.MOUSE_RELEASED, middle, 1);
            TimelineItem front = new TimelineItem(new Command.InjectFault("front", STUCK), START, END);
            assertEquals(List.of(front), editor.model().items());
            assertEquals(Optional.of(front), view.selectedItem());
            drag(MouseEvent.MOUSE_PRESSED, middle, 1);
            drag(MouseEvent.MOUSE_DRAGGED, middle + 10, 0);
            drag(MouseEvent.MOUSE_RELEASED, middle + 10, 0);
            assertEquals(
                    new Lane.SensorLane("left"), editor.model().items().get(0).lane());
            assertTrue(editor.model().items().get(0).start() > START + 9);
        });
    }
}
