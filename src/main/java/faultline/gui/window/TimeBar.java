package faultline.gui.window;

import faultline.engine.Frame;
import faultline.engine.record.RunEvent;
import faultline.gui.text.Texts;
import faultline.gui.theme.FlatSliderUI;
import faultline.gui.theme.RuleBorder;
import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;

/**
 * The run so far as a line to go along. While the thumb is held, the remembered picture nearest before it shows at once; when it is let go,
 * the run goes to that very tick.
 */
final class TimeBar extends JPanel {

    private final JSlider slider = new JSlider(0, 0, 0);
    private final JLabel now = new JLabel(time(0));
    private final JLabel end = new JLabel(time(0));
    private final transient LongConsumer jump;
    private final transient Consumer<Frame> preview;
    private transient Optional<Frame> newest = Optional.empty();
    private double dt;
    private boolean showing;

    /**
     * A line without a run.
     *
     * @param jump given the tick that the user wants to go to
     * @param preview given remembered pictures while the thumb is held
     */
    TimeBar(LongConsumer jump, Consumer<Frame> preview) {
        super(new BorderLayout(10, 0));
        this.jump = jump;
        this.preview = preview;
        setBorder(RuleBorder.above(3, 14, 3));
        slider.setEnabled(false);
        slider.setToolTipText(Texts.text("time.tip"));
        slider.getAccessibleContext().setAccessibleName(Texts.text("time"));
        slider.addChangeListener(event -> moved());
        add(now, BorderLayout.LINE_START);
        add(slider, BorderLayout.CENTER);
        add(end, BorderLayout.LINE_END);
    }

    /** Whether the user holds the thumb, so that pictures of the run itself must wait. */
    boolean isHeld() {
        return slider.getValueIsAdjusting();
    }

    /** Shows where the run is, and how far it has been, ticks of {@code newDt} seconds. */
    void show(Frame frame, long furthest, double newDt) {
        assert EventQueue.isDispatchThread();
        newest = Optional.of(frame);
        dt = newDt;
        if (!isHeld()) {
            showing = true;
            slider.setMaximum(ticks(Math.max(furthest, frame.world().tick())));
            slider.setValue(ticks(frame.world().tick()));
            slider.setEnabled(slider.getMaximum() > 0);
            showing = false;
            write();
        }
    }

    /** Marks, from now on, where the run became another than an earlier one. */
    void mark(Optional<RunEvent.Diverged> divergence) {
        slider.putClientProperty(FlatSliderUI.MARK, divergence.map(event -> ticks(event.tick())).orElse(null));
        slider.setToolTipText(Texts.text("time.tip") + divergence.map(event -> " " + Texts.text("time.mark", time(event.time()).strip())).orElse(""));
        slider.repaint();
    }

    private void write() {
        now.setText(time(slider.getValue() * dt));
        end.setText(time(slider.getMaximum() * dt));
    }

    private static int ticks(long ticks) {
        return (int) Math.min(Integer.MAX_VALUE - 1, ticks);
    }

    private static String time(double seconds) {
        return String.format(Locale.ROOT, "%8.2f s", seconds);
    }

    private void moved() {
        if (showing) {
            return;
        }
        write();
        if (isHeld()) {
            newest.flatMap(frame -> frame.recording().keyframes().at(slider.getValue())).ifPresent(preview);
        } else {
            jump.accept(slider.getValue());
        }
    }
}
