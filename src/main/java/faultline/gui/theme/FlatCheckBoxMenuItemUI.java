package faultline.gui.theme;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicCheckBoxMenuItemUI;

/** A menu item with a tick, and with room between its name and its keys. */
public final class FlatCheckBoxMenuItemUI extends BasicCheckBoxMenuItemUI {

    /**
     * Made by Swing for a component.
     *
     * @param component a menu item with a tick
     * @return a delegate
     */
    public static ComponentUI createUI(JComponent component) {
        return new FlatCheckBoxMenuItemUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = FlatMenuItemUI.KEYS_GAP;
    }
}
