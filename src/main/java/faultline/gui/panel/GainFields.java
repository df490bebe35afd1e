package faultline.gui.panel;

import faultline.control.ControllerSpec;
import faultline.control.GainRule;
import faultline.control.PdGains;
import faultline.control.PeriodicController;
import faultline.gui.form.NamedChoice;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.Messages;
import faultline.robot.RobotSpec;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * The gains of the distance controller: how they are chosen, and their values. A length that is entered chooses gains
 * by length, and a gain that is entered fixes both gains.
 */
final class GainFields extends JPanel {

    /** The rule for the gains. */
    private enum GainChoice {
        AUTOMATIC,
        LENGTH,
        FIXED;

        static GainChoice of(GainRule rule) {
            return rule.match(new GainRule.GainCases<>(automatic -> AUTOMATIC, length -> LENGTH, fixed -> FIXED));
        }
    }

    private static final double MAX_GAIN = 10_000;
    private static final double MIN_GAIN = 0.001;
    /** The limits of the length, metres. */
    private static final double MIN_LENGTH = 0.001;

    private static final double MAX_LENGTH = 10_000;
    /** The inverse of the precision of a length that gains have, which is more than the field shows. */
    private static final double LENGTH_ROUNDING = 1e9;

    private final transient Consumer<GainRule> onChange;
    private final NamedChoice<GainChoice> choice = new NamedChoice<>(
            GainChoice.values(), value -> Messages.get("controller.gains." + value.name()), this::select);
    private final NumberSpinner length =
            new NumberSpinner("0.00####", MIN_LENGTH, MAX_LENGTH, 0.01, value -> send(new GainRule.Length(value)));
    private final NumberSpinner proportional = new NumberSpinner(
            "0.0###", MIN_GAIN, MAX_GAIN, 1, value -> send(new GainRule.Fixed(value, derivativeValue())));
    private final NumberSpinner derivative = new NumberSpinner(
            "0.0###", MIN_GAIN, MAX_GAIN, 1, value -> send(new GainRule.Fixed(proportionalValue(), value)));
    private transient GainRule shown = GainRule.AUTOMATIC;

    GainFields(Consumer<GainRule> onChange) {
        super(new WrappingGridLayout());
        this.onChange = onChange;
        ControllerForm.addRow(this, 0, "controller.gains.choice", choice);
        ControllerForm.addRow(this, 1, "controller.gains.length", length.withColumns(8));
        ControllerForm.addRow(this, 2, "controller.gains.kp", proportional.withColumns(8));
        ControllerForm.addRow(this, 3, "controller.gains.kd", derivative.withColumns(8));
    }

    private double proportionalValue() {
        return proportional.doubleValue();
    }

    private double derivativeValue() {
        return derivative.doubleValue();
    }

    /** Keeps the gains, or their length, when another choice is made. */
    private void select(GainChoice selected) {
        send(
                switch (selected) {
                    case AUTOMATIC -> GainRule.AUTOMATIC;
                    case LENGTH -> new GainRule.Length(length.doubleValue());
                    case FIXED -> new GainRule.Fixed(proportionalValue(), derivativeValue());
                });
    }

    private void send(GainRule rule) {
        if (!rule.equals(shown)) {
            onChange.accept(rule);
        }
    }

    /** Shows the gains of a follower; dt is the length of a tick, seconds. */
    void setGains(ControllerSpec.WallFollowing follower, RobotSpec robot, double dt) {
        shown = follower.gainRule();
        double lag = robot.motor().timeConstant() + dt * PeriodicController.ticksPerPeriod(follower.period(), dt);
        PdGains gains = shown.gains(robot.speed(), lag);
        choice.setValue(GainChoice.of(shown));
        proportional.setWorldValue(gains.proportional());
        derivative.setWorldValue(gains.derivative());
        length.setWorldValue(shown instanceof GainRule.Length exact ? exact.metres() : lengthOf(gains));
    }

    /** Returns the length of gains, without the rounding error of the division. */
    private static double lengthOf(PdGains gains) {
        return Math.max(MIN_LENGTH, Math.round(2 / gains.derivative() * LENGTH_ROUNDING) / LENGTH_ROUNDING);
    }

    /** Enables the fields if the controller has gains. */
    void setApplicable(boolean applicable) {
        for (JComponent field : new JComponent[] {choice, length, proportional, derivative}) {
            field.setEnabled(applicable);
        }
    }
}
