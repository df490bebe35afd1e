package faultline.gui.window;

import faultline.gui.panel.NumberQuestion;
import faultline.gui.text.Texts;
import java.awt.Component;
import java.util.OptionalDouble;

/** Asks how fast an obstacle is to move along its way-points. */
final class WaySpeed {

    /** As fast as people run, metres per second. */
    private static final double MOST = 5;
    private static final double STEP = 0.05;

    private WaySpeed() {
    }

    /** The speed, metres per second, given the present one; empty where the user thinks better of it. */
    static OptionalDouble ask(Component parent, double now) {
        return new NumberQuestion(Texts.text("waySpeed.title"), Texts.text("waySpeed"), "m/s", 0, Math.max(MOST, now), STEP).ask(parent, now);
    }
}
