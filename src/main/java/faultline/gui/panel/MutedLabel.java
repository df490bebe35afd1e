package faultline.gui.panel;

import faultline.gui.theme.Theme;
import javax.swing.JLabel;

/** A label of less weight: a unit, or the heading of a column. */
final class MutedLabel extends JLabel {

    MutedLabel(String text) {
        super(text);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setForeground(Theme.now().muted());
    }
}
