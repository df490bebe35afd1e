package faultline.gui.theme;

import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicToggleButtonUI;

/** A flat toggle button. */
public final class FlatToggleButtonUI extends BasicToggleButtonUI {

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatToggleButtonUI();
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

    @Override
    protected void paintButtonPressed(Graphics graphics, AbstractButton button) {
        // The background shows the pressed state.
    }

    @Override
    protected void paintFocus(
            Graphics graphics, AbstractButton button, Rectangle view, Rectangle text, Rectangle icon) {
        // The background shows the focus.
    }
}
