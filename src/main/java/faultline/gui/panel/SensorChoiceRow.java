package faultline.gui.panel;

import faultline.gui.form.FormConstraints;
import faultline.gui.form.WrappingGridLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * The choice of a sensor, its id and some buttons in one line. If the tab is too narrow for the longest id, the id is
 * below the choice.
 */
final class SensorChoiceRow extends JPanel {

    private static final int GAP = 12;
    private static final int LINE_GAP = 4;

    /** Creates a row, given the label before it. */
    SensorChoiceRow(JComponent label, JComponent choice, JComponent id, JComponent buttons) {
        super(null);
        add(choice);
        add(id);
        add(buttons);
        setLayout(new ChoiceLayout(label, choice, id, buttons));
    }

    /** Places the parts of the row. The width that the tab leaves for it is known before the row is laid out. */
    private record ChoiceLayout(JComponent label, JComponent choice, JComponent id, JComponent buttons)
            implements LayoutManager {

        private int lineWidth() {
            return choiceLineWidth() + GAP + id.getMinimumSize().width;
        }

        private int choiceLineWidth() {
            return choice.getPreferredSize().width + FormConstraints.GAP + buttons.getPreferredSize().width;
        }

        /** Returns the least width of two lines, in which the choice may show only the beginning of a long id. */
        private int twoLinesWidth() {
            int hidden = Math.max(0, choice.getPreferredSize().width - id.getPreferredSize().width);
            return Math.max(choiceLineWidth() - hidden, id.getMinimumSize().width);
        }

        private boolean isOneLine(Container row) {
            int labelWidth = label.getPreferredSize().width + FormConstraints.GAP;
            return lineWidth() <= WrappingGridLayout.availableWidth(row) - labelWidth;
        }

        private int lineHeight() {
            return Math.max(
                    buttons.getPreferredSize().height,
                    Math.max(choice.getPreferredSize().height, id.getPreferredSize().height));
        }

        /** Returns the least width, because the row fills that of the panel. */
        @Override
        public Dimension preferredLayoutSize(Container row) {
            return isOneLine(row)
                    ? new Dimension(lineWidth(), lineHeight())
                    : new Dimension(twoLinesWidth(), 2 * lineHeight() + LINE_GAP);
        }

        @Override
        public Dimension minimumLayoutSize(Container row) {
            return preferredLayoutSize(row);
        }

        @Override
        public void layoutContainer(Container row) {
            int height = lineHeight();
            int right = row.getWidth() - buttons.getPreferredSize().width;
            buttons.setBounds(right, 0, row.getWidth() - right, height);
            right -= FormConstraints.GAP;
            if (isOneLine(row)) {
                int choiceWidth = Math.max(choice.getPreferredSize().width, (right - GAP) / 2);
                choice.setBounds(0, 0, choiceWidth, height);
                id.setBounds(choiceWidth + GAP, 0, right - choiceWidth - GAP, height);
            } else {
                choice.setBounds(0, 0, right, height);
                id.setBounds(0, height + LINE_GAP, row.getWidth(), height);
            }
        }

        @Override
        public void addLayoutComponent(String name, Component part) {
            // The parts are known.
        }

        @Override
        public void removeLayoutComponent(Component part) {
            // The parts stay.
        }
    }
}
