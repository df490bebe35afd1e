package faultline.gui.form;

import faultline.gui.theme.RefreshSteps;
import java.awt.Dimension;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.JLabel;
import javax.swing.SwingConstants;

/** A label for a value that changes. It is as wide as its widest text from the start, so nothing moves with it. */
public final class ValueLabel extends JLabel {

    private static final int MARGIN = 2;
    /** Shown where there is no value. */
    public static final String NONE = "–";

    private transient List<String> widest = List.of();

    /** Creates a label without a value; the suppliers return its accessible name and the texts that must fit. */
    public ValueLabel(Supplier<String> name, Supplier<List<String>> widest) {
        super(NONE, SwingConstants.LEADING);
        RefreshSteps.add(this, label -> {
            label.widest = widest.get();
            label.getAccessibleContext().setAccessibleName(name.get());
            label.revalidate();
        });
    }

    /** Shows a value; nothing is laid out or painted if it is the old one. */
    public void setValue(String text) {
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
