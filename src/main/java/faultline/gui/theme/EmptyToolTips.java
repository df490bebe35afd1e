package faultline.gui.theme;

import java.awt.Component;
import java.awt.Container;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.ToolTipManager;

/**
 * Keeps lists and tables from showing empty tool tips. Swing registers every list and table for tips. While the mouse
 * rests on one that has none, an invisible tip is open for some seconds and consumes Escape.
 */
public final class EmptyToolTips {

    private EmptyToolTips() {}

    /** Unregisters all lists and tables of a container; they must not have tips. */
    public static void disable(Container container) {
        Stream.of(container.getComponents()).forEach(EmptyToolTips::disable);
    }

    private static void disable(Component part) {
        if (part instanceof JList || part instanceof JTable) {
            ToolTipManager.sharedInstance().unregisterComponent((JComponent) part);
        }
        if (part instanceof Container container) {
            disable(container);
        }
    }
}
