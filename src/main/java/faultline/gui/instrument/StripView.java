package faultline.gui.instrument;

import faultline.engine.session.ReferenceRun;
import faultline.engine.session.SessionFrame;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.surface.GraphicsSurface;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import javax.accessibility.AccessibleRole;

/** The plot area of a strip chart. It follows the newest frame, or is held over a past time span. */
final class StripView extends AccessibleComponent {

    /** No x coordinate. */
    static final double NOWHERE = Double.NaN;

    private static final Dimension MIN_SIZE = new Dimension(220, 110);

    /** Null before the first frame. */
    private transient SessionFrame frame;

    private transient SignalGroup signal = SignalGroup.NONE;
    private transient TimeSpan span = TimeSpan.DEFAULT;
    private transient ValueRange range = ValueRange.FROM_ZERO;
    private transient List<TimelineItem> items = List.of();
    /** Null if there is no reference run. */
    private transient ReferenceRun reference;

    /** Whether the lines are named beside the chart. */
    private final transient BooleanSupplier named;

    private double pointer = NOWHERE;
    private boolean frozen;

    /** Creates an empty plot, which names its lines unless {@code named} returns that they are named elsewhere. */
    StripView(BooleanSupplier named) {
        super(AccessibleRole.CANVAS);
        this.named = named;
        setMinimumSize(MIN_SIZE);
        setPreferredSize(MIN_SIZE);
        setFocusable(true);
        setOpaque(true);
        UiText.name(this, "strip.view");
    }

    /** Shows a newer frame. */
    void setFrame(SessionFrame newest) {
        assert EventQueue.isDispatchThread();
        frame = newest;
        if (!frozen) {
            span = span.endingAt(newest.snapshot().time());
        }
        repaint();
    }

    void setSignal(SignalGroup chosen) {
        signal = chosen;
        describe();
        repaint();
    }

    /** Names the lines for a screen reader, with their values at the pointer if there are any. */
    private void describe() {
        List<String> values = tooltip();
        List<String> shown =
                values.isEmpty() ? signal.lines().stream().map(ChartLine::name).toList() : values;
        getAccessibleContext().setAccessibleDescription(signal.name() + ": " + String.join(", ", shown));
    }

    /** Sets the faults, switches and moves that are marked behind the lines. */
    void setItems(List<TimelineItem> newItems) {
        items = newItems;
        repaint();
    }

    /** Shows the lines of a reference run beside those of the run, null for none. */
    void setReference(ReferenceRun run) {
        reference = run;
        repaint();
    }

    /** Holds the chart, or lets it follow the newest frame. */
    void setFrozen(boolean hold) {
        frozen = hold;
        refresh();
    }

    private void refresh() {
        if (frame != null) {
            setFrame(frame);
        }
    }

    /** Sets the range of the vertical axis. */
    void setRange(ValueRange newRange) {
        range = newRange;
        repaint();
    }

    ValueRange range() {
        return range;
    }

    TimeSpan span() {
        return span;
    }

    /** Shows another time span; while the chart follows the run, the span ends at the newest frame. */
    void setSpan(TimeSpan wanted) {
        span = wanted;
        refresh();
    }

    /**
     * Returns the position of an x coordinate on the time axis, 0 at its start and 1 at its end; 0.5 if there is none.
     */
    double shareAt(double x) {
        return scale().map(scale -> scale.plot().area())
                .map(area -> (x / imageScale() - area.x()) / area.width())
                .orElse(0.5);
    }

    /** Returns the position of a y coordinate on the vertical axis, 0 at its lower end and 1 at its upper end. */
    double valueShareAt(double y) {
        return 1
                - scale().map(scale -> (y / imageScale() - scale.plot().area().y())
                                / scale.plot().area().height())
                        .orElse(0.5);
    }

    /** Scales the vertical axis by a factor, with the value at a share of it kept in place. */
    void zoomValues(double factor, double share) {
        scale().ifPresent(scale -> setRange(ValueRange.zoomed(scale.plot().vertical(), factor, share)));
    }

    /** Moves the vertical axis by a share of its length. */
    void moveValues(double share) {
        scale().ifPresent(scale -> setRange(ValueRange.moved(scale.plot().vertical(), share)));
    }

    /** Shows the values at an x coordinate, or none at {@link #NOWHERE}. */
    void setPointer(double x) {
        pointer = x;
        repaint();
    }

    /** Returns whether values are shown at a pointer. */
    boolean hasPointer() {
        return !Double.isNaN(pointer);
    }

    /** Hides the values at the pointer, also for a screen reader. */
    void removePointer() {
        setPointer(NOWHERE);
        describe();
    }

    /**
     * Shows the values before or after those that are shown, also to a screen reader; the newest ones if none are
     * shown.
     *
     * @param direction -1 for earlier values, 1 for later ones
     * @param share the share of the time span to move by; if it is less than a pixel or one value, these count
     */
    void movePointer(int direction, double share) {
        scale().filter(scale -> !scale.isEmpty()).ifPresent(scale -> {
            StripData data = scale.data();
            double bucketLength = data.bucketLength();
            double pixel = span.length() / scale.plot().area().width();
            long buckets = Math.round(Math.max(bucketLength, Math.max(pixel, share * span.length())) / bucketLength);
            long newest = data.to() - 1;
            long wanted = hasPointer() ? data.bucketAt(span.timeAt(shareAt(pointer))) + direction * buckets : newest;
            double time = data.timeOf(Math.max(data.from(), Math.min(newest, wanted)));
            setPointer(scale.plot().x(time) * imageScale());
            describe();
        });
    }

    /** Returns the values shown at the cursor; empty if there are none. */
    List<String> tooltip() {
        return scale().flatMap(this::tooltip).map(ChartTooltip::lines).orElse(List.of());
    }

    private Optional<ChartTooltip> tooltip(StripScale scale) {
        return hasPointer()
                ? Optional.of(new ChartTooltip(scale, span.timeAt(shareAt(pointer))))
                        .filter(out -> !scale.isEmpty() && !out.isEmpty())
                : Optional.empty();
    }

    private double imageScale() {
        return TextSize.imageScale(getWidth(), getHeight(), MIN_SIZE);
    }

    /** Returns all that is shown; empty before the first frame. */
    Optional<StripContent> content() {
        return frame == null
                ? Optional.empty()
                : Optional.of(new StripContent(frame, signal, span, range, items, reference));
    }

    /** Returns the scale of what is shown; empty before the first frame. */
    Optional<StripScale> scale() {
        int width = (int) (getWidth() / imageScale());
        int height = (int) (getHeight() / imageScale());
        return content().map(shown -> shown.scale(width, height, !named.getAsBoolean()));
    }

    private void paint(Graphics2D g, StripScale scale) {
        content().orElseThrow().paint(new GraphicsSurface(g), Theme.current(), scale);
        tooltip(scale)
                .ifPresent(out -> out.paint(g, Theme.current(), getWidth() / imageScale(), getHeight() / imageScale()));
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
}
