package faultline.gui;

import static org.junit.jupiter.api.Assertions.fail;

import java.awt.AWTEvent;
import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/**
 * Drives real windows with mouse and keyboard. All reads happen on the event dispatch thread, and nothing sleeps: a
 * test waits for a condition with a deadline, and the description of the condition is the failure message.
 */
public final class GuiRobot {

    /** The deadline of a condition; generous, because only a failing test waits that long. */
    private static final long DEADLINE_SECONDS = 60;

    /** The interval at which a waiting test requests the focus, as a user would by a click. */
    private static final long FOCUS_RETRY_NANOS = TimeUnit.SECONDS.toNanos(3);

    /** The number of mouse moves in a drag, so that components see a continuous motion. */
    private static final int DRAG_STEPS = 10;

    private final Robot robot;

    public GuiRobot() {
        try {
            robot = new Robot();
        } catch (AWTException noDisplay) {
            throw new IllegalStateException("tests of windows need a display", noDisplay);
        }
    }

    /** Returns the value of an expression evaluated on the event dispatch thread. */
    public static <T> T callOnEdt(Callable<T> expression) {
        FutureTask<T> task = new FutureTask<>(expression);
        try {
            EventQueue.invokeAndWait(task);
            return task.get();
        } catch (ExecutionException broken) {
            throw new AssertionError("broke on the event dispatch thread", broken.getCause());
        } catch (InterruptedException | InvocationTargetException broken) {
            throw new AssertionError(broken);
        }
    }

    /** Runs an action on the event dispatch thread and waits until it is done. */
    public static void runOnEdt(Runnable action) {
        callOnEdt(() -> {
            action.run();
            return true;
        });
    }

    /** Waits until a condition, evaluated on the event dispatch thread, is true. */
    public void waitFor(String what, Callable<Boolean> condition) {
        repeatUntil(what, condition, robot::waitForIdle);
    }

    /** Repeats an action until a condition, evaluated on the event dispatch thread, is true. */
    public void repeatUntil(String what, Callable<Boolean> condition, Runnable action) {
        long begun = System.nanoTime();
        for (int nudges = 1; !callOnEdt(condition); action.run()) {
            long waited = System.nanoTime() - begun;
            if (waited > TimeUnit.SECONDS.toNanos(DEADLINE_SECONDS)) {
                fail("waited " + DEADLINE_SECONDS + " s without success until " + what + "; "
                        + callOnEdt(GuiRobot::describeWindows));
            }
            if (waited > nudges * FOCUS_RETRY_NANOS) {
                int turn = nudges++;
                runOnEdt(() -> focusNextWindow(turn));
            }
        }
    }

    /** Describes the visible windows and the focus, for failure messages. */
    private static String describeWindows() {
        KeyboardFocusManager focus = KeyboardFocusManager.getCurrentKeyboardFocusManager();
        String windows = Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .map(GuiRobot::describe)
                .collect(Collectors.joining(", "));
        String menus = Stream.of(MenuSelectionManager.defaultManager().getSelectedPath())
                .map(menu -> describe(menu.getComponent()))
                .collect(Collectors.joining(", "));
        return "showing: " + windows + "; active: " + describe(focus.getActiveWindow()) + "; focused: "
                + describe(focus.getFocusOwner()) + "; open menus: " + menus;
    }

    /** Returns the class and the title or name of a component, "nothing" for null. */
    private static String describe(Component component) {
        if (component == null) {
            return "nothing";
        }
        String title = component instanceof Frame frame
                ? frame.getTitle()
                : component instanceof Dialog dialog ? dialog.getTitle() : ComponentFinder.accessibleName(component);
        return component.getClass().getName() + " \"" + title + "\"";
    }

    /**
     * Gives the focus to a window as a click on it would: on a busy machine a window manager now and then gives it to
     * nobody when a dialog closes, and keeps it where it was when one opens late. Where several windows may have it,
     * they take turns.
     */
    private static void focusNextWindow(int turn) {
        List<Window> showing = Stream.of(Window.getWindows())
                .filter(window -> window.isShowing() && window.isFocusableWindow())
                .toList();
        List<Window> modal = showing.stream()
                .filter(window -> window instanceof Dialog dialog && dialog.isModal())
                .toList();
        List<Window> able = modal.isEmpty() ? showing : modal;
        if (!able.isEmpty()) {
            Window next = able.get(Math.floorMod(-turn, able.size()));
            if (!next.isFocused()) {
                next.toFront();
                next.requestFocus();
            }
        }
    }

    /** Shows a window and waits until it has its location and the focus. */
    public void open(Window window) {
        runOnEdt(() -> window.setVisible(true));
        waitFor("the window shows", window::isShowing);
        runOnEdt(window::toFront);
        waitFor("the window is focused", window::isFocused);
        waitUntilPlaced(window);
    }

    /** Waits until the location of a window that has moved is the same for Java and for the screen. */
    public void waitUntilPlaced(Window window) {
        waitUntilStill(window);
        waitUntilMouseReaches(window);
    }

    /**
     * A window manager may move a window once more after it has come to rest, and Java learns of it late. So the mouse
     * is moved to the middle of where the window is thought to be until an event says that it is there.
     */
    private void waitUntilMouseReaches(Window window) {
        AtomicReference<Point> hit = new AtomicReference<>(new Point());
        Consumer<MouseEvent> listener =
                mouse -> hit.set(SwingUtilities.convertPoint(mouse.getComponent(), mouse.getPoint(), window));
        int[] turn = {0};
        whileListening(
                AWTEvent.MOUSE_MOTION_EVENT_MASK,
                listener,
                () -> waitFor("the mouse is where the window is", () -> {
                    Point aim = new Point(window.getWidth() / 2 + 3 * (turn[0] % 2), window.getHeight() / 2);
                    boolean there =
                            hit.get().distance(window.getWidth() / 2 + 3 * ((turn[0] + 1) % 2), window.getHeight() / 2)
                                    < 1.5;
                    Point origin = window.getLocationOnScreen();
                    robot.mouseMove(origin.x + aim.x, origin.y + aim.y);
                    turn[0]++;
                    return there;
                }));
    }

    /** Runs an action that a listener to all mouse events of some kinds, an AWTEvent mask, observes. */
    private static void whileListening(long kinds, Consumer<MouseEvent> listener, Runnable action) {
        AWTEventListener adapter = event -> listener.accept((MouseEvent) event);
        runOnEdt(() -> Toolkit.getDefaultToolkit().addAWTEventListener(adapter, kinds));
        try {
            action.run();
        } finally {
            runOnEdt(() -> Toolkit.getDefaultToolkit().removeAWTEventListener(adapter));
        }
    }

    private void waitUntilStill(Component component) {
        Point[] last = {new Point(Integer.MIN_VALUE, 0)};
        waitFor("the window stands still", () -> {
            Point now = component.getLocationOnScreen();
            boolean still = now.equals(last[0]);
            last[0] = now;
            return still;
        });
    }

    /** Disposes of a window. */
    public void close(Window window) {
        runOnEdt(window::dispose);
        robot.waitForIdle();
    }

    /** Waits until all pending painting is done. */
    public void waitForPaint() {
        runOnEdt(() -> Toolkit.getDefaultToolkit().sync());
        robot.waitForIdle();
    }

    /** Moves the mouse to a point of a component. */
    public void moveTo(Component component, double x, double y) {
        Point origin = callOnEdt(component::getLocationOnScreen);
        robot.mouseMove(origin.x + (int) Math.round(x), origin.y + (int) Math.round(y));
        robot.waitForIdle();
    }

    /** Presses and releases a mouse button, an InputEvent mask, at a point of a component. */
    public void click(Component component, double x, double y, int button) {
        moveTo(component, x, y);
        whilePressing(button, () -> {});
    }

    /**
     * Clicks the left mouse button twice at a point of a component, and again if the clicks were too far apart in time
     * for a double click, as they may be on a busy machine.
     */
    public void doubleClick(Component component, double x, double y) {
        AtomicBoolean isDouble = new AtomicBoolean();
        Consumer<MouseEvent> listener = mouse -> {
            if (mouse.getID() == MouseEvent.MOUSE_CLICKED
                    && mouse.getClickCount() == 2
                    && mouse.getComponent() == component) {
                isDouble.set(true);
            }
        };
        moveTo(component, x, y);
        whileListening(
                AWTEvent.MOUSE_EVENT_MASK,
                listener,
                () -> repeatUntil("two clicks are a double click", isDouble::get, this::clickTwice));
    }

    /** Waits for nothing between the clicks, which would add to the time between them. */
    private void clickTwice() {
        for (int i = 0; i < 2; i++) {
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        }
        robot.waitForIdle();
    }

    /** Presses a mouse button, an InputEvent mask, at the current position during an action. */
    public void whilePressing(int button, Runnable action) {
        robot.mousePress(button);
        robot.waitForIdle();
        try {
            action.run();
        } finally {
            robot.mouseRelease(button);
            robot.waitForIdle();
        }
    }

    /** Moves the mouse in small steps between two points of a component without changing the buttons. */
    public void moveSmoothly(Component component, double fromX, double fromY, double toX, double toY) {
        for (int step = 0; step <= DRAG_STEPS; step++) {
            double share = (double) step / DRAG_STEPS;
            moveTo(component, fromX + share * (toX - fromX), fromY + share * (toY - fromY));
        }
    }

    /** Drags with a mouse button, an InputEvent mask, between two points of a component. */
    public void drag(Component component, double fromX, double fromY, double toX, double toY, int button) {
        moveTo(component, fromX, fromY);
        whilePressing(button, () -> moveSmoothly(component, fromX, fromY, toX, toY));
    }

    /** Rotates the wheel at the current position; negative notches are away from the user. */
    public void rotateWheel(int notches) {
        robot.mouseWheel(notches);
        robot.waitForIdle();
    }

    /** Presses keys, KeyEvent codes, in order and releases them in reverse: modifiers first. */
    public void pressKeys(int... keys) {
        for (int key : keys) {
            robot.keyPress(key);
        }
        for (int i = keys.length - 1; i >= 0; i--) {
            robot.keyRelease(keys[i]);
        }
        robot.waitForIdle();
    }

    /** Holds a key, a KeyEvent code, during an action. */
    public void whileHolding(int key, Runnable action) {
        robot.keyPress(key);
        robot.waitForIdle();
        try {
            action.run();
        } finally {
            robot.keyRelease(key);
            robot.waitForIdle();
        }
    }
}
