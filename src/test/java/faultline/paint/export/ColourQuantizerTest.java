package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.paint.surface.Palette;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.IndexColorModel;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ColourQuantizerTest {

    /** Far from the colours of the palette and the cube. */
    private static final int COMMON = 0x2B802B;

    private static BufferedImage picture(int... colours) {
        BufferedImage picture = new BufferedImage(colours.length, 1, BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, colours.length, 1, colours, 0, colours.length);
        return picture;
    }

    private static int[] colours(BufferedImage picture) {
        return IntStream.range(0, picture.getWidth())
                .map(x -> picture.getRGB(x, 0) & 0xFFFFFF)
                .toArray();
    }

    /** A picture with more colours than can be kept; each but the last has one pixel. */
    private static BufferedImage manyColours() {
        IntStream single = new Random(1).ints(2000, 0, 1 << 24);
        return picture(IntStream.concat(single, IntStream.of(COMMON, COMMON)).toArray());
    }

    private static int distance(int a, int b) {
        Color one = new Color(a);
        Color other = new Color(b);
        int red = one.getRed() - other.getRed();
        int green = one.getGreen() - other.getGreen();
        int blue = one.getBlue() - other.getBlue();
        return red * red + green * green + blue * blue;
    }

    @Test
    void theColoursOfThePaletteAndTheMostFrequentOneStayAsTheyAre() {
        ColourQuantizer quantizer = ColourQuantizer.of(Palette.LIGHT, 8, manyColours());
        int[] kept = Palette.LIGHT.colours(10).stream()
                .mapToInt(colour -> colour.getRGB() & 0xFFFFFF)
                .toArray();
        int[] all = IntStream.concat(IntStream.of(kept), IntStream.of(COMMON)).toArray();
        int[] reduced = colours(quantizer.quantize(picture(all)));
        for (int i = 0; i < all.length; i++) {
            // Two colours with the same five bits in each channel are one.
            int visible = distance(all[i], reduced[i]);
            assertTrue(visible <= 3 * 7 * 7, () -> "a difference of " + visible);
        }
        assertEquals(COMMON, reduced[all.length - 1]);
    }

    /** Also of those that are off in the first picture. */
    @Test
    void theColoursOfManySensorsStayAsTheyAre() {
        int[] kept = Palette.LIGHT.colours(64).stream()
                .mapToInt(colour -> colour.getRGB() & 0xFFFFFF)
                .toArray();
        int[] reduced =
                colours(ColourQuantizer.of(Palette.LIGHT, 64, manyColours()).quantize(picture(kept)));
        for (int i = 0; i < kept.length; i++) {
            assertTrue(sameCell(kept[i], reduced[i]), Integer.toHexString(kept[i]));
        }
    }

    @Test
    void frequentColoursThatDifferByEightInOneChannelStayApart() {
        int[] pairs = {0x207050, 0x287050, 0x702050, 0x702850, 0x705020, 0x705028};
        BufferedImage picture = picture(pairs);
        assertArrayEquals(
                pairs, colours(ColourQuantizer.of(Palette.LIGHT, 8, picture).quantize(picture)));
    }

    @Test
    void allColoursAreUsedIfThePictureHasMore() {
        BufferedImage reduced =
                ColourQuantizer.of(Palette.LIGHT, 8, manyColours()).quantize(manyColours());
        assertEquals(256, ((IndexColorModel) reduced.getColorModel()).getMapSize());
    }

    @Test
    void aColourThatIsNotAmongThemBecomesTheNearest() {
        BufferedImage sample = picture(COMMON);
        IndexColorModel model = (IndexColorModel)
                ColourQuantizer.of(Palette.LIGHT, 8, sample).quantize(sample).getColorModel();
        List<Integer> chosen = IntStream.range(0, model.getMapSize())
                .mapToObj(index -> model.getRGB(index) & 0xFFFFFF)
                .toList();
        for (int colour : new Random(2).ints(300, 0, 1 << 24).toArray()) {
            int given = colours(ColourQuantizer.of(Palette.LIGHT, 8, sample).quantize(picture(colour)))[0];
            int least = chosen.stream()
                    .mapToInt(each -> distance(each, colour))
                    .min()
                    .orElseThrow();
            assertTrue(
                    distance(given, colour) == least || sameCell(given, colour),
                    () -> Integer.toHexString(colour) + " became " + Integer.toHexString(given));
            // The steps of the cube are 85 apart.
            assertTrue(least <= 3 * 43 * 43, () -> Integer.toHexString(colour) + " has no colour near it");
        }
    }

    /** Returns whether two colours have the same five bits in each channel. */
    private static boolean sameCell(int a, int b) {
        return (a & 0xF8F8F8) == (b & 0xF8F8F8);
    }
}
