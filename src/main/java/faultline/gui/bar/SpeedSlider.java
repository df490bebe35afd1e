package faultline.gui.bar;

import faultline.gui.action.SpeedScale;
import faultline.gui.text.Messages;
import faultline.gui.theme.KeyBindings;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.UiText;
import java.awt.Dimension;
import java.util.function.IntUnaryOperator;
import javax.swing.BoundedRangeModel;
import javax.swing.JLabel;
import javax.swing.JSlider;

/** The slider for the speed, with a label that shows the speed as a number. */
final class SpeedSlider extends JSlider {

    private static final int WIDTH = 170;
    private static final int MIN_WIDTH = 60;

    private final JLabel numberLabel = new JLabel();

    SpeedSlider(BoundedRangeModel speed) {
        super(speed);
        Dimension size = new Dimension(WIDTH, getPreferredSize().height);
        setPreferredSize(size);
        setMaximumSize(size);
        setMinimumSize(new Dimension(MIN_WIDTH, size.height));
        UiText.tip(UiText.name(this, "speed"), "speed.tip");
        // Each key press selects the next speed of the scale; the model alone would need three presses around 1x.
        bindKey("LEFT", SpeedScale::nextSlower);
        bindKey("RIGHT", SpeedScale::nextFaster);
        addChangeListener(event -> updateNumberLabel());
        RefreshSteps.add(numberLabel, label -> {
            fitNumberLabel();
            updateNumberLabel();
        });
    }

    private void bindKey(String key, IntUnaryOperator next) {
        KeyBindings.bind(this, key, () -> setValue(next.applyAsInt(getValue())));
    }

    private void fitNumberLabel() {
        Dimension size = new Dimension(
                numberLabel.getFontMetrics(numberLabel.getFont()).stringWidth("0000.00"),
                numberLabel.getFont().getSize() + 8);
        numberLabel.setPreferredSize(size);
        numberLabel.setMinimumSize(size);
        numberLabel.setMaximumSize(size);
    }

    private void updateNumberLabel() {
        double speed = SpeedScale.speedAt(getValue());
        String text = Double.isInfinite(speed) ? Messages.get("speed.max") : SpeedScale.format(speed);
        numberLabel.setText(text);
        getAccessibleContext().setAccessibleDescription(text);
    }

    /** Returns the label that shows the speed as a number. */
    JLabel numberLabel() {
        return numberLabel;
    }
}
