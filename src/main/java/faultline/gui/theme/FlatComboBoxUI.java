package faultline.gui.theme;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Rectangle;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.border.EmptyBorder;
import javax.swing.border.LineBorder;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicComboBoxUI;
import javax.swing.plaf.basic.BasicComboPopup;
import javax.swing.plaf.basic.ComboPopup;

/** A flat combo box: value and arrow share one outline. */
public final class FlatComboBoxUI extends BasicComboBoxUI {

    private static final int INDENT = 4;

    /** The distance of the rows of the list from its border, pixels; their texts are below that of the box. */
    private static final int LIST_MARGIN = 4;

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatComboBoxUI();
    }

    @Override
    protected JButton createArrowButton() {
        return ArrowButton.down();
    }

    @Override
    protected ComboPopup createPopup() {
        return new FlatPopup(comboBox);
    }

    /** Makes the arrow not focusable; it would be a second tab stop without a name. */
    @Override
    public void configureArrowButton() {
        super.configureArrowButton();
        arrowButton.setFocusable(false);
    }

    @Override
    public void paintCurrentValueBackground(Graphics graphics, Rectangle value, boolean focused) {
        graphics.setColor(Theme.currentColours().field());
        graphics.fillRect(value.x, value.y, value.width, value.height);
    }

    @Override
    public void paintCurrentValue(Graphics graphics, Rectangle value, boolean focused) {
        super.paintCurrentValue(
                graphics, new Rectangle(value.x + INDENT, value.y, value.width - INDENT, value.height), false);
    }

    @Override
    protected Dimension getDisplaySize() {
        Dimension size = super.getDisplaySize();
        return new Dimension(size.width + 2 * INDENT, size.height + 6);
    }

    /** A list with the border of menus, instead of Swing's black line, and as wide as its texts. */
    static final class FlatPopup extends BasicComboPopup {

        FlatPopup(JComboBox<Object> box) {
            super(box);
        }

        @Override
        protected void configurePopup() {
            super.configurePopup();
            setBorder(new LineBorder(Theme.currentColours().border()));
        }

        @Override
        protected void configureScroller() {
            super.configureScroller();
            scroller.setBorder(new EmptyBorder(LIST_MARGIN, LIST_MARGIN, LIST_MARGIN, LIST_MARGIN));
            scroller.setBackground(list.getBackground());
        }

        @Override
        protected Rectangle computePopupBounds(int x, int y, int width, int height) {
            return super.computePopupBounds(x, y, widthFor(width, height), height);
        }

        /** Returns the width of the list, given its height and the width of the box, pixels. */
        int widthFor(int boxWidth, int height) {
            Dimension texts = list.getPreferredSize();
            int bar = texts.height + 2 * LIST_MARGIN > height
                    ? scroller.getVerticalScrollBar().getPreferredSize().width
                    : 0;
            return Math.max(boxWidth, texts.width + bar + 2 * LIST_MARGIN);
        }
    }
}
