package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicComboBoxUI;

/** A flat combo box: value and arrow share one outline. */
public final class FlatComboBoxUI extends BasicComboBoxUI {

    private static final int INDENT = 4;

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatComboBoxUI();
    }

    @Override
    protected JButton createArrowButton() {
        return ArrowButton.down();
    }

    /** Makes the arrow not focusable; it would be a second tab stop without a name. */
    @Override
    public void configureArrowButton() {
        super.configureArrowButton();
        arrowButton.setFocusable(false);
    }

    @Override
    public void paintCurrentValueBackground(Graphics graphics, Rectangle value, boolean focused) {
        graphics.setColor(Theme.currentColours().field());
        graphics.fillRect(value.x, value.y, value.width, value.height);
    }

    @Override
    public void paintCurrentValue(Graphics graphics, Rectangle value, boolean focused) {
        super.paintCurrentValue(
                graphics, new Rectangle(value.x + INDENT, value.y, value.width - INDENT, value.height), false);
    }

    @Override
    protected Dimension getDisplaySize() {
        Dimension size = super.getDisplaySize();
        return new Dimension(size.width + 2 * INDENT, size.height + 6);
    }
}
