package faultline.gui.theme;

import java.awt.Component;
import java.awt.Container;
import java.awt.Font;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.UIManager;

/**
 * The properties that components derive from the language or the text size, such as a name or a width. The steps that
 * derive them are stored in the components, and repeated when the language or the text size changes.
 */
public final class RefreshSteps {

    private static final String STEPS = "faultline.refreshSteps";

    private record Steps(List<Runnable> all) {}

    private RefreshSteps() {}

    /** Runs a step now and with every refresh of a component; returns the component. */
    public static <C extends JComponent> C add(C component, Consumer<? super C> step) {
        Runnable bound = () -> step.accept(component);
        Stream<Runnable> before = stepsOf(component);
        component.putClientProperty(
                STEPS, new Steps(Stream.concat(before, Stream.of(bound)).toList()));
        bound.run();
        return component;
    }

    private static Stream<Runnable> stepsOf(JComponent component) {
        return component.getClientProperty(STEPS) instanceof Steps steps ? steps.all().stream() : Stream.empty();
    }

    /** Repeats the steps of a component in their order. */
    public static void run(Component component) {
        if (component instanceof JComponent swing) {
            stepsOf(swing).forEach(Runnable::run);
        }
    }

    /** Gives a component a bold font; a step for {@link #add}, because the font follows the text size. */
    public static void embolden(JComponent component) {
        component.setFont(UIManager.getFont("Label.font").deriveFont(Font.BOLD));
    }

    /** Returns the components of a container, or those of the popup of a menu. */
    public static List<Component> childrenOf(Component component) {
        if (component instanceof JMenu menu) {
            return List.of(menu.getMenuComponents());
        }
        return component instanceof Container container ? List.of(container.getComponents()) : List.of();
    }
}
