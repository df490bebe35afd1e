package faultline.gui.bar;

import faultline.gui.form.StatelessLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.util.ArrayList;
import java.util.List;

/**
 * Lays out components side by side at their preferred sizes, centred in their row, and continues in another row where
 * the width is too small. The preferred height is that for the present width.
 */
final class ToolBarLayout extends StatelessLayout {

    private static final int ROW_GAP = 4;

    private record ToolBarRow(List<Component> components, int width, int height) {}

    private static List<ToolBarRow> rows(Container bar) {
        Insets insets = bar.getInsets();
        int room = bar.getWidth() > 0 ? bar.getWidth() - insets.left - insets.right : Integer.MAX_VALUE;
        List<ToolBarRow> rows = new ArrayList<>();
        List<Component> open = new ArrayList<>();
        int width = 0;
        int height = 0;
        for (Component part : bar.getComponents()) {
            Dimension size = part.getPreferredSize();
            if (width + size.width > room && !open.isEmpty()) {
                rows.add(new ToolBarRow(List.copyOf(open), width, height));
                open.clear();
                width = 0;
                height = 0;
            }
            open.add(part);
            width += size.width;
            height = Math.max(height, size.height);
        }
        rows.add(new ToolBarRow(List.copyOf(open), width, height));
        return rows;
    }

    @Override
    public void layoutContainer(Container bar) {
        Insets insets = bar.getInsets();
        int y = insets.top;
        for (ToolBarRow row : rows(bar)) {
            int x = insets.left;
            for (Component part : row.components()) {
                Dimension size = part.getPreferredSize();
                part.setBounds(x, y + (row.height() - size.height) / 2, size.width, size.height);
                x += size.width;
            }
            y += row.height() + ROW_GAP;
        }
    }

    @Override
    public Dimension preferredLayoutSize(Container bar) {
        Insets insets = bar.getInsets();
        List<ToolBarRow> rows = rows(bar);
        int width = rows.stream().mapToInt(ToolBarRow::width).max().orElse(0);
        int height = rows.stream().mapToInt(row -> row.height() + ROW_GAP).sum() - ROW_GAP;
        return new Dimension(insets.left + width + insets.right, insets.top + height + insets.bottom);
    }
}
