package faultline.gui.theme;

import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A custom-painted component that screen readers find; a plain {@link JComponent} is hidden from them. */
public abstract class AccessibleComponent extends JComponent implements Accessible {

    private final transient AccessibleRole role;

    /** Creates a component with a role. */
    protected AccessibleComponent(AccessibleRole role) {
        this.role = role;
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return role;
                }
            };
        }
        return accessibleContext;
    }
}
