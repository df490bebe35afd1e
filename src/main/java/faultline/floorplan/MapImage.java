package faultline.floorplan;

/** The brightness of the pixels of a map, row 0 at the top, as in image files. */
final class MapImage {

    /**
     * The maximum number of pixels, more than any map of a building has. It prevents a damaged or hostile header from
     * allocating all memory.
     */
    static final long MAX_PIXELS = 64_000_000;

    private final int width;
    private final int height;
    private final float[] values;
    private final boolean[] transparent;

    MapImage(int width, int height) {
        this.width = width;
        this.height = height;
        values = new float[width * height];
        transparent = new boolean[width * height];
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Sets a pixel: its brightness in [0, 255] and whether it is not fully opaque. */
    void set(int index, float value, boolean isTransparent) {
        values[index] = value;
        transparent[index] = isTransparent;
    }

    /** Returns the brightness of a pixel, 0 for black to 255 for white. */
    double value(int column, int rowFromTop) {
        return values[rowFromTop * width + column];
    }

    /** Returns whether a pixel is not fully opaque. */
    boolean isTransparent(int column, int rowFromTop) {
        return transparent[rowFromTop * width + column];
    }
}
