package faultline.gui.theme;

import java.awt.Graphics;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicButtonUI;

/** A flat button or toggle button. */
public final class FlatButtonUI extends BasicButtonUI {

    private final String propertyPrefix;

    private FlatButtonUI(String propertyPrefix) {
        this.propertyPrefix = propertyPrefix;
    }

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatButtonUI(component instanceof JToggleButton ? "ToggleButton." : "Button.");
    }

    @Override
    protected String getPropertyPrefix() {
        return propertyPrefix;
    }

    @Override
    protected void installDefaults(AbstractButton button) {
        super.installDefaults(button);
        button.setOpaque(false);
        button.setRolloverEnabled(true);
        if (ButtonPainter.isPrimary(button)) {
            button.setForeground(Theme.currentColours().onAccent());
        }
    }

    @Override
    public void paint(Graphics graphics, JComponent component) {
        ButtonPainter.paint(graphics, (AbstractButton) component);
        super.paint(graphics, component);
    }
}
