package faultline.gui.window;

import java.awt.Component;
import java.awt.Container;
import javax.swing.LayoutFocusTraversalPolicy;

/**
 * Moves the focus by Tab as usual, but to a substitute when the component that has it is disabled or hidden. The next
 * component, to which it would move otherwise, can be a field far away, which would scroll into view and receive the
 * next keys.
 */
final class DisabledFocusPolicy extends LayoutFocusTraversalPolicy {

    private static final long serialVersionUID = 1L;

    private final Component substitute;

    DisabledFocusPolicy(Component substitute) {
        this.substitute = substitute;
    }

    @Override
    public Component getComponentAfter(Container root, Component component) {
        return component.isEnabled() && component.isVisible() ? super.getComponentAfter(root, component) : substitute;
    }
}
