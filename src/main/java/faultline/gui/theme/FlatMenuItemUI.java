package faultline.gui.theme;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicMenuItemUI;

/** A menu item with room between its name and its keys. */
public final class FlatMenuItemUI extends BasicMenuItemUI {

    /** Between the longest name of a menu and the column of its keys, and before the names, in pixels. */
    static final int KEYS_GAP = 16;

    /**
     * Made by Swing for a component.
     *
     * @param component a menu item
     * @return a delegate
     */
    public static ComponentUI createUI(JComponent component) {
        return new FlatMenuItemUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = KEYS_GAP;
    }
}
