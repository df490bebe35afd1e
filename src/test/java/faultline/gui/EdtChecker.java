package faultline.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.text.SwingMessages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.EventQueue;
import java.awt.Window;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.MenuSelectionManager;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * Fails a test in which a component is changed outside the event dispatch thread, or in which an exception is not
 * caught. Closes the windows and the menus that a failed test has left open, and restores the language, the text size,
 * the theme and the locale that it has changed, all of which could make the tests after it fail.
 */
public final class EdtChecker implements BeforeEachCallback, AfterEachCallback {

    private final List<String> violations = new CopyOnWriteArrayList<>();
    private RepaintManager previousManager;
    private Thread.UncaughtExceptionHandler previousHandler;
    private Choices previousChoices;

    @Override
    public void beforeEach(ExtensionContext context) {
        previousManager = RepaintManager.currentManager(null);
        previousHandler = Thread.getDefaultUncaughtExceptionHandler();
        previousChoices = GuiRobot.callOnEdt(Choices::current);
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
        GuiRobot.runOnEdt(() -> {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            Stream.of(Window.getWindows()).forEach(Window::dispose);
            if (!Choices.current().equals(previousChoices)) {
                previousChoices.install();
            }
        });
        assertEquals(List.of(), violations);
    }

    List<String> violations() {
        return violations;
    }

    /** What a user can choose for all windows, and the locale. */
    private record Choices(Language language, TextSize size, Theme theme, Locale locale) {

        static Choices current() {
            return new Choices(Messages.language(), TextSize.current(), Theme.current(), Locale.getDefault());
        }

        void install() {
            Locale.setDefault(locale);
            Messages.setLanguage(language);
            SwingMessages.install();
            size.install();
            theme.install();
        }
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
