package faultline.gui.theme;

import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicCheckBoxMenuItemUI;

/** A check box menu item with a gap between its name and its accelerator. */
public final class FlatCheckBoxMenuItemUI extends BasicCheckBoxMenuItemUI {

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatCheckBoxMenuItemUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = FlatMenuItemUI.KEYS_GAP;
    }
}
