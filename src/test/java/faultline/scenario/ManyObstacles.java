package faultline.scenario;

import java.util.Locale;
import java.util.SplittableRandom;

/** A scenario file near the limits of the format: rotated boxes, circles, ellipses and triangles on a grid. */
public final class ManyObstacles {

    /** The number of obstacles. */
    public static final int COUNT = 99_000;

    private static final int COLUMNS = 330;

    private ManyObstacles() {}

    /** Returns the content of the file. */
    public static String text() {
        SplittableRandom random = new SplittableRandom(11);
        StringBuilder text = new StringBuilder("<scenario xmlns=\"urn:faultline:scenario:1\" name=\"Many\">\n"
                + "<world width=\"330\" height=\"300\">\n");
        for (int i = 0; i < COUNT; i++) {
            text.append(String.format(
                    Locale.ROOT,
                    "<%s id=\"o%d\" x=\"%.3f\" y=\"%.3f\" heading=\"%.1f\" %s/>\n",
                    name(i),
                    i,
                    1 + i % COLUMNS * 0.99,
                    3 + i / COLUMNS * 0.98,
                    random.nextInt(3600) / 10.0,
                    size(i)));
        }
        return text.append("</world>\n<robot x=\"1.5\" y=\"1.5\"/>\n</scenario>\n")
                .toString();
    }

    /** Triangles are few, because their points count as obstacles do. */
    private static String name(int i) {
        return i % COLUMNS == 7 ? "polygon" : new String[] {"rectangle", "circle", "ellipse"}[i % 3];
    }

    private static String size(int i) {
        return switch (name(i)) {
            case "polygon" -> "points=\"-0.2,-0.1 0.2,-0.1 0,0.2\"";
            case "rectangle" -> "width=\"0.4\" height=\"0.2\"";
            case "circle" -> "radius=\"0.15\"";
            default -> "rx=\"0.2\" ry=\"0.1\"";
        };
    }
}
