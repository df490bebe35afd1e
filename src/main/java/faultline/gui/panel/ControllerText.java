package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.GainRule;
import faultline.gui.text.Messages;
import faultline.io.DecimalText;

/** Describes controllers. */
public final class ControllerText {

    private ControllerText() {}

    /** Returns the kind of a controller with its settings. */
    public static String format(ControllerSpec.BuiltIn spec) {
        if (spec instanceof ControllerSpec.WallFollowing follower) {
            return Messages.get(
                    "controller.follower.text",
                    DecimalText.format(follower.distance()),
                    Messages.get("controller.hand." + follower.side().fileName()),
                    gains(follower.gainRule()),
                    Messages.get("spin.rule." + follower.timingRule().fileName()));
        }
        if (spec instanceof ControllerSpec.Drive drive) {
            return Messages.get(
                    "controller.drive.text",
                    DecimalText.format(drive.leftVolts()),
                    DecimalText.format(drive.rightVolts()));
        }
        return Messages.get("controller.none");
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
