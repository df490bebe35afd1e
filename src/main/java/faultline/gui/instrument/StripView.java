package faultline.gui.instrument;

import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.surface.GraphicsSurface;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;

/** The plot area of a strip chart. It follows the newest frame, or is held over a past time span. */
final class StripView extends JComponent {

    private static final Dimension MIN_SIZE = new Dimension(220, 110);

    private transient Optional<SessionFrame> frame = Optional.empty();
    private transient Optional<SignalGroup> signal = Optional.empty();
    private transient TimeSpan span = TimeSpan.DEFAULT;
    private transient OptionalDouble pointer = OptionalDouble.empty();
    private boolean frozen;
    private boolean fromZero = true;

    StripView() {
        setMinimumSize(MIN_SIZE);
        setPreferredSize(MIN_SIZE);
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(Messages.get("strip.view"));
    }

    /** Shows a newer frame. */
    void setFrame(SessionFrame newest) {
        assert EventQueue.isDispatchThread();
        frame = Optional.of(newest);
        if (!frozen) {
            span = span.endingAt(newest.snapshot().time());
        }
        repaint();
    }

    void setSignal(SignalGroup chosen) {
        signal = Optional.of(chosen);
        getAccessibleContext().setAccessibleDescription(chosen.name());
        repaint();
    }

    /** Holds the chart, or lets it follow the newest frame. */
    void setFrozen(boolean hold) {
        frozen = hold;
        frame.ifPresent(this::setFrame);
    }

    /** Includes zero in the vertical axis, or fits it to the values. */
    void setFromZero(boolean newFromZero) {
        fromZero = newFromZero;
        repaint();
    }

    boolean isFrozen() {
        return frozen;
    }

    TimeSpan span() {
        return span;
    }

    /** Shows another time span; while the chart follows the run, the span ends at the newest frame. */
    void setSpan(TimeSpan wanted) {
        span = wanted;
        frame.ifPresent(this::setFrame);
    }

    /** Returns the position of an x coordinate on the time axis, 0 at its start and 1 at its end. */
    double shareAt(double x) {
        return (x / imageScale() - StripScale.LEFT_MARGIN)
                / Math.max(1, getWidth() / imageScale() - StripScale.LEFT_MARGIN - StripScale.RIGHT_MARGIN);
    }

    /** Shows the values at an x coordinate, or none. */
    void setPointer(OptionalDouble x) {
        pointer = x;
        repaint();
    }

    /** Returns the values shown at the cursor; empty if there are none. */
    List<String> tooltip() {
        return scale().flatMap(this::tooltip).map(ChartTooltip::lines).orElse(List.of());
    }

    private Optional<ChartTooltip> tooltip(StripScale scale) {
        return pointer.isEmpty()
                ? Optional.empty()
                : Optional.of(new ChartTooltip(scale, span.timeAt(shareAt(pointer.getAsDouble()))))
                        .filter(out -> !scale.isEmpty() && !out.isEmpty());
    }

    private double imageScale() {
        return TextSize.imageScale(getWidth(), getHeight(), MIN_SIZE);
    }

    private Optional<StripScale> scale() {
        int width = (int) (getWidth() / imageScale());
        int height = (int) (getHeight() / imageScale());
        return frame.flatMap(
                shown -> signal.map(chosen -> StripScale.of(shown, chosen, span, fromZero, width, height)));
    }

    private void paint(Graphics2D g, StripScale scale) {
        new StripPainter(new GraphicsSurface(g), Theme.current(), scale)
                .paint(StateIntervals.within(frame.get(), span));
        tooltip(scale).ifPresent(out -> out.paint(g, Theme.current()));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        Antialiasing.paint(graphics, g -> {
            AffineTransform whole = g.getTransform();
            g.scale(imageScale(), imageScale());
            scale().ifPresent(scale -> paint(g, scale));
            g.setTransform(whole);
            if (isFocusOwner()) {
                g.setColor(Theme.currentColours().accent());
                g.draw(Antialiasing.roundedRectangle(0, 0, getWidth(), getHeight()));
            }
        });
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {};
        }
        return accessibleContext;
    }
}
