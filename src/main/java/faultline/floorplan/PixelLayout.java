package faultline.floorplan;

/**
 * Which samples of a pixel are its colours and its opacity.
 *
 * @param colors the number of its first samples that are grey, or red, green and blue
 * @param opacity the index of the sample of the opacity; negative if there is none
 */
record PixelLayout(int colors, int opacity) {

    boolean hasOpacity() {
        return opacity >= 0;
    }
}
