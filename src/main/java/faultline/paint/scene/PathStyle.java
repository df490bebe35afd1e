package faultline.paint.scene;

import faultline.engine.PathTag;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.Stroke;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;

/** The style of a path. */
public enum PathStyle {
    /** The path of the run. */
    RUN(2, (palette, tag) -> palette.path()),
    /** The path of the run, coloured by the controller's state. */
    STATES(2, (palette, tag) -> stateColour(palette.dark(), PathTag.stateIndex(tag))),
    /** The path of the run, with the stretches on which a sensor or motor was faulty. */
    FAULTS(2, (palette, tag) -> PathTag.isFaulty(tag) ? palette.contact() : palette.muted()),
    /** The path of a reference run: half as wide. */
    REFERENCE(1, (palette, tag) -> palette.reference());

    /** The colours of the wall follower's states in their order, and of other states, on light and dark canvases. */
    private static final List<Color> LIGHT_STATES = List.of(
            rgb(0x5F6B7A), rgb(0xC2185B), rgb(0x8E24AA), rgb(0x8A5A00), rgb(0x1565C0), rgb(0x00796B), rgb(0x333333));

    private static final List<Color> DARK_STATES = List.of(
            rgb(0x98A2B3), rgb(0xFF80AB), rgb(0xCE93D8), rgb(0xE0B050), rgb(0x64A8FF), rgb(0x4DD0B5), rgb(0xDDDDDD));

    private final Stroke stroke;
    private final BiFunction<Palette, Integer, Color> colour;

    PathStyle(double width, BiFunction<Palette, Integer, Color> colour) {
        this.stroke = DrawContext.solidStroke(width);
        this.colour = colour;
    }

    private static Color rgb(int rgb) {
        return new Color(rgb);
    }

    /** Returns the style of the run's path by the layers that are shown. */
    public static PathStyle of(Set<Layer> layers) {
        if (layers.contains(Layer.PATH_STATES)) {
            return STATES;
        }
        return layers.contains(Layer.PATH_FAULTS) ? FAULTS : RUN;
    }

    /** Returns the colour of a state, given its index as in {@link PathTag}. */
    public static Color stateColour(boolean dark, int state) {
        return (dark ? DARK_STATES : LIGHT_STATES).get(state);
    }

    Stroke stroke() {
        return stroke;
    }

    /** Returns the colour of a line of a path with a {@link PathTag}. */
    Color colour(Palette palette, int tag) {
        return colour.apply(palette, tag);
    }
}
