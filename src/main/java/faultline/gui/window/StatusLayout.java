package faultline.gui.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Parts side by side, each as wide as it wants to be. Some may be left out: the last of them that do not fit, so that
 * those before them never move. The rest of the width goes to the parts that must stay.
 */
final class StatusLayout implements LayoutManager {

    private final int gap;
    private final Predicate<Component> optional;

    /** Parts so many pixels apart, and which of them may be left out. */
    StatusLayout(int gap, Predicate<Component> optional) {
        this.gap = gap;
        this.optional = optional;
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = parent.getInsets();
        int right = parent.getWidth() - insets.right;
        int height = parent.getHeight() - insets.top - insets.bottom;
        int needed = components(parent)
                .filter(optional.negate())
                .mapToInt(part -> part.getPreferredSize().width)
                .sum();
        int x = insets.left;
        boolean room = true;
        for (Component part : parent.getComponents()) {
            int width = part.getPreferredSize().width;
            boolean stays = optional.negate().test(part);
            room &= stays || x == insets.left || x + width + gap + needed <= right;
            part.setVisible(stays || room);
            if (part.isVisible()) {
                part.setBounds(x, insets.top, Math.min(width, Math.max(0, right - x)), height);
                x += width + gap;
            }
        }
    }

    private static Stream<Component> components(Container parent) {
        return List.of(parent.getComponents()).stream();
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        Insets insets = parent.getInsets();
        int width = components(parent)
                .mapToInt(part -> part.getPreferredSize().width + gap)
                .sum();
        int height = components(parent)
                .mapToInt(part -> part.getPreferredSize().height)
                .max()
                .orElse(0);
        return new Dimension(insets.left + width + insets.right, insets.top + height + insets.bottom);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void addLayoutComponent(String name, Component part) {
        // Places have no names.
    }

    @Override
    public void removeLayoutComponent(Component part) {
        // Nothing is kept of parts.
    }
}
