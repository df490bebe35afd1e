package faultline.gui.theme;

import java.awt.Graphics;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicSplitPaneDivider;
import javax.swing.plaf.basic.BasicSplitPaneUI;

/** A flat split pane: the divider is a line, a thick one in the accent colour while keys move it. */
public final class FlatSplitPaneUI extends BasicSplitPaneUI {

    private static final int FOCUSED_THICKNESS = 3;

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
                boolean focused = splitPane.isFocusOwner();
                int thickness = focused ? FOCUSED_THICKNESS : 1;
                graphics.setColor(
                        focused
                                ? Theme.currentColours().accent()
                                : Theme.currentColours().line());
                if (getWidth() < getHeight()) {
                    graphics.fillRect((getWidth() - thickness) / 2, 0, thickness, getHeight());
                } else {
                    graphics.fillRect(0, (getHeight() - thickness) / 2, getWidth(), thickness);
                }
            }
        };
    }
}
