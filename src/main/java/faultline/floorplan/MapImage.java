package faultline.floorplan;

import java.awt.image.DataBuffer;
import java.awt.image.DataBufferInt;
import java.awt.image.DataBufferUShort;
import java.util.BitSet;

/** The brightness of the pixels of a map, row 0 at the top, as in image files. */
final class MapImage {

    /**
     * The maximum number of pixels, more than any map of a building has. It prevents a damaged or hostile header from
     * allocating all memory.
     */
    static final long MAX_PIXELS = 64_000_000;

    private static final int MAX_SHORT = 0xffff;

    private final int width;
    private final int height;
    private final int max;
    /** The samples, of 16 bits if possible, since a large map has tens of millions of them. */
    private final DataBuffer samples;

    private final BitSet transparent = new BitSet();

    /** Creates an image of black pixels, given the sample of white, at least 1. */
    MapImage(int width, int height, int max) {
        this.width = width;
        this.height = height;
        this.max = max;
        samples = max > MAX_SHORT ? new DataBufferInt(width * height) : new DataBufferUShort(width * height);
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Sets a pixel: its sample, 0 for black to that of white, and whether it is not fully opaque. */
    void set(int index, int sample, boolean isTransparent) {
        samples.setElem(index, sample);
        if (isTransparent) {
            transparent.set(index);
        }
    }

    /**
     * Returns this image as a part of a larger one, whose other pixels are transparent.
     *
     * @param newWidth the width of the larger image
     * @param newHeight the height of the larger image
     * @param left the column of the first pixel of this image
     * @param top the row of the first pixel of this image
     */
    MapImage on(int newWidth, int newHeight, int left, int top) {
        if (newWidth == width && newHeight == height) {
            return this;
        }
        MapImage larger = new MapImage(newWidth, newHeight, max);
        larger.transparent.set(0, newWidth * newHeight);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int index = (top + row) * newWidth + left + column;
                larger.samples.setElem(index, sample(column, row));
                larger.transparent.set(index, isTransparent(column, row));
            }
        }
        return larger;
    }

    /** Returns the sample of a pixel, from 0 for black to that of white. */
    int sample(int column, int rowFromTop) {
        return samples.getElem(rowFromTop * width + column);
    }

    /** Returns the sample of white. */
    int white() {
        return max;
    }

    /** Returns whether a pixel is not fully opaque. */
    boolean isTransparent(int column, int rowFromTop) {
        return transparent.get(rowFromTop * width + column);
    }
}
