package faultline.paint.surface;

import java.awt.Color;

/**
 * The colours of a sensor.
 *
 * @param fill the fill of its cone, painted translucent, and of swatches
 * @param outline the same hue with a contrast to the canvas of at least 3:1
 */
public record SensorColours(Color fill, Color outline) {

    static SensorColours of(int fill, int outline) {
        return new SensorColours(new Color(fill), new Color(outline));
    }
}
