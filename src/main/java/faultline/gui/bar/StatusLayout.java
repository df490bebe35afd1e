package faultline.gui.bar;

import faultline.gui.form.StatelessLayout;
import faultline.gui.theme.TextSize;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Lays out components side by side at their preferred widths. If the width is too small, optional components are
 * hidden, the last one first, so that those before them never move. Components that are not optional get the remaining
 * width.
 */
final class StatusLayout extends StatelessLayout {

    private final int unscaledGap;
    private final Predicate<Component> optional;

    /**
     * Creates a layout with a gap in pixels at the normal text size and a predicate that selects the components that
     * may be hidden.
     */
    StatusLayout(int gap, Predicate<Component> optional) {
        this.unscaledGap = gap;
        this.optional = optional;
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = parent.getInsets();
        int right = parent.getWidth() - insets.right;
        int height = parent.getHeight() - insets.top - insets.bottom;
        int needed = components(parent)
                .filter(optional.negate())
                .mapToInt(component -> component.getPreferredSize().width)
                .sum();
        int x = insets.left;
        boolean room = true;
        for (Component component : parent.getComponents()) {
            int width = component.getPreferredSize().width;
            boolean stays = optional.negate().test(component);
            room &= stays || x == insets.left || x + width + gap() + needed <= right;
            component.setVisible(stays || room);
            if (component.isVisible()) {
                component.setBounds(x, insets.top, Math.min(width, Math.max(0, right - x)), height);
                x += width + gap();
            }
        }
    }

    private int gap() {
        return TextSize.scaled(unscaledGap);
    }

    private static Stream<Component> components(Container parent) {
        return List.of(parent.getComponents()).stream();
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Insets insets = parent.getInsets();
        int width = components(parent)
                .mapToInt(component -> component.getPreferredSize().width + gap())
                .sum();
        int height = components(parent)
                .mapToInt(component -> component.getPreferredSize().height)
                .max()
                .orElse(0);
        return new Dimension(insets.left + width + insets.right, insets.top + height + insets.bottom);
    }
}
