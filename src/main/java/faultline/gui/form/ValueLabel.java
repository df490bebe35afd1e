package faultline.gui.form;

import faultline.gui.theme.RefreshSteps;
import java.awt.Dimension;
import java.util.List;
import java.util.function.Supplier;
import javax.swing.JLabel;
import javax.swing.SwingConstants;

/**
 * A label for a value that changes. It is as wide as its widest text from the start, so nothing moves with it. Its
 * accessible name has the value, too, because screen readers get no other text of a label.
 */
public final class ValueLabel extends JLabel {

    private static final int MARGIN = 2;
    /** Shown where there is no value. */
    public static final String NONE = "–";

    private final transient Supplier<String> name;
    private transient List<String> widest = List.of();

    /** Creates a label without a value; the suppliers return the name of the value and the texts that must fit. */
    public ValueLabel(Supplier<String> name, Supplier<List<String>> widest) {
        super(NONE, SwingConstants.LEADING);
        this.name = name;
        RefreshSteps.add(this, label -> {
            label.widest = widest.get();
            label.updateAccessibleName();
            label.revalidate();
        });
    }

    /** Shows a value; nothing is laid out or painted if it is the old one. */
    public void setValue(String text) {
        if (!text.equals(getText())) {
            setText(text);
            updateAccessibleName();
        }
    }

    private void updateAccessibleName() {
        getAccessibleContext().setAccessibleName(name.get() + ": " + getText());
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
