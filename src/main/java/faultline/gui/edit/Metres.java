package faultline.gui.edit;

import faultline.geometry.Vec;
import java.util.List;

/** Numbers that a hand makes, without the digits that no hand means: files stay readable. */
final class Metres {

    private static final double PARTS = 1e9;

    private Metres() {
    }

    static double round(double value) {
        return Math.rint(value * PARTS) / PARTS;
    }

    static Vec round(Vec value) {
        return new Vec(round(value.x()), round(value.y()));
    }

    static List<Vec> round(List<Vec> values) {
        return values.stream().map(Metres::round).toList();
    }
}
