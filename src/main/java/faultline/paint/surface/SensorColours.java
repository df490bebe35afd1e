package faultline.paint.surface;

import java.awt.Color;

/**
 * The colours of one sensor's cone.
 *
 * @param fill of the cone, painted translucent, and of swatches
 * @param outline the same hue, made dark or light enough to stand out from the canvas at 3:1 at least
 */
public record SensorColours(Color fill, Color outline) {

    static SensorColours of(int fill, int outline) {
        return new SensorColours(new Color(fill), new Color(outline));
    }
}
