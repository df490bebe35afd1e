package faultline.paint.surface;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;

/** The colour that is seen where a translucent colour is painted over another one. */
public final class Blend {

    private Blend() {}

    /** Returns the opaque colour. */
    public static Color of(Color top, Color ground) {
        BufferedImage pixel = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = pixel.createGraphics();
        for (Color colour : List.of(ground, top)) {
            graphics.setColor(colour);
            graphics.fillRect(0, 0, 1, 1);
        }
        graphics.dispose();
        return new Color(pixel.getRGB(0, 0));
    }
}
