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
        return spec.acceptBuiltIn(new KindText());
    }

    /** The kind of a controller with its settings. */
    private static final class KindText implements ControllerSpec.BuiltInVisitor<String> {
        @Override
        public String visit(ControllerSpec.None spec) {
            return Messages.get("controller.none");
        }

        @Override
        public String visit(ControllerSpec.Drive spec) {
            return Messages.get(
                    "controller.drive.text",
                    DecimalText.format(spec.leftVolts()),
                    DecimalText.format(spec.rightVolts()));
        }

        @Override
        public String visit(WallFollowing spec) {
            return Messages.get(
                            "controller.follower.text",
                            DecimalText.format(spec.distance()),
                            Messages.get("controller.wallSide." + spec.side().fileName()),
                            spec.gainRule().accept(new GainText()),
                            Messages.get("spin.rule." + spec.timingRule().fileName()))
                    + unusual(spec);
        }
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

    /** The rule for the gains with its values. */
    private static final class GainText implements GainRule.GainRuleVisitor<String> {
        @Override
        public String visit(GainRule.Automatic rule) {
            return Messages.get("controller.gains.automatic.text");
        }

        @Override
        public String visit(GainRule.Length rule) {
            return Messages.get("controller.gains.length.text", DecimalText.format(rule.metres()));
        }

        @Override
        public String visit(GainRule.Fixed rule) {
            return Messages.get(
                    "controller.gains.fixed.text",
                    DecimalText.format(rule.proportional()),
                    DecimalText.format(rule.derivative()));
        }
    }
}
