package faultline.gui.bar;

import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.UiText;
import java.awt.Dimension;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JLabel;

/**
 * A cell of the status bar that is as wide as the widest of its usual texts, so that its neighbours do not move. It
 * grows for a longer text.
 */
final class StatusCell extends JLabel {

    private static final int HEIGHT = 20;

    /** Creates a cell with the name of a key; {@code texts} returns what it usually shows. */
    StatusCell(String key, Supplier<Stream<String>> texts) {
        UiText.nameAndTip(this, key);
        RefreshSteps.add(this, cell -> cell.fit(texts.get()));
    }

    private void fit(Stream<String> texts) {
        setTextWidth(Stream.concat(texts, Stream.of(getText()))
                .mapToInt(this::textWidth)
                .max()
                .orElse(0));
    }

    private int textWidth(String text) {
        return getFontMetrics(getFont()).stringWidth(text) + 2;
    }

    private void setTextWidth(int width) {
        Dimension size = new Dimension(width, TextSize.scaled(HEIGHT));
        setPreferredSize(size);
        setMinimumSize(size);
        setMaximumSize(size);
    }

    void setStatusText(String text) {
        if (!text.equals(getText())) {
            setText(text);
            getAccessibleContext().setAccessibleDescription(text);
            if (textWidth(text) > getPreferredSize().width) {
                setTextWidth(textWidth(text));
                revalidate();
            }
        }
    }
}
