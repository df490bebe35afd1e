package faultline.gui.form;

import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.SeparatorBorder;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A section of a form or a panel, with a line below it. */
public final class TitledSection extends JPanel {

    /** Creates a section with the heading of a key. */
    public TitledSection(String key, JComponent content) {
        this(content);
        JLabel heading = UiText.label(key);
        RefreshSteps.add(heading, RefreshSteps::embolden);
        heading.setBorder(BorderFactory.createEmptyBorder(0, 0, 5, 0));
        add(heading, BorderLayout.NORTH);
    }

    /** Creates a section without a heading, such as the first of a tab, whose name says enough. */
    public TitledSection(JComponent content) {
        super(new BorderLayout());
        setBorder(SeparatorBorder.below(9, 14, 8));
        add(content, BorderLayout.CENTER);
    }
}
