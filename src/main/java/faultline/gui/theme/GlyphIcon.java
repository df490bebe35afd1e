package faultline.gui.theme;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.util.function.Function;
import javax.swing.Icon;
import javax.swing.plaf.UIResource;

/**
 * A glyph as an icon, sharp at any screen scale, in a colour of the theme, or in the foreground of its component if
 * that is null.
 */
public record GlyphIcon(Glyph glyph, int size, Function<ThemeColours, Color> colour) implements Icon, UIResource {

    @Override
    public int getIconWidth() {
        return size;
    }

    @Override
    public int getIconHeight() {
        return size;
    }

    @Override
    public void paintIcon(Component component, Graphics graphics, int x, int y) {
        ThemeColours colours = Theme.currentColours();
        Color foreground = component.isEnabled() ? component.getForeground() : colours.border();
        glyph.paint(graphics, x, y, size, colour == null ? foreground : colour.apply(colours));
    }
}
