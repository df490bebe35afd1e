package faultline.gui.timeline;

import faultline.engine.Frame;
import faultline.engine.recording.RunEvent;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.text.NumberText;
import faultline.gui.theme.FlatSliderUI;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.SliderMark;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import javax.accessibility.AccessibleContext;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;

/**
 * The slider of the run's time. While the thumb is dragged, the nearest keyframe before it is shown immediately; when
 * it is released, the run goes to exactly that tick.
 */
public final class TimeBar extends JPanel {

    private static final int GAP = 10;
    private static final int MARK_REACH = 3;
    /** The digits before the point that a time has room for, and the point. */
    private static final int WHOLE_WIDTH = 6;

    private final JSlider slider = new TimeSlider();
    private final JLabel currentTimeLabel = new JLabel(timeText(0)) {
        @Override
        public Dimension getPreferredSize() {
            Dimension size = super.getPreferredSize();
            return new Dimension(Math.max(leadingWidth, size.width), size.height);
        }
    };
    private final JLabel endTimeLabel = new JLabel(timeText(0));
    private final transient LongConsumer seekHandler;
    private final transient Consumer<Frame> previewHandler;
    /** Null before the first frame. */
    private transient SessionFrame newestFrame;

    private double dt;
    private int leadingWidth;
    private boolean updating;
    private transient List<SliderMark> marks = List.of();
    /** Null if the run does not differ from the reference run. */
    private transient RunEvent.Diverged shownDivergence;

    /** A slider whose values are ticks, and seconds for screen readers. */
    private final class TimeSlider extends JSlider {

        TimeSlider() {
            super(0, 0, 0);
        }

        @Override
        public String getToolTipText(MouseEvent event) {
            return markAt(event.getX()).map(SliderMark::text).orElseGet(super::getToolTipText);
        }

        @Override
        public AccessibleContext getAccessibleContext() {
            if (accessibleContext == null) {
                accessibleContext = new AccessibleTime();
            }
            return accessibleContext;
        }

        private final class AccessibleTime extends AccessibleJSlider {
            @Override
            public Number getCurrentAccessibleValue() {
                return shownTime();
            }

            /** Names the time where the slider would name the tick. */
            @Override
            public void firePropertyChange(String property, Object before, Object now) {
                if (ACCESSIBLE_VALUE_PROPERTY.equals(property) && before instanceof Integer && now instanceof Integer) {
                    super.firePropertyChange(property, timeOf((Integer) before), timeOf((Integer) now));
                } else {
                    super.firePropertyChange(property, before, now);
                }
            }

            @Override
            public boolean setCurrentAccessibleValue(Number seconds) {
                return dt > 0 && super.setCurrentAccessibleValue(Math.round(seconds.doubleValue() / dt));
            }

            @Override
            public Number getMinimumAccessibleValue() {
                return timeOf(getMinimum());
            }

            @Override
            public Number getMaximumAccessibleValue() {
                return timeOf(getMaximum());
            }
        }
    }

    /**
     * Creates a time bar without a run. {@code jump} receives the tick to go to, {@code preview} keyframes while the
     * thumb is dragged.
     */
    TimeBar(LongConsumer jump, Consumer<Frame> preview) {
        super(new BorderLayout(GAP, 0));
        this.seekHandler = jump;
        this.previewHandler = preview;
        slider.setEnabled(false);
        UiText.name(slider, "time");
        RefreshSteps.add(slider, self -> updateToolTip());
        slider.addChangeListener(event -> onSliderChanged());
        add(currentTimeLabel, BorderLayout.LINE_START);
        add(slider, BorderLayout.CENTER);
        add(endTimeLabel, BorderLayout.LINE_END);
    }

    /** Sets the least width of the label before the slider, pixels. */
    void setLeadingWidth(int width) {
        leadingWidth = width;
        currentTimeLabel.revalidate();
    }

    /** Returns the axis of the slider's track, in the coordinates of this bar. */
    TimeAxis axis() {
        int inset = FlatSliderUI.TRACK_INSET;
        return new TimeAxis(
                slider.getX() + inset, slider.getX() + slider.getWidth() - inset - 1.0, slider.getMaximum() * dt);
    }

    /** Returns the time that the slider shows, seconds. */
    double shownTime() {
        return slider.getValue() * dt;
    }

    /** Returns whether the user drags the thumb, so that frames of the run must wait. */
    public boolean isAdjusting() {
        return slider.getValueIsAdjusting();
    }

    /** Prepares for another scenario: ends a drag without going anywhere. */
    void startScenario() {
        updating = true;
        slider.setValueIsAdjusting(false);
        updating = false;
    }

    /** Shows the tick of a frame and the last known one. */
    void setFrame(SessionFrame frame, long furthest) {
        assert EventQueue.isDispatchThread();
        newestFrame = frame;
        if (frame.dt() != dt) {
            dt = frame.dt();
            updateToolTip();
        }
        if (!isAdjusting()) {
            updating = true;
            slider.setMaximum(toSliderValue(Math.max(furthest, frame.snapshot().tick())));
            slider.setValue(toSliderValue(frame.snapshot().tick()));
            slider.setEnabled(slider.getMaximum() > 0);
            updating = false;
            updateLabels();
        }
    }

    /** Shows the marks of events and faults. */
    void setMarks(List<SliderMark> newMarks) {
        slider.putClientProperty(FlatSliderUI.MARKS_PROPERTY, newMarks);
        marks = newMarks;
        slider.repaint();
    }

    /** Returns the topmost mark at an x coordinate of the slider. */
    private Optional<SliderMark> markAt(int x) {
        TimeAxis axis = axis();
        return marks.stream()
                .filter(mark -> Math.abs(axis.x(mark.value() * dt) - slider.getX() - x) <= MARK_REACH)
                .reduce((lower, upper) -> upper);
    }

    /** Marks the moment at which the run first differs from the reference run, null for none. */
    public void setDivergence(RunEvent.Diverged divergence) {
        shownDivergence = divergence;
        slider.putClientProperty(
                FlatSliderUI.MARK_PROPERTY, divergence == null ? null : toSliderValue(divergence.tick()));
        updateToolTip();
        slider.repaint();
    }

    /** Returns the moment that is marked as the first difference; null for none. */
    RunEvent.Diverged divergence() {
        return shownDivergence;
    }

    /** Returns the time of a tick, seconds. */
    double timeOf(long tick) {
        return tick * dt;
    }

    /** Returns the time of a tick as text, seconds. */
    String tickText(long tick) {
        return NumberText.seconds(timeOf(tick), dt);
    }

    /** Returns the tick at the end of the slider. */
    long end() {
        return slider.getMaximum();
    }

    private void updateToolTip() {
        String mark = shownDivergence == null
                ? ""
                : " "
                        + Messages.get(
                                "time.mark", timeText(shownDivergence.time()).strip());
        slider.setToolTipText(Messages.get("time.tip") + mark);
    }

    private void updateLabels() {
        currentTimeLabel.setText(timeText(slider.getValue() * dt));
        endTimeLabel.setText(timeText(slider.getMaximum() * dt));
    }

    /** Returns the value of the slider at a tick; a slider has no greater ones. */
    static int toSliderValue(long tick) {
        return (int) Math.min(Integer.MAX_VALUE - 1, tick);
    }

    private String timeText(double seconds) {
        int decimals = NumberText.decimals(dt);
        return NumberText.format("%" + (WHOLE_WIDTH + decimals) + "." + decimals + "f s", seconds);
    }

    private void onSliderChanged() {
        if (updating) {
            return;
        }
        updateLabels();
        if (isAdjusting()) {
            newestFrame.recording().keyframes().frameAt(slider.getValue()).ifPresent(previewHandler);
        } else {
            seekHandler.accept(slider.getValue());
        }
    }
}
