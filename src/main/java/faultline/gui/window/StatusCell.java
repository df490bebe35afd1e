package faultline.gui.window;

import faultline.gui.theme.TextSize;
import java.awt.Dimension;
import java.util.stream.Stream;
import javax.swing.JLabel;

/** A cell of the status bar that is as wide as the widest of its possible texts, so that its neighbours do not move. */
final class StatusCell extends JLabel {

    private static final int HEIGHT = 20;

    StatusCell(String name, String... texts) {
        int widest = Stream.of(texts)
                .mapToInt(getFontMetrics(getFont())::stringWidth)
                .max()
                .orElse(0);
        Dimension size = new Dimension(widest + 2, TextSize.scaled(HEIGHT));
        setPreferredSize(size);
        setMinimumSize(size);
        setMaximumSize(size);
        setToolTipText(name);
        getAccessibleContext().setAccessibleName(name);
    }

    void setStatusText(String text) {
        if (!text.equals(getText())) {
            setText(text);
            getAccessibleContext().setAccessibleDescription(text);
        }
    }
}
