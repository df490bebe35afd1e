package faultline.gui.form;

import faultline.gui.text.Messages;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import javax.swing.JLabel;

/** A label of less emphasis: a unit or a column heading. */
public final class MutedLabel extends JLabel {

    public MutedLabel(String text) {
        super(text);
    }

    /** Creates a label with the text of a key, which follows the language. */
    public static MutedLabel ofKey(String key) {
        return RefreshSteps.add(new MutedLabel(""), label -> label.setText(Messages.get(key)));
    }

    /** Adds two pixels, because the text may be that much wider on a high-resolution screen. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(size.width + 2, size.height);
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setForeground(Theme.currentColours().muted());
    }
}
