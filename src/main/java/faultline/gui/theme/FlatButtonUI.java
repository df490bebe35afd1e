package faultline.gui.theme;

import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JToggleButton;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicButtonUI;
import javax.swing.plaf.basic.BasicGraphicsUtils;

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

    /** Paints the text of a disabled button pale; the embossed one of Swing is unreadable on dark buttons. */
    @Override
    protected void paintText(Graphics graphics, AbstractButton button, Rectangle area, String text) {
        if (button.getModel().isEnabled()) {
            super.paintText(graphics, button, area, text);
            return;
        }
        graphics.setColor(Theme.currentColours().border());
        int baseline = area.y + graphics.getFontMetrics().getAscent();
        BasicGraphicsUtils.drawStringUnderlineCharAt(
                button, (Graphics2D) graphics, text, button.getDisplayedMnemonicIndex(), area.x, baseline);
    }

    @Override
    public void paint(Graphics graphics, JComponent component) {
        ButtonPainter.paint(graphics, (AbstractButton) component);
        super.paint(graphics, component);
    }
}
