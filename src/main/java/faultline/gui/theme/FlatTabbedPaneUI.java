package faultline.gui.theme;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Insets;
import java.awt.Rectangle;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicTabbedPaneUI;

/** Flat tabs: the selected one is bold and underlined in the accent colour. */
public final class FlatTabbedPaneUI extends BasicTabbedPaneUI {

    private static final int UNDERLINE = 3;
    /** The distance of a title from the sides of its tab, pixels. */
    private static final int PADDING = 14;
    /** The least distance with which all tabs are put in one row. Only one title is bold, so that none touch. */
    private static final int MIN_PADDING = 1;
    /** What the superclass adds to the width of a title, pixels. */
    private static final int EXTRA_WIDTH = 3;

    private static final Insets NONE = new Insets(0, 0, 0, 0);

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatTabbedPaneUI();
    }

    @Override
    protected void installDefaults() {
        super.installDefaults();
        tabInsets = new Insets(5, PADDING, 6, PADDING);
        selectedTabPadInsets = NONE;
        tabAreaInsets = new Insets(0, 6, 0, 6);
        contentBorderInsets = new Insets(1, 0, 0, 0);
        tabPane.setOpaque(true);
        tabPane.setBackground(Theme.currentColours().background());
        tabPane.setForeground(Theme.currentColours().text());
    }

    @Override
    protected int calculateTabWidth(int placement, int index, FontMetrics metrics) {
        return super.calculateTabWidth(placement, index, boldMetrics(metrics.getFont()));
    }

    private FontMetrics boldMetrics(Font font) {
        return tabPane.getFontMetrics(font.deriveFont(Font.BOLD));
    }

    @Override
    protected Insets getTabInsets(int placement, int index) {
        int padding = padding();
        return new Insets(tabInsets.top, padding, tabInsets.bottom, padding);
    }

    /** Returns less than the usual padding if all tabs are in one row with it. */
    private int padding() {
        FontMetrics metrics = boldMetrics(tabPane.getFont());
        int tabs = tabPane.getTabCount();
        int titles = IntStream.range(0, tabs)
                .map(tab -> metrics.stringWidth(tabPane.getTitleAt(tab)) + EXTRA_WIDTH)
                .sum();
        Insets border = tabPane.getInsets();
        int width = tabPane.getWidth() - border.left - border.right - tabAreaInsets.left - tabAreaInsets.right;
        int room = (width - titles) / (2 * Math.max(1, tabs));
        return room < MIN_PADDING ? PADDING : Math.min(room, PADDING);
    }

    /** Keeps the titles on one line, whichever tab is selected. */
    @Override
    protected int getTabLabelShiftY(int placement, int index, boolean selected) {
        return super.getTabLabelShiftY(placement, index, false);
    }

    /** Leaves all rows of tabs where they are when a tab is selected. */
    @Override
    protected boolean shouldRotateTabRuns(int placement) {
        return false;
    }

    /** Selects the next tab also if it is in another row, so that Left and Right reach every tab. */
    @Override
    protected void selectNextTabInRun(int current) {
        selectNextTab(current);
    }

    @Override
    protected void selectPreviousTabInRun(int current) {
        selectPreviousTab(current);
    }

    @Override
    protected void paintTabBackground(
            Graphics graphics, int placement, int index, int x, int y, int width, int height, boolean selected) {
        if (getRolloverTab() == index && !selected) {
            graphics.setColor(Theme.currentColours().hover());
            graphics.fillRect(x, y, width, height);
        }
    }

    @Override
    protected void paintTabBorder(
            Graphics graphics, int placement, int index, int x, int y, int width, int height, boolean selected) {
        if (selected) {
            graphics.setColor(Theme.currentColours().accent());
            graphics.fillRect(x, y + height - UNDERLINE, width, UNDERLINE);
        }
    }

    @Override
    protected void paintText(
            Graphics graphics,
            int placement,
            Font font,
            FontMetrics metrics,
            int index,
            String title,
            Rectangle place,
            boolean selected) {
        Font shown = selected ? font.deriveFont(Font.BOLD) : font;
        FontMetrics measure = tabPane.getFontMetrics(shown);
        Rectangle middle = new Rectangle(
                place.x + (place.width - measure.stringWidth(title)) / 2, place.y, place.width, place.height);
        Antialiasing.paint(
                graphics, g -> super.paintText(g, placement, shown, measure, index, title, middle, selected));
    }

    @Override
    protected void paintFocusIndicator(
            Graphics graphics,
            int placement,
            Rectangle[] tabs,
            int index,
            Rectangle icon,
            Rectangle text,
            boolean selected) {
        if (selected && tabPane.hasFocus()) {
            Rectangle tab = tabs[index];
            Antialiasing.paint(graphics, g -> {
                g.setColor(Theme.currentColours().accent());
                g.draw(Antialiasing.roundedRectangle(tab.x + 2, tab.y + 2, tab.width - 4, tab.height - 4 - UNDERLINE));
            });
        }
    }

    @Override
    protected void paintContentBorder(Graphics graphics, int placement, int index) {
        int y = calculateTabAreaHeight(placement, runCount, maxTabHeight);
        graphics.setColor(Theme.currentColours().line());
        graphics.fillRect(0, y, tabPane.getWidth(), 1);
    }
}
