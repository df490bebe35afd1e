package faultline.gui.panel;

import faultline.gui.theme.SeparatorBorder;
import java.awt.BorderLayout;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A section of the control panel. */
public final class TitledSection extends JPanel {

    /** Creates a section with a heading. */
    public TitledSection(String title, JComponent content) {
        this(content);
        JLabel heading = new JLabel(title);
        heading.setFont(heading.getFont().deriveFont(Font.BOLD));
        heading.setBorder(BorderFactory.createEmptyBorder(0, 0, 5, 0));
        add(heading, BorderLayout.NORTH);
    }

    /** Creates the first section of a tab, whose name says enough. */
    public TitledSection(JComponent content) {
        super(new BorderLayout());
        setBorder(SeparatorBorder.below(9, 14, 8));
        add(content, BorderLayout.CENTER);
    }
}
