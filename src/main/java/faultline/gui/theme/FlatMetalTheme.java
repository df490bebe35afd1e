package faultline.gui.theme;

import java.awt.Color;
import javax.swing.plaf.ColorUIResource;
import javax.swing.plaf.metal.DefaultMetalTheme;

/** The colours of the flat look, as Metal requests them. */
final class FlatMetalTheme extends DefaultMetalTheme {

    private final ThemeColours colours;

    FlatMetalTheme(ThemeColours colours) {
        this.colours = colours;
    }

    private static ColorUIResource resource(Color colour) {
        return new ColorUIResource(colour);
    }

    @Override
    public String getName() {
        return "Faultline";
    }

    @Override
    protected ColorUIResource getPrimary1() {
        return resource(colours.accent());
    }

    @Override
    protected ColorUIResource getPrimary2() {
        return resource(colours.accent());
    }

    @Override
    protected ColorUIResource getPrimary3() {
        return resource(colours.accent());
    }

    @Override
    protected ColorUIResource getSecondary1() {
        return resource(colours.border());
    }

    @Override
    protected ColorUIResource getSecondary2() {
        return resource(colours.line());
    }

    @Override
    protected ColorUIResource getSecondary3() {
        return resource(colours.background());
    }

    @Override
    protected ColorUIResource getBlack() {
        return resource(colours.text());
    }

    @Override
    protected ColorUIResource getWhite() {
        return resource(colours.field());
    }

    @Override
    public ColorUIResource getHighlightedTextColor() {
        return resource(colours.onAccent());
    }

    @Override
    public ColorUIResource getInactiveControlTextColor() {
        return resource(colours.muted());
    }

    @Override
    public ColorUIResource getMenuDisabledForeground() {
        return resource(colours.muted());
    }
}
