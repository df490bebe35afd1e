package faultline.gui.theme;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicMenuUI;

/** A menu; as a submenu, its name is aligned with the items around it. */
public final class FlatMenuUI extends BasicMenuUI {

    /** Called by Swing to create a delegate. */
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

    /** Returns the gap of a submenu, or the usual one for a menu of the menu bar. */
    private static int textIconGap(JComponent component, int usual) {
        return ((JMenu) component).isTopLevelMenu() ? usual : FlatMenuItemUI.KEYS_GAP;
    }
}
