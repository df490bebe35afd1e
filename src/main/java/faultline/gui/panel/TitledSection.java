package faultline.gui.panel;

import faultline.gui.theme.SeparatorBorder;
import java.awt.BorderLayout;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A section of the control panel with a heading. */
final class TitledSection extends JPanel {

    TitledSection(String title, JComponent content) {
        super(new BorderLayout());
        JLabel heading = new JLabel(title);
        heading.setFont(heading.getFont().deriveFont(Font.BOLD));
        heading.setBorder(BorderFactory.createEmptyBorder(0, 0, 5, 0));
        setBorder(SeparatorBorder.below(9, 14, 8));
        add(heading, BorderLayout.NORTH);
        add(content, BorderLayout.CENTER);
    }
}
