package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.gui.text.Texts;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
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

/** The picture of a strip chart. It runs along with the newest frame, or holds still over a piece of the past. */
final class StripView extends JComponent {

    private static final Dimension LEAST = new Dimension(220, 110);

    private transient Optional<Frame> frame = Optional.empty();
    private transient Optional<Signal> signal = Optional.empty();
    private transient TimeSpan span = TimeSpan.USUAL;
    private transient OptionalDouble pointer = OptionalDouble.empty();
    private boolean held;

    StripView() {
        setMinimumSize(LEAST);
        setPreferredSize(LEAST);
        setFocusable(true);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(Texts.text("strip.view"));
    }

    /** Shows a newer frame. */
    void show(Frame newest) {
        assert EventQueue.isDispatchThread();
        frame = Optional.of(newest);
        if (!held) {
            span = span.endingAt(newest.world().time());
        }
        repaint();
    }

    void setSignal(Signal chosen) {
        signal = Optional.of(chosen);
        getAccessibleContext().setAccessibleDescription(chosen.name());
        repaint();
    }

    /** Holds the chart still, or lets it run along again. */
    void setHeld(boolean hold) {
        held = hold;
        frame.ifPresent(this::show);
    }

    boolean isHeld() {
        return held;
    }

    TimeSpan span() {
        return span;
    }

    /** Shows another piece; while the chart runs along, its end stays at the newest moment. */
    void setSpan(TimeSpan wanted) {
        span = wanted;
        frame.ifPresent(this::show);
    }

    /** Where on the chart a place of this component is: 0 at its beginning, 1 at its end. */
    double share(double x) {
        return (x / enlargement() - StripScale.LEFT) / Math.max(1, getWidth() / enlargement() - StripScale.LEFT - StripScale.RIGHT);
    }

    /** Reads out the values at a place of this component, or none. */
    void point(OptionalDouble x) {
        pointer = x;
        repaint();
    }

    /** What is read out; empty where nothing is pointed at. */
    List<String> readOut() {
        return scale().flatMap(this::readOut).map(ReadOut::lines).orElse(List.of());
    }

    private Optional<ReadOut> readOut(StripScale scale) {
        return pointer.isEmpty() ? Optional.empty()
                : Optional.of(new ReadOut(scale, span.at(share(pointer.getAsDouble())))).filter(out -> !scale.isEmpty() && !out.isEmpty());
    }

    private double enlargement() {
        return TextSize.enlargement(getWidth(), getHeight(), LEAST);
    }

    private Optional<StripScale> scale() {
        int width = (int) (getWidth() / enlargement());
        int height = (int) (getHeight() / enlargement());
        return frame.flatMap(shown -> signal.map(chosen -> StripScale.of(shown, chosen, span, width, height)));
    }

    private void paint(Graphics2D g, StripScale scale) {
        new StripPainter(g, Theme.current(), scale).paint(StateRibbon.stays(frame.get(), span));
        readOut(scale).ifPresent(out -> out.paint(g, Theme.current()));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        Smooth.paint(graphics, g -> {
            AffineTransform whole = g.getTransform();
            g.scale(enlargement(), enlargement());
            scale().ifPresent(scale -> paint(g, scale));
            g.setTransform(whole);
            if (isFocusOwner()) {
                g.setColor(Theme.now().accent());
                g.draw(Smooth.box(0, 0, getWidth(), getHeight()));
            }
        });
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
            };
        }
        return accessibleContext;
    }
}
