package faultline.gui.panel;

import faultline.gui.theme.Theme;
import java.awt.Dimension;
import javax.swing.JLabel;

/** A label of less weight: a unit, or the heading of a column. */
final class MutedLabel extends JLabel {

    MutedLabel(String text) {
        super(text);
    }

    /** A little wider than the text, which on a fine screen is up to two pixels wider than on a coarse one. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(size.width + 2, size.height);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setForeground(Theme.currentColours().muted());
    }
}
