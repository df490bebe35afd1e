package faultline.gui.window;

import faultline.gui.theme.Smooth;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.geom.Arc2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;

/** The picture of the program in task bars: a robot and one cone. */
final class AppIcon {

    private AppIcon() {
    }

    static List<Image> images() {
        return IntStream.of(16, 24, 32, 48, 64).mapToObj(AppIcon::image).toList();
    }

    private static Image image(int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Smooth.paint(image.createGraphics(), g -> {
            g.scale(size / 16.0, size / 16.0);
            paint(g);
        });
        return image;
    }

    private static void paint(Graphics2D g) {
        g.setColor(new Color(0xE69F00));
        g.fill(new Arc2D.Double(-3.5, -7, 19, 19, 15, 60, Arc2D.PIE));
        g.setColor(new Color(0x0B4F79));
        g.fill(new RoundRectangle2D.Double(1, 6, 10, 9, 3, 3));
        g.setColor(new Color(0x56B4E9));
        g.fill(new RoundRectangle2D.Double(2.2, 7.2, 7.6, 6.6, 2, 2));
    }
}
