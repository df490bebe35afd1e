package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.GainRule;
import faultline.control.Threshold;
import faultline.gui.text.Messages;
import faultline.io.DecimalText;

/** Describes controllers. */
public final class ControllerText {

    private ControllerText() {}

    /** Returns the kind of a controller with its settings. */
    public static String format(ControllerSpec.BuiltIn spec) {
        if (spec instanceof WallFollowing follower) {
            return Messages.get(
                            "controller.follower.text",
                            DecimalText.format(follower.distance()),
                            Messages.get("controller.hand." + follower.side().fileName()),
                            gains(follower.gainRule()),
                            Messages.get("spin.rule." + follower.timingRule().fileName()))
                    + unusual(follower);
        }
        if (spec instanceof ControllerSpec.Drive drive) {
            return Messages.get(
                    "controller.drive.text",
                    DecimalText.format(drive.leftVolts()),
                    DecimalText.format(drive.rightVolts()));
        }
        return Messages.get("controller.none");
    }

    /** Describes the settings that differ from the defaults and are not described otherwise. */
    private static String unusual(WallFollowing follower) {
        StringBuilder text = new StringBuilder();
        if (follower.period() > 0) {
            text.append(", ").append(Messages.get("controller.period.text", DecimalText.format(follower.period())));
        }
        if (!follower.diagnosis()) {
            text.append(", ").append(Messages.get("controller.diagnosis.off.text"));
        }
        for (Threshold threshold : Threshold.values()) {
            double value = follower.thresholds().get(threshold);
            if (value != threshold.defaultValue()) {
                text.append("; ").append(Messages.get("controller." + threshold.fileName()));
                text.append(": ").append(DecimalText.format(value));
            }
        }
        return text.toString();
    }

    private static String gains(GainRule rule) {
        if (rule instanceof GainRule.Length length) {
            return Messages.get("controller.gains.length.text", DecimalText.format(length.metres()));
        }
        if (rule instanceof GainRule.Fixed fixed) {
            return Messages.get(
                    "controller.gains.fixed.text",
                    DecimalText.format(fixed.proportional()),
                    DecimalText.format(fixed.derivative()));
        }
        return Messages.get("controller.gains.automatic.text");
    }
}
