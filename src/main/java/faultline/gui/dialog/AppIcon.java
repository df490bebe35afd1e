package faultline.gui.dialog;

import faultline.paint.surface.DrawContext;
import faultline.paint.surface.GraphicsSurface;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.geom.Arc2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;

/** The program's icon: a robot and one cone with a crack through it. */
public final class AppIcon {

    private AppIcon() {}

    public static List<Image> images() {
        return IntStream.of(16, 24, 32, 48, 64)
                .<Image>mapToObj(AppIcon::createImage)
                .toList();
    }

    /** Returns the icon in a given size, pixels. */
    public static BufferedImage createImage(int size) {
        BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = image.createGraphics();
        GraphicsSurface.enableAntialiasing(g);
        g.scale(size / 16.0, size / 16.0);
        paint(g);
        g.dispose();
        return image;
    }

    private static void paint(Graphics2D g) {
        g.setColor(new Color(0xE69F00));
        g.fill(new Arc2D.Double(-7.5, -0.5, 23, 23, 15, 60, Arc2D.PIE));
        g.setColor(new Color(0x0B4F79));
        g.setStroke(DrawContext.solidStroke(0.9));
        g.draw(crackShape());
        g.fill(new RoundRectangle2D.Double(0.5, 7, 8.5, 8.5, 3, 3));
        g.setColor(new Color(0x56B4E9));
        g.fill(new RoundRectangle2D.Double(1.8, 8.3, 5.9, 5.9, 1.6, 1.6));
    }

    private static Path2D crackShape() {
        Path2D crack = new Path2D.Double();
        crack.moveTo(6, 3.2);
        crack.lineTo(9, 4.6);
        crack.lineTo(8.4, 6.8);
        crack.lineTo(11.4, 7.4);
        crack.lineTo(12.6, 10);
        return crack;
    }
}
