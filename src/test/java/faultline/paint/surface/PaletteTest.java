package faultline.paint.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Contrasts by the definition of WCAG 2.1: 4.5 for text, 3 for lines that carry meaning. */
class PaletteTest {

    /** Machado, Oliveira and Fernandes, IEEE Transactions on Visualization and Computer Graphics 15, 2009. */
    private static final double[][] PROTANOPIA = {
        {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}
    };

    private static final double[][] DEUTERANOPIA = {
        {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}
    };

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void linesAndRingsStandOutFromTheCanvas(boolean dark) {
        Palette p = palette(dark);
        Map<String, Color> lines = new LinkedHashMap<>(Map.of(
                "obstacle",
                p.obstacleOutline(),
                "moving",
                p.movingOutline(),
                "robot",
                p.robotOutline(),
                "path",
                p.path(),
                "hit",
                p.contact(),
                "accent",
                p.accent(),
                "muted",
                p.muted()));
        lines.put("collision", p.collision());
        lines.put("reference", p.reference());
        lines.put("fill of obstacles", p.obstacle());
        lines.put("fill of the robot", p.robot());
        for (int i = 0; i < p.sensors().size(); i++) {
            lines.put("sensor " + (i + 1), p.sensorColours(i).outline());
        }
        lines.forEach((name, colour) -> assertContrast(name, 3, colour, p.canvas()));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void textCanBeReadOnTheCanvas(boolean dark) {
        Palette p = palette(dark);
        assertContrast("text", 4.5, p.text(), p.canvas());
        assertContrast("muted text", 4.5, p.muted(), p.canvas());
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void pathRobotCollisionsMarksAndReferenceHaveColoursThatNoSensorHas(boolean dark) {
        Palette p = palette(dark);
        List<Color> own = List.of(p.path(), p.robot(), p.collision(), p.contact(), p.reference());
        List<Color> sensors = new ArrayList<>();
        p.sensors().forEach(sensor -> sensors.addAll(List.of(sensor.fill(), sensor.outline())));
        own.forEach(colour -> sensors.forEach(sensor -> assertDifferent(colour, sensor)));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void pathCollisionsMarksAndReferenceDiffer(boolean dark) {
        Palette p = palette(dark);
        List<Color> own = List.of(p.path(), p.collision(), p.contact(), p.reference());
        for (int i = 0; i < own.size(); i++) {
            own.subList(0, i).forEach(assertDifferentFrom(own.get(i)));
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void edgesAreVisibleOnTheFillsThatTheySurround(boolean dark) {
        Palette p = palette(dark);
        assertContrast("outline of obstacles", 3, p.obstacleOutline(), p.obstacle());
        assertContrast("arrow of the robot", 3, p.robotOutline(), p.robot());
    }

    private static Consumer<Color> assertDifferentFrom(Color colour) {
        return other -> assertDifferent(colour, other);
    }

    private static void assertDifferent(Color colour, Color other) {
        assertTrue(distance(colour, other) > 60, colour + " and " + other);
    }

    private static double distance(Color a, Color b) {
        return Math.sqrt(Math.pow(a.getRed() - b.getRed(), 2)
                + Math.pow(a.getGreen() - b.getGreen(), 2)
                + Math.pow(a.getBlue() - b.getBlue(), 2));
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void sixtyFourSensorsHaveSixtyFourColours(boolean dark) {
        assertEquals(64, new HashSet<>(palette(dark).sensors()).size());
        assertEquals(palette(dark).sensorColours(1), palette(dark).sensorColours(65));
    }

    /** Two colours beside each other differ visibly from a distance of 0.02 on. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theColoursOfAnyTwoSensorsCanBeToldApart(boolean dark) {
        Palette p = palette(dark);
        for (int i = 0; i < p.sensors().size(); i++) {
            for (int j = 0; j < i; j++) {
                double distance = oklabDistance(
                        p.sensorColours(i).outline(), p.sensorColours(j).outline());
                assertTrue(distance > 0.045, (j + 1) + " and " + (i + 1) + ": " + distance);
            }
        }
    }

    /** A theme, or a drawing that has both, shows the same sensor in the same hue. */
    @Test
    void aFurtherSensorHasTheSameHueInBothThemes() {
        for (int i = 10; i < 64; i++) {
            double[] light = oklab(Palette.LIGHT.sensorColours(i).outline());
            double[] dark = oklab(Palette.DARK.sensorColours(i).outline());
            double turned = Math.abs(
                    Math.atan2(light[1] * dark[2] - light[2] * dark[1], light[1] * dark[1] + light[2] * dark[2]));
            assertTrue(turned < Math.toRadians(10), (i + 1) + ": " + Math.toDegrees(turned));
        }
    }

    private static double oklabDistance(Color a, Color b) {
        double[] one = oklab(a);
        double[] other = oklab(b);
        return Math.hypot(one[0] - other[0], Math.hypot(one[1] - other[1], one[2] - other[2]));
    }

    /** Returns lightness, a and b of a colour by Ottosson, A perceptual color space for image processing, 2020. */
    private static double[] oklab(Color colour) {
        double r = linear(colour.getRed());
        double g = linear(colour.getGreen());
        double b = linear(colour.getBlue());
        double l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
        double m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
        double s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
        return new double[] {
            0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s
        };
    }

    private static double linear(int component) {
        double share = component / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }

    @Test
    void oklabIsMeasuredAsDefined() {
        assertEquals(1, oklabDistance(Color.BLACK, Color.WHITE), 1e-4);
        assertEquals(0.628, oklab(Color.RED)[0], 1e-3);
        assertEquals(0.225, oklab(Color.RED)[1], 1e-3);
        assertEquals(0.126, oklab(Color.RED)[2], 1e-3);
    }

    /** The first eight are those of Okabe and Ito. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theNinthAndTheTenthSensorDifferFromTheOthersAlsoWithoutRedOrGreenCones(boolean dark) {
        Palette p = palette(dark);
        for (int i = 8; i < 10; i++) {
            Color added = p.sensorColours(i).outline();
            for (int j = 0; j < i; j++) {
                Color other = p.sensorColours(j).outline();
                assertDifferent(added, other);
                for (double[][] blindness : List.of(PROTANOPIA, DEUTERANOPIA)) {
                    double distance = distance(seen(added, blindness), seen(other, blindness));
                    assertTrue(distance > 50, added + " and " + other + ": " + distance);
                }
            }
        }
    }

    /** Returns a colour as it is seen without one kind of cone, by the matrix of linear components. */
    private static Color seen(Color colour, double[][] blindness) {
        double[] linear = IntStream.of(colour.getRed(), colour.getGreen(), colour.getBlue())
                .mapToDouble(component -> Math.pow(component / 255.0, 2.2))
                .toArray();
        int[] seen = Stream.of(blindness)
                .mapToDouble(row -> row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2])
                .mapToInt(component -> (int) Math.round(255 * Math.pow(Math.max(0, Math.min(1, component)), 1 / 2.2)))
                .toArray();
        return new Color(seen[0], seen[1], seen[2]);
    }

    @Test
    void theColoursOfAPictureAreThoseOfItsSceneAndOfItsSensors() {
        Palette p = Palette.LIGHT;
        List<Color> colours = p.colours(2);
        assertEquals(16 + 4, colours.size());
        assertTrue(colours.containsAll(List.of(p.canvas(), p.grid(), p.robot(), p.path(), p.reference())));
        assertEquals(
                List.of(
                        p.sensorColours(0).fill(),
                        p.sensorColours(0).outline(),
                        p.sensorColours(1).fill(),
                        p.sensorColours(1).outline()),
                colours.subList(16, 20));
        assertEquals(16 + 2 * 64, p.colours().size());
    }

    @Test
    void contrastIsMeasuredAsDefined() {
        assertEquals(21, Contrast.of(Color.BLACK, Color.WHITE), 1e-9);
        assertEquals(4.48, Contrast.of(new Color(0x777777), Color.WHITE), 0.01);
    }

    private static Palette palette(boolean dark) {
        return dark ? Palette.DARK : Palette.LIGHT;
    }

    private static void assertContrast(String name, double minimum, Color colour, Color ground) {
        double contrast = Contrast.of(colour, ground);
        assertTrue(contrast >= minimum, name + " has a contrast of only " + contrast);
    }
}
