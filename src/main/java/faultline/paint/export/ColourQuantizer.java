package faultline.paint.export;

import faultline.paint.surface.Palette;
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
 * Reduces pictures to at most 256 colours: those of a palette, a coarse cube, and the most frequent ones of a sample
 * picture. Colours are compared with five bits per channel.
 */
final class ColourQuantizer {

    private static final int MAX_COLOURS = 256;
    /** The number of sensors whose colours are there for each robot, so that most films have the same colours. */
    private static final int USUAL_SENSORS = 10;

    private static final int CELL_COUNT = 1 << 15;
    private static final int[] CUBE_STEPS = {0, 85, 170, 255};

    private final int[] colours;
    private final int[] nearest = new int[CELL_COUNT];
    private final IndexColorModel model;

    private ColourQuantizer(int[] colours) {
        this.colours = colours;
        this.model = new IndexColorModel(8, colours.length, colours, 0, false, -1, DataBuffer.TYPE_BYTE);
        Arrays.fill(nearest, -1);
        for (int index = colours.length - 1; index >= 0; index--) {
            nearest[cellIndex(colours[index])] = index;
        }
    }

    /** Returns a quantizer for pictures that resemble a sample, of a robot with a number of sensors. */
    static ColourQuantizer of(Palette palette, int sensors, BufferedImage sample) {
        Set<Integer> chosen = new LinkedHashSet<>();
        palette.colours(Math.max(USUAL_SENSORS, sensors)).forEach(colour -> chosen.add(colour.getRGB() & 0xFFFFFF));
        cubeColours().forEach(chosen::add);
        frequentColours(sample).takeWhile(colour -> chosen.size() < MAX_COLOURS).forEach(chosen::add);
        return new ColourQuantizer(chosen.stream().mapToInt(Integer::intValue).toArray());
    }

    private static Stream<Integer> cubeColours() {
        List<Integer> steps = Arrays.stream(CUBE_STEPS).boxed().toList();
        return steps.stream().flatMap(red -> steps.stream()
                .flatMap(green -> steps.stream().map(blue -> red << 16 | green << 8 | blue)));
    }

    /** Returns the colours of a picture, one for each cell, the most frequent first. */
    private static Stream<Integer> frequentColours(BufferedImage sample) {
        int[] counts = new int[CELL_COUNT];
        int[] seen = new int[CELL_COUNT];
        for (int rgb : sample.getRGB(0, 0, sample.getWidth(), sample.getHeight(), null, 0, sample.getWidth())) {
            counts[cellIndex(rgb)]++;
            seen[cellIndex(rgb)] = rgb & 0xFFFFFF;
        }
        return IntStream.range(0, CELL_COUNT)
                .filter(cell -> counts[cell] > 0)
                .boxed()
                .sorted(Comparator.comparingInt((Integer cell) -> -counts[cell]))
                .map(cell -> seen[cell]);
    }

    /** Returns a picture in these colours. */
    BufferedImage quantize(BufferedImage image) {
        BufferedImage few =
                new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_BYTE_INDEXED, model);
        byte[] pixels = ((DataBufferByte) few.getRaster().getDataBuffer()).getData();
        int[] all = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
        for (int i = 0; i < all.length; i++) {
            pixels[i] = (byte) nearestIndex(all[i]);
        }
        return few;
    }

    private int nearestIndex(int rgb) {
        int cell = cellIndex(rgb);
        if (nearest[cell] < 0) {
            nearest[cell] = findNearest(rgb);
        }
        return nearest[cell];
    }

    private int findNearest(int rgb) {
        return IntStream.range(0, colours.length)
                .boxed()
                .min(Comparator.comparingInt(index -> squaredDistance(colours[index], rgb)))
                .orElseThrow();
    }

    private static int squaredDistance(int a, int b) {
        int red = (a >> 16 & 0xFF) - (b >> 16 & 0xFF);
        int green = (a >> 8 & 0xFF) - (b >> 8 & 0xFF);
        int blue = (a & 0xFF) - (b & 0xFF);
        return red * red + green * green + blue * blue;
    }

    private static int cellIndex(int rgb) {
        return rgb >> 9 & 0x7C00 | rgb >> 6 & 0x3E0 | rgb >> 3 & 0x1F;
    }
}
