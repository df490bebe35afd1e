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
    void tenSensorsHaveTenColours(boolean dark) {
        assertEquals(10, new HashSet<>(palette(dark).sensors()).size());
        assertEquals(palette(dark).sensorColours(1), palette(dark).sensorColours(11));
    }

    /** The first eight are those of Okabe and Ito. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void furtherSensorsDifferFromAllOthersAlsoWithoutRedOrGreenCones(boolean dark) {
        Palette p = palette(dark);
        for (int i = 8; i < p.sensors().size(); i++) {
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
