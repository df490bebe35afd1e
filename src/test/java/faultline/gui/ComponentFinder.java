package faultline.gui;

import java.awt.Component;
import java.awt.Container;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JMenu;

/** Finds components in a window by class and accessible name, and lays out those of a window that is not shown. */
public final class ComponentFinder {

    private ComponentFinder() {}

    /** Returns a component and all its descendants, menus included, parents first. */
    public static Stream<Component> tree(Component root) {
        Stream<Component> inside =
                root instanceof Container container ? Stream.of(container.getComponents()) : Stream.empty();
        Stream<Component> items = root instanceof JMenu menu ? Stream.of(menu.getMenuComponents()) : Stream.empty();
        return Stream.concat(Stream.of(root), Stream.concat(inside, items).flatMap(ComponentFinder::tree));
    }

    /** Lays out a component and all inside it, each with the size that its container has given it. */
    public static void layOut(Component root) {
        tree(root).forEach(Component::doLayout);
    }

    /** Returns all components of a class. */
    public static <T> Stream<T> findAll(Component root, Class<T> type) {
        return tree(root).filter(type::isInstance).map(type::cast);
    }

    /** Returns the component of a class with an accessible name. */
    public static <T extends Component> T find(Component root, Class<T> type, String name) {
        return findAll(root, type)
                .filter(component -> name.equals(accessibleName(component)))
                .findFirst()
                .orElseThrow(() -> new AssertionError("there is no " + type.getSimpleName() + " called " + name));
    }

    /** Returns the label of a value, whose accessible name is that of the value, a colon and the text. */
    public static JLabel findValue(Component root, String name) {
        return findAll(root, JLabel.class)
                .filter(label -> accessibleName(label).equals(name + ": " + label.getText()))
                .findFirst()
                .orElseThrow(() -> new AssertionError("there is no value called " + name));
    }

    /** Returns the accessible name of a component, empty if it has none. */
    public static String accessibleName(Component component) {
        String name = component.getAccessibleContext() == null
                ? null
                : component.getAccessibleContext().getAccessibleName();
        return name == null ? "" : name;
    }
}
