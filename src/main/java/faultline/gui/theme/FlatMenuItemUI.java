package faultline.gui.theme;

import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicMenuItemUI;

/** A menu item or check box menu item with a gap between its name and its accelerator. */
public final class FlatMenuItemUI extends BasicMenuItemUI {

    /** The gap between the longest name of a menu and the accelerators, and before the names, pixels. */
    static final int KEYS_GAP = 16;

    private final String propertyPrefix;

    private FlatMenuItemUI(String propertyPrefix) {
        this.propertyPrefix = propertyPrefix;
    }

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatMenuItemUI(component instanceof JCheckBoxMenuItem ? "CheckBoxMenuItem" : "MenuItem");
    }

    @Override
    protected String getPropertyPrefix() {
        return propertyPrefix;
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        defaultTextIconGap = KEYS_GAP;
        FlatLook.showPlainText(menuItem);
    }
}
