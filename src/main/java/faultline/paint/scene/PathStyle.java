package faultline.paint.scene;

import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.Stroke;
import java.util.function.Function;

/** The style of a path. */
public enum PathStyle {
    /** The path of the run. */
    RUN(2, Palette::path),
    /** The path of a reference run: half as wide. */
    REFERENCE(1, Palette::reference);

    private final Stroke stroke;
    private final Function<Palette, Color> colour;

    PathStyle(double width, Function<Palette, Color> colour) {
        this.stroke = DrawContext.solidStroke(width);
        this.colour = colour;
    }

    Stroke stroke() {
        return stroke;
    }

    Color colour(Palette palette) {
        return colour.apply(palette);
    }
}
