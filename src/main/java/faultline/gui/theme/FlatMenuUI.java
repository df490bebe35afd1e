package faultline.gui.theme;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicMenuUI;

/** A menu whose name, inside another menu, stands in line with the items around it. */
public final class FlatMenuUI extends BasicMenuUI {

    /**
     * Made by Swing for a component.
     *
     * @param component a menu
     * @return a delegate
     */
    public static ComponentUI createUI(JComponent component) {
        return new FlatMenuUI();
    }

    @Override
    protected Dimension getPreferredMenuItemSize(JComponent component, Icon check, Icon arrow, int gap) {
        return super.getPreferredMenuItemSize(component, check, arrow, textIconGap(component, gap));
    }

    @Override
    protected void paintMenuItem(
            Graphics graphics,
            JComponent component,
            Icon check,
            Icon arrow,
            Color background,
            Color foreground,
            int gap) {
        super.paintMenuItem(graphics, component, check, arrow, background, foreground, textIconGap(component, gap));
    }

    /** On the menu bar there are no keys to stand clear of. */
    private static int textIconGap(JComponent component, int usual) {
        return ((JMenu) component).isTopLevelMenu() ? usual : FlatMenuItemUI.KEYS_GAP;
    }
}
