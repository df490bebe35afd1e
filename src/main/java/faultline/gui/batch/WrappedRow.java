package faultline.gui.batch;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Insets;
import javax.swing.JPanel;
import javax.swing.JRootPane;

/** A row of buttons, aligned at its end, which wraps to several rows in a narrow window. */
final class WrappedRow extends JPanel {

    private static final int GAP = 8;
    private static final int ROW_GAP = 4;

    /** Creates an empty row. */
    WrappedRow() {
        super(new FlowLayout(FlowLayout.TRAILING, GAP, ROW_GAP));
    }

    /** Returns the size in the width of the window, which is known before that of this row. */
    @Override
    public Dimension getPreferredSize() {
        Dimension single = super.getPreferredSize();
        JRootPane root = getRootPane();
        if (root == null || root.getWidth() == 0) {
            return single;
        }
        Insets margins = root.getContentPane().getInsets();
        int width = root.getWidth() - margins.left - margins.right;
        int height = single.height - 2 * ROW_GAP;
        return new Dimension(Math.min(single.width, width), ROW_GAP + rowsIn(width) * (height + ROW_GAP));
    }

    private int rowsIn(int width) {
        int rows = 1;
        int end = GAP;
        for (Component part : getComponents()) {
            int needed = part.getPreferredSize().width + GAP;
            if (end > GAP && end + needed > width) {
                rows++;
                end = GAP;
            }
            end += needed;
        }
        return rows;
    }
}
