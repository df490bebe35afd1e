package faultline.gui.panel;

import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.theme.Theme;
import faultline.paint.surface.Blend;
import faultline.paint.surface.Contrast;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import java.awt.Color;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Texts on the colours of sensors can be read. */
class SensorColoursTest {

    private static final double LEAST = 4.5;

    @ParameterizedTest
    @EnumSource(Theme.class)
    void theNumberOfASensorHasContrast(Theme theme) {
        colours(theme).forEach(colours -> assertContrast(SensorBadge.numberColour(colours.fill()), colours.fill()));
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void aReadingHasContrast(Theme theme) {
        colours(theme)
                .map(colours -> Palette.withAlpha(colours.outline(), ReadingBar.BAR_ALPHA))
                .forEach(bar -> assertContrast(
                        theme.colours().text(), Blend.of(bar, theme.colours().hover())));
    }

    /** Returns the colours of more sensors than a robot usually has. */
    private static Stream<SensorColours> colours(Theme theme) {
        return IntStream.range(0, 16).mapToObj(theme.palette()::sensorColours);
    }

    private static void assertContrast(Color text, Color ground) {
        double contrast = Contrast.of(text, ground);
        assertTrue(contrast >= LEAST, text + " on " + ground + ": " + contrast);
    }
}
