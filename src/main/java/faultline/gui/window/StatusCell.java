package faultline.gui.window;

import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import javax.swing.JLabel;

/** A place in the status bar that is as wide as the widest text it will hold, so that its neighbours stay where they are. */
final class StatusCell extends JLabel {

    private static final int HEIGHT = 20;

    StatusCell(String name, String widest) {
        Dimension size = new Dimension(getFontMetrics(getFont()).stringWidth(widest) + 2, TextSize.scaled(HEIGHT));
        setPreferredSize(size);
        setMinimumSize(size);
        setMaximumSize(size);
        setToolTipText(name);
        getAccessibleContext().setAccessibleName(name);
    }

    void show(String text) {
        if (!text.equals(getText())) {
            setText(text);
            getAccessibleContext().setAccessibleDescription(text);
        }
    }
}
