package faultline.paint.surface;

import java.awt.Color;
import java.util.ArrayList;
import java.util.List;

/**
 * The colours of the sensors after the tenth, up to the 64th. Of colours of 36 hues, five chromas and ten lightnesses,
 * each is the one that is farthest from all before it, in both themes: by the distance in Oklab (Ottosson, A perceptual
 * color space for image processing, 2020), or by six times the distance that remains without red or green cones if that
 * is less. A sensor has the same hue in both themes. Colours whose contrast to the canvas is less than 3:1 or that
 * resemble the robot, its path or a mark were left out.
 */
final class FurtherSensorColours {

    /** For light windows, with a lightness in Oklab from 0.32 to 0.68. */
    static final FurtherSensorColours LIGHT = new FurtherSensorColours(
            0x710048, 0x500090, 0x1E7100, 0x8A5B53, 0x003F9E, 0x412354, 0x46736A, 0x104B00, 0x7700AB, 0x4D591E,
            0x473A30, 0x4DA339, 0x950060, 0x002C75, 0x60326B, 0x00474A, 0x627128, 0x005884, 0x54578E, 0x00A0A6,
            0xF700EF, 0x3F882E, 0x76967B, 0x5F7790, 0xB7522C, 0x273347, 0x615E4B, 0x907D67, 0x6C464C, 0x225E54,
            0x568B8D, 0x3D4D39, 0x00829E, 0x00642B, 0x006A77, 0x4E835A, 0x680065, 0x432A36, 0xFF5900, 0x403100,
            0x9D8B58, 0x463553, 0x007C60, 0x3FA083, 0x6B304F, 0x7B6540, 0x5E486E, 0xBC46FF, 0x005FA7, 0x003F18,
            0x7E0064, 0x860044, 0x668F33, 0x42693A);

    /** For dark windows, with a lightness in Oklab from 0.53 to 0.93. */
    static final FurtherSensorColours DARK = new FurtherSensorColours(
            0xD5008C, 0x972CFF, 0x3BC000, 0xCAA59E, 0x307EFF, 0x864FAB, 0x77BFB0, 0x2A9100, 0xC058FF, 0x899E3C,
            0x8B7361, 0x89F970, 0xFF14AA, 0x0060E6, 0xB060C2, 0x008A8F, 0xA3BB48, 0x009DE6, 0x9B9EBE, 0x28F6FF,
            0xFFDBFB, 0x6ADB50, 0xBCE6C3, 0xAEBFD1, 0xF3A88D, 0x566C92, 0xA7A282, 0xDBC7B1, 0xB98289, 0x43A795,
            0x8BDBDF, 0x738F6D, 0x00D1FD, 0x00B151, 0x00B5CB, 0x81D393, 0xC500BF, 0x895C71, 0xFFE0D6, 0x846800,
            0xEED89B, 0x896A9F, 0x00CCA0, 0x66F7CB, 0xC35E92, 0xCBA96F, 0xA187B5, 0xE9CCFF, 0x46A5FF, 0x00823A,
            0xE300B7, 0xF00080, 0xA3E156, 0x75B467);

    private final int[] colours;

    private FurtherSensorColours(int... colours) {
        this.colours = colours;
    }

    /** Returns the colours of the first sensors followed by these. */
    List<SensorColours> after(SensorColours... first) {
        List<SensorColours> all = new ArrayList<>(List.of(first));
        for (int colour : colours) {
            all.add(new SensorColours(new Color(colour), new Color(colour)));
        }
        return all;
    }
}
