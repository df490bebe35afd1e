package faultline.gui.dialog;

import faultline.gui.panel.NumberDialog;
import faultline.gui.text.Messages;
import java.awt.Component;
import java.util.OptionalDouble;

/** Asks for the speed of an obstacle along its waypoints. */
public final class SpeedDialog {

    /** About as fast as people run, metres per second. */
    private static final double MAX_SPEED = 5;

    private static final double SPEED_STEP = 0.05;

    private SpeedDialog() {}

    /** Asks for a speed in metres per second, given the current one; empty if cancelled. */
    public static OptionalDouble showDialog(Component parent, double now) {
        return new NumberDialog(
                        Messages.get("waySpeed.title"), "waySpeed", "m/s", 0, Math.max(MAX_SPEED, now), SPEED_STEP)
                .showDialog(parent, now);
    }
}
