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
        return spec.matchBuiltIn(new ControllerSpec.BuiltInCases<>(
                none -> Messages.get("controller.none"),
                drive -> Messages.get(
                        "controller.drive.text",
                        DecimalText.format(drive.leftVolts()),
                        DecimalText.format(drive.rightVolts())),
                ControllerText::formatFollower));
    }

    private static String formatFollower(WallFollowing spec) {
        return Messages.get(
                        "controller.follower.text",
                        DecimalText.format(spec.distance()),
                        Messages.get("controller.wallSide." + spec.side().fileName()),
                        format(spec.gainRule()),
                        Messages.get("spin.rule." + spec.timingRule().fileName()))
                + unusual(spec);
    }

    private static String format(GainRule rule) {
        return rule.match(new GainRule.GainCases<>(
                automatic -> Messages.get("controller.gains.automatic.text"),
                length -> Messages.get("controller.gains.length.text", DecimalText.format(length.metres())),
                fixed -> Messages.get(
                        "controller.gains.fixed.text",
                        DecimalText.format(fixed.proportional()),
                        DecimalText.format(fixed.derivative()))));
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
}
