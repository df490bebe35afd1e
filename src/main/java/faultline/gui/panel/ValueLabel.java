package faultline.gui.panel;

import java.awt.Dimension;
import javax.swing.JLabel;
import javax.swing.SwingConstants;

/** A label for a value that changes. It is as wide as its widest text from the start, so nothing moves with it. */
final class ValueLabel extends JLabel {

    private static final int MARGIN = 2;

    private final String[] widest;

    /**
     * Creates a label without a value.
     *
     * @param name the accessible name
     * @param widest the texts that must fit
     */
    ValueLabel(String name, String... widest) {
        super("–", SwingConstants.LEADING);
        this.widest = widest;
        getAccessibleContext().setAccessibleName(name);
    }

    /** Shows a value; nothing is laid out or painted if it is the old one. */
    void setValue(String text) {
        if (!text.equals(getText())) {
            setText(text);
        }
    }

    @Override
    public Dimension getPreferredSize() {
        int width = 0;
        for (String text : widest) {
            width = Math.max(width, getFontMetrics(getFont()).stringWidth(text));
        }
        return new Dimension(width + MARGIN, super.getPreferredSize().height);
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
