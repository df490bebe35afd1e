package faultline.paint;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.IndexColorModel;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * At most 256 colours that stand for all: those of a palette, the most frequent ones of a sample picture, and a coarse cube for what comes
 * up later. Colours are told apart by five bits a channel.
 */
final class FewColours {

    private static final int MOST = 256;
    private static final int CELLS = 1 << 15;
    private static final int[] CUBE = {0, 85, 170, 255};

    private final int[] colours;
    private final int[] nearest = new int[CELLS];
    private final IndexColorModel model;

    private FewColours(int[] colours) {
        this.colours = colours;
        this.model = new IndexColorModel(8, colours.length, colours, 0, false, -1, DataBuffer.TYPE_BYTE);
        Arrays.fill(nearest, -1);
        for (int index = colours.length - 1; index >= 0; index--) {
            nearest[cell(colours[index])] = index;
        }
    }

    /** The colours for pictures that look like a sample. */
    static FewColours of(Palette palette, BufferedImage sample) {
        Set<Integer> chosen = new LinkedHashSet<>();
        named(palette).forEach(colour -> chosen.add(colour.getRGB() & 0xFFFFFF));
        cube().forEach(chosen::add);
        frequent(sample).takeWhile(colour -> chosen.size() < MOST).forEach(chosen::add);
        return new FewColours(chosen.stream().mapToInt(Integer::intValue).toArray());
    }

    private static Stream<Color> named(Palette palette) {
        Stream<Color> scene = Stream.of(palette.canvas(), palette.grid(), palette.gridMajor(), palette.text(), palette.muted(), palette.accent(),
                palette.obstacle(), palette.obstacleOutline(), palette.moving(), palette.movingOutline(), palette.robot(), palette.robotOutline(),
                palette.path(), palette.hit());
        return Stream.concat(scene, palette.sensors().stream().flatMap(sensor -> Stream.of(sensor.fill(), sensor.outline())));
    }

    private static Stream<Integer> cube() {
        List<Integer> steps = Arrays.stream(CUBE).boxed().toList();
        return steps.stream().flatMap(red -> steps.stream().flatMap(green -> steps.stream().map(blue -> red << 16 | green << 8 | blue)));
    }

    /** The colours of a picture, one a cell, the most frequent first. */
    private static Stream<Integer> frequent(BufferedImage sample) {
        int[] counts = new int[CELLS];
        int[] seen = new int[CELLS];
        for (int rgb : sample.getRGB(0, 0, sample.getWidth(), sample.getHeight(), null, 0, sample.getWidth())) {
            counts[cell(rgb)]++;
            seen[cell(rgb)] = rgb & 0xFFFFFF;
        }
        return IntStream.range(0, CELLS).filter(cell -> counts[cell] > 0).boxed()
                .sorted(Comparator.comparingInt((Integer cell) -> -counts[cell])).map(cell -> seen[cell]);
    }

    /** A picture in these colours. */
    BufferedImage reduce(BufferedImage image) {
        BufferedImage few = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, model);
        byte[] pixels = ((DataBufferByte) few.getRaster().getDataBuffer()).getData();
        int[] all = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        for (int i = 0; i < all.length; i++) {
            pixels[i] = (byte) index(all[i]);
        }
        return few;
    }

    private int index(int rgb) {
        int cell = cell(rgb);
        if (nearest[cell] < 0) {
            nearest[cell] = search(rgb);
        }
        return nearest[cell];
    }

    private int search(int rgb) {
        return IntStream.range(0, colours.length).boxed().min(Comparator.comparingInt(index -> distance(colours[index], rgb))).orElseThrow();
    }

    private static int distance(int a, int b) {
        int red = (a >> 16 & 0xFF) - (b >> 16 & 0xFF);
        int green = (a >> 8 & 0xFF) - (b >> 8 & 0xFF);
        int blue = (a & 0xFF) - (b & 0xFF);
        return red * red + green * green + blue * blue;
    }

    private static int cell(int rgb) {
        return rgb >> 9 & 0x7C00 | rgb >> 6 & 0x3E0 | rgb >> 3 & 0x1F;
    }
}
