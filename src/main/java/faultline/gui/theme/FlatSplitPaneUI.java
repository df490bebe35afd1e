package faultline.gui.theme;

import java.awt.Graphics;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import javax.swing.plaf.basic.BasicSplitPaneUI;

/** A flat split pane: the divider is a line. */
public final class FlatSplitPaneUI extends BasicSplitPaneUI {

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatSplitPaneUI();
    }

    @Override
    public BasicSplitPaneDivider createDefaultDivider() {
        return new BasicSplitPaneDivider(this) {
            @Override
            public void paint(Graphics graphics) {
                graphics.setColor(Theme.currentColours().background());
                graphics.fillRect(0, 0, getWidth(), getHeight());
                graphics.setColor(Theme.currentColours().line());
                if (getWidth() < getHeight()) {
                    graphics.fillRect(getWidth() / 2, 0, 1, getHeight());
                } else {
                    graphics.fillRect(0, getHeight() / 2, getWidth(), 1);
                }
            }
        };
    }
}
