package faultline.gui.window;

import faultline.gui.action.Keystrokes;
import faultline.gui.text.Texts;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.function.IntUnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.BoundedRangeModel;
import javax.swing.JLabel;
import javax.swing.JSlider;

/** The slider for the speed, and the number that it stands for. */
final class SpeedSlider extends JSlider {

    private static final int WIDTH = 170;
    private static final int LEAST_WIDTH = 60;

    private final JLabel number = new JLabel();

    SpeedSlider(BoundedRangeModel speed) {
        super(speed);
        Dimension size = new Dimension(WIDTH, getPreferredSize().height);
        setPreferredSize(size);
        setMaximumSize(size);
        setMinimumSize(new Dimension(LEAST_WIDTH, size.height));
        setToolTipText(Texts.text("speed.tip"));
        getAccessibleContext().setAccessibleName(Texts.text("speed"));
        // Each press of a key is another speed; the bare model would take three for real time.
        bind(KeyEvent.VK_LEFT, SpeedScale::slower);
        bind(KeyEvent.VK_RIGHT, SpeedScale::faster);
        prepareNumber();
        addChangeListener(event -> showNumber());
        showNumber();
    }

    private void bind(int key, IntUnaryOperator next) {
        String name = "speed" + key;
        getInputMap().put(Keystrokes.plain(key), name);
        getActionMap().put(name, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent event) {
                SpeedSlider.this.setValue(next.applyAsInt(SpeedSlider.this.getValue()));
            }
        });
    }

    private void prepareNumber() {
        Dimension size = new Dimension(number.getFontMetrics(number.getFont()).stringWidth("0000.00"), number.getFont().getSize() + 8);
        number.setPreferredSize(size);
        number.setMinimumSize(size);
        number.setMaximumSize(size);
    }

    private void showNumber() {
        double speed = SpeedScale.speed(getValue());
        String text = Double.isInfinite(speed) ? Texts.text("speed.most") : SpeedScale.text(speed);
        number.setText(text);
        getAccessibleContext().setAccessibleDescription(text);
    }

    /** Shows the speed as a number. */
    JLabel number() {
        return number;
    }
}
