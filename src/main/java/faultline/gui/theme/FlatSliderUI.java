package faultline.gui.theme;

import faultline.paint.surface.DrawContext;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import javax.swing.plaf.ComponentUI;
import javax.swing.plaf.basic.BasicSliderUI;

/**
 * A flat slider: a thin track, filled up to a round thumb. Pressing the track moves the thumb there and starts to drag
 * it.
 */
public final class FlatSliderUI extends BasicSliderUI {

    /** The client property that holds a value to be marked on the track, an Integer. */
    public static final String MARK_PROPERTY = "faultline.mark";

    /** The client property that holds further marks, a list of {@link SliderMark}. */
    public static final String MARKS_PROPERTY = "faultline.marks";

    private static final int MARK_SIZE = 5;
    private static final int THUMB_SIZE = 15;

    /** The distance of the ends of the track from those of the slider, half a thumb, pixels. */
    public static final int TRACK_INSET = THUMB_SIZE / 2;

    private static final int TRACK_HEIGHT = 4;
    private static final double RING_INSET = 3.5;

    private FlatSliderUI(JSlider slider) {
        super(slider);
    }

    /** Called by Swing to create a delegate. */
    public static ComponentUI createUI(JComponent component) {
        return new FlatSliderUI((JSlider) component);
    }

    @Override
    protected TrackListener createTrackListener(JSlider ofSlider) {
        return new TrackListener() {
            /** Whether the value was being adjusted after the last event; pressing the thumb alone adjusts nothing. */
            private boolean adjusting;

            @Override
            public void mousePressed(MouseEvent event) {
                if (slider.isEnabled()
                        && SwingUtilities.isLeftMouseButton(event)
                        && !thumbRect.contains(event.getPoint())) {
                    slider.setValueIsAdjusting(true);
                    slider.setValue(valueForXPosition(event.getX()));
                    event.translatePoint(0, (int) thumbRect.getCenterY() - event.getY());
                }
                super.mousePressed(event);
                adjusting = slider.getValueIsAdjusting();
            }

            /** Ignores the rest of a drag that has been ended before the button is released. */
            @Override
            public void mouseDragged(MouseEvent event) {
                if (!adjusting || slider.getValueIsAdjusting()) {
                    super.mouseDragged(event);
                    adjusting = slider.getValueIsAdjusting();
                }
            }
        };
    }

    /** Also ends a drag when a dialog gets the focus, because it gets the release of the button, too. */
    @Override
    protected FocusListener createFocusListener(JSlider ofSlider) {
        return new FocusHandler() {
            @Override
            public void focusLost(FocusEvent event) {
                super.focusLost(event);
                if (event.isTemporary() && event.getOppositeComponent() != null) {
                    slider.setValueIsAdjusting(false);
                }
            }
        };
    }

    @Override
    protected Dimension getThumbSize() {
        return new Dimension(THUMB_SIZE, THUMB_SIZE);
    }

    @Override
    public void paintTrack(Graphics graphics) {
        Antialiasing.paint(graphics, g -> {
            double y = trackRect.y + (trackRect.height - TRACK_HEIGHT) / 2.0;
            g.setColor(Theme.currentColours().border());
            g.fill(new RoundRectangle2D.Double(
                    trackRect.x, y, trackRect.width, TRACK_HEIGHT, TRACK_HEIGHT, TRACK_HEIGHT));
            g.setColor(Theme.currentColours().accent());
            g.fill(new RoundRectangle2D.Double(
                    trackRect.x, y, thumbRect.getCenterX() - trackRect.x, TRACK_HEIGHT, TRACK_HEIGHT, TRACK_HEIGHT));
            if (slider.getClientProperty(MARKS_PROPERTY) instanceof List<?> marks) {
                marks.forEach(mark -> paintMark(g, (SliderMark) mark, y + TRACK_HEIGHT / 2.0));
            }
            if (slider.getClientProperty(MARK_PROPERTY) instanceof Integer value) {
                paintMark(g, xPositionForValue(value), y + TRACK_HEIGHT / 2.0);
            }
        });
    }

    private void paintMark(Graphics2D g, SliderMark mark, double y) {
        mark.paint(g, xPositionForValue(mark.value()), y);
    }

    private static void paintMark(Graphics2D g, double x, double y) {
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(x - MARK_SIZE, y);
        diamond.lineTo(x, y - MARK_SIZE);
        diamond.lineTo(x + MARK_SIZE, y);
        diamond.lineTo(x, y + MARK_SIZE);
        diamond.closePath();
        g.setColor(Theme.currentColours().background());
        g.fill(diamond);
        g.setColor(Theme.current().palette().reference());
        g.setStroke(DrawContext.solidStroke(2));
        g.draw(diamond);
    }

    @Override
    public void paintThumb(Graphics graphics) {
        Antialiasing.paint(graphics, g -> {
            g.setColor(Theme.currentColours().accent());
            g.fill(new Ellipse2D.Double(thumbRect.x + 0.5, thumbRect.y + 0.5, THUMB_SIZE - 1, THUMB_SIZE - 1));
            if (slider.hasFocus()) {
                // A ring inside the thumb; one around it would need more room than a slider has.
                double size = THUMB_SIZE - 2 * RING_INSET;
                g.setColor(Theme.currentColours().onAccent());
                g.setStroke(DrawContext.solidStroke(2));
                g.draw(new Ellipse2D.Double(thumbRect.x + RING_INSET, thumbRect.y + RING_INSET, size, size));
            }
        });
    }

    @Override
    public void paintFocus(Graphics graphics) {
        // The thumb shows the focus.
    }
}
