package faultline.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.awt.Window;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Fails a test in which a component is changed outside the event dispatch thread, or in which an exception is not
 * caught. Disposes of the windows that a failed test has left open, which could block the tests after it.
 */
public final class EdtChecker implements BeforeEachCallback, AfterEachCallback {

    private final List<String> violations = new CopyOnWriteArrayList<>();
    private RepaintManager previousManager;
    private Thread.UncaughtExceptionHandler previousHandler;

    @Override
    public void beforeEach(ExtensionContext context) {
        previousManager = RepaintManager.currentManager(null);
        previousHandler = Thread.getDefaultUncaughtExceptionHandler();
        violations.clear();
        RepaintManager.setCurrentManager(new CheckingRepaintManager());
        Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> {
            fault.printStackTrace();
            violations.add("uncaught on " + thread.getName() + ": " + fault);
        });
    }

    @Override
    public void afterEach(ExtensionContext context) {
        RepaintManager.setCurrentManager(previousManager);
        Thread.setDefaultUncaughtExceptionHandler(previousHandler);
        GuiRobot.runOnEdt(() -> Stream.of(Window.getWindows()).forEach(Window::dispose));
        assertEquals(List.of(), violations);
    }

    List<String> violations() {
        return violations;
    }

    /** Checks every change of a visible component. */
    private final class CheckingRepaintManager extends RepaintManager {
        @Override
        public synchronized void addInvalidComponent(JComponent component) {
            check(component);
            super.addInvalidComponent(component);
        }

        @Override
        public void addDirtyRegion(JComponent component, int x, int y, int width, int height) {
            check(component);
            super.addDirtyRegion(component, x, y, width, height);
        }

        private void check(JComponent component) {
            if (!EventQueue.isDispatchThread()) {
                violations.add(component.getClass().getName() + " was changed on thread "
                        + Thread.currentThread().getName());
            }
        }
    }
}
