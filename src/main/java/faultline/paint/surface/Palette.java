package faultline.paint.surface;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/**
 * The colours of a scene. Lines, rings, obstacles and the robot have a contrast to the canvas of at least 3:1 and text
 * of at least 4.5:1, by the definition of the WCAG; the fill of a moving obstacle and of a cone may be paler, because
 * an outline carries it. The robot and its path share a hue that no sensor has. No meaning depends on colour alone.
 *
 * @param dark whether the canvas is dark
 * @param canvas the background
 * @param grid minor grid lines
 * @param gridMajor major grid lines
 * @param text labels
 * @param muted inactive or less important parts
 * @param accent the selection
 * @param obstacle fill of static obstacles
 * @param obstacleOutline outline of static obstacles, and walls
 * @param moving fill of moving obstacles
 * @param movingOutline outline and waypoints of moving obstacles
 * @param robot the robot's body
 * @param robotOutline the robot's outline, wheels and arrow
 * @param path the robot's path
 * @param contact the colour of marks of faults and edges, on a path or in a chart
 * @param collision contacts and the first collision, and what cannot be done
 * @param reference a reference run
 * @param sensors the colours of the first 64 sensors in the robot's order, the first eight after Okabe and Ito; reused
 *     for further sensors
 */
public record Palette(
        boolean dark,
        Color canvas,
        Color grid,
        Color gridMajor,
        Color text,
        Color muted,
        Color accent,
        Color obstacle,
        Color obstacleOutline,
        Color moving,
        Color movingOutline,
        Color robot,
        Color robotOutline,
        Color path,
        Color contact,
        Color collision,
        Color reference,
        List<SensorColours> sensors) {

    /** For light windows and for paper. */
    public static final Palette LIGHT = new Palette(
            false,
            new Color(0xFBFCFD),
            new Color(0xEEF1F4),
            new Color(0xDDE2E8),
            new Color(0x1F2430),
            new Color(0x5F6B7A),
            new Color(0x0B6BCB),
            new Color(0x8893A1),
            new Color(0x364050),
            new Color(0xE69F00),
            new Color(0x8A5F00),
            new Color(0x877DF7),
            new Color(0x2A2380),
            new Color(0x4338CA),
            new Color(0x7C2D12),
            new Color(0xC8102E),
            new Color(0x9B2F8F),
            FurtherSensorColours.LIGHT.after(
                    SensorColours.of(0xE69F00, 0xAF7900),
                    SensorColours.of(0x56B4E9, 0x438CB6),
                    SensorColours.of(0x009E73, 0x00956C),
                    SensorColours.of(0xF0E442, 0x8B8426),
                    SensorColours.of(0x0072B2, 0x0072B2),
                    SensorColours.of(0xD55E00, 0xD55E00),
                    SensorColours.of(0xCC79A7, 0xB86D96),
                    SensorColours.of(0x4A5261, 0x4A5261),
                    SensorColours.of(0x203010, 0x203010),
                    SensorColours.of(0xD020F0, 0xD020F0)));

    /** For dark windows. */
    public static final Palette DARK = new Palette(
            true,
            new Color(0x15181C),
            new Color(0x20242A),
            new Color(0x2C323A),
            new Color(0xE4E7EB),
            new Color(0x98A2B3),
            new Color(0x4C9BE8),
            new Color(0x5F6877),
            new Color(0xC8D0DB),
            new Color(0xC98B2B),
            new Color(0xF2C36B),
            new Color(0x6670E0),
            new Color(0xE0E4FF),
            new Color(0x93A0FF),
            new Color(0xFF9A52),
            new Color(0xFF5468),
            new Color(0xE39BDB),
            FurtherSensorColours.DARK.after(
                    SensorColours.of(0xE69F00, 0xE69F00),
                    SensorColours.of(0x56B4E9, 0x56B4E9),
                    SensorColours.of(0x009E73, 0x009E73),
                    SensorColours.of(0xF0E442, 0xF0E442),
                    SensorColours.of(0x0072B2, 0x0A78B5),
                    SensorColours.of(0xD55E00, 0xD55E00),
                    SensorColours.of(0xCC79A7, 0xCC79A7),
                    SensorColours.of(0xD3D9E2, 0xD3D9E2),
                    SensorColours.of(0xC0D090, 0xC0D090),
                    SensorColours.of(0xE000F0, 0xE000F0)));

    public Palette {
        sensors = List.copyOf(sensors);
    }

    /** Returns the colours of a sensor; its index in the robot's order from 0. */
    public SensorColours sensorColours(int index) {
        return sensors.get(index % sensors.size());
    }

    /** Returns all colours: those of the scene, then those of the sensors. */
    public List<Color> colours() {
        return colours(sensors.size());
    }

    /** Returns the colours of the scene, then those of the first sensors. */
    public List<Color> colours(int sensorCount) {
        Stream<Color> scene = Stream.of(
                canvas,
                grid,
                gridMajor,
                text,
                muted,
                accent,
                obstacle,
                obstacleOutline,
                moving,
                movingOutline,
                robot,
                robotOutline,
                path,
                contact,
                collision,
                reference);
        return Stream.concat(
                        scene,
                        sensors.stream()
                                .limit(sensorCount)
                                .flatMap(sensor -> Stream.of(sensor.fill(), sensor.outline())))
                .toList();
    }

    /** Returns a translucent colour; alpha from 0, invisible, to 255, opaque. */
    public static Color withAlpha(Color colour, int alpha) {
        return new Color(colour.getRed(), colour.getGreen(), colour.getBlue(), alpha);
    }

    /** Returns a colour as {@code #rrggbb}, without its alpha. */
    public static String toHex(Color colour) {
        return String.format(Locale.ROOT, "#%06x", colour.getRGB() & 0xFFFFFF);
    }
}
