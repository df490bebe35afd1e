package faultline.gui.timeline;

import faultline.gui.text.Messages;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.chart.Axis;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.paint.surface.SensorColours;
import faultline.paint.surface.ShortenedText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.stream.IntStream;

/** Paints the lanes of the time line. */
final class LanePainter {

    /** In both themes, texts on bars have a contrast of at least 4.5. */
    static final int BAR_ALPHA = 90;

    private static final int BAND_ALPHA = 40;
    private static final int LABEL_ROOM = 6;
    /** The width of the border of a bar. */
    private static final int BORDER = 1;

    private static final int HANDLE = 3;
    private static final int SWATCH = 7;
    /** The smallest gap between the labels of two ticks, pixels. */
    private static final int TICK_LABEL_GAP = 16;

    private final Graphics2D g;
    private final LaneView view;
    private final LaneLayout lanes;
    private final Theme theme = Theme.current();
    private final Font font;

    LanePainter(Graphics2D g, LaneView view) {
        this.g = g;
        this.view = view;
        this.lanes = view.lanes();
        this.font = new Font(Font.SANS_SERIF, Font.PLAIN, Math.min(TextSize.scaled(11), lanes.rowHeight() - 2));
    }

    void paint() {
        g.setColor(theme.palette().canvas());
        g.fillRect(0, 0, view.getWidth(), view.getHeight());
        paintLanes();
        if (!view.isEnabled()) {
            return;
        }
        paintTicks();
        paintItems();
        if (lanes.items().isEmpty() && lanes.lanes().size() > 1) {
            paintHint();
        }
        paintNow();
        paintRuler();
        view.preview().ifPresent(this::paintTimes);
    }

    private void paintLanes() {
        for (int lane = 0; lane < lanes.lanes().size(); lane++) {
            int y = lanes.laneTop(lane);
            if (lane == view.lane() && view.showsSelectedLane()) {
                g.setColor(theme.colours().hover());
                g.fillRect(0, y, view.getWidth(), lanes.laneHeight(lane));
                g.setColor(theme.colours().accent());
                g.fillRect(0, y, 3, lanes.laneHeight(lane));
            }
            g.setColor(theme.palette().grid());
            g.fillRect(0, y, view.getWidth(), 1);
            String name = lanes.lanes().get(lane).label();
            double room = lanes.axis().left() - 3 * LABEL_ROOM - SWATCH;
            Color colour =
                    view.isEnabled() ? theme.palette().text() : theme.palette().muted();
            paintText(name, font, 2.0 * LABEL_ROOM + SWATCH, y, lanes.rowHeight(), room, colour);
            if (lanes.lanes().get(lane) instanceof Lane.SensorLane) {
                paintSwatch(lane);
            }
        }
    }

    private void paintSwatch(int lane) {
        SensorColours colours = theme.palette().sensorColours(lane);
        Shape swatch = new Ellipse2D.Double(
                LABEL_ROOM, lanes.laneTop(lane) + (lanes.rowHeight() - SWATCH) / 2.0, SWATCH, SWATCH);
        g.setColor(colours.fill());
        g.fill(swatch);
        g.setColor(colours.outline());
        g.setStroke(new BasicStroke(1));
        g.draw(swatch);
    }

    /** Paints a text in a row, shortened to a width. */
    private void paintText(
            String text, Font textFont, double x, double top, double height, double width, Color colour) {
        g.setFont(textFont);
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(colour);
        g.drawString(ShortenedText.of(text, metrics, width), (float) x, baseline(top, height, metrics));
    }

    private static float baseline(double top, double height, FontMetrics metrics) {
        // Between two rows of pixels, a text would be blurred.
        return (float) Math.floor(top + (height + metrics.getAscent() - metrics.getDescent()) / 2);
    }

    private void paintTicks() {
        g.setColor(theme.palette().gridMajor());
        for (double tick : lanes.axis().ticks().ticks()) {
            g.fill(new Rectangle2D.Double(
                    lanes.axis().x(tick),
                    lanes.top(),
                    1,
                    lanes.laneTop(lanes.lanes().size()) - lanes.top()));
        }
    }

    /** Paints the labels of the times over what is below them. */
    private void paintRuler() {
        g.setFont(font);
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(theme.palette().canvas());
        g.fillRect(0, view.rulerTop(), view.getWidth(), lanes.top());
        g.setColor(theme.palette().muted());
        for (double tick : labelledTicks(lanes.axis(), metrics)) {
            String text = tickText(tick);
            double width = metrics.stringWidth(text);
            double left = Math.min(lanes.axis().x(tick) - width / 2, view.getWidth() - width);
            g.drawString(text, (float) left, baseline(view.rulerTop(), lanes.top(), metrics));
        }
    }

    private static String tickText(double tick) {
        return Axis.formatTick(tick) + " s";
    }

    /** Returns the ticks of an axis that have labels, at equal distances which have room for them. */
    static List<Double> labelledTicks(TimeAxis axis, FontMetrics metrics) {
        Axis ticks = axis.ticks();
        int widest = ticks.ticks().stream()
                .mapToInt(tick -> metrics.stringWidth(tickText(tick)))
                .max()
                .orElse(0);
        int stride = ticks.labelStride(axis.right() - axis.left(), widest + TICK_LABEL_GAP);
        return ticks.ticks().stream()
                .filter(tick -> ticks.hasLabel(tick, stride))
                .toList();
    }

    /** Paints the visible items; what lies beyond the visible part of the run is cut off at the ends of the axis. */
    private void paintItems() {
        Shape clip = g.getClip();
        TimeAxis axis = lanes.axis();
        if (!axis.isWhole()) {
            // A mark at an end of the run is painted on both sides of it.
            double before = axis.start() == 0 ? lanes.rowHeight() : 0;
            double after = axis.end() == axis.runEnd() ? lanes.rowHeight() : 0;
            double left = axis.left() - before;
            g.clip(new Rectangle2D.Double(left, 0, axis.right() + after - left, view.getHeight()));
        }
        IntStream.range(0, lanes.items().size()).filter(lanes::isVisible).forEach(this::paintItem);
        g.setClip(clip);
    }

    private void paintItem(int index) {
        TimelineItem item = lanes.items().get(index);
        Rectangle2D bounds = lanes.visibleBounds(index, 2.0 * lanes.rowHeight());
        boolean selected = view.preview().map(item::equals).orElse(index == view.selection());
        if (item.isInterval()) {
            paintBar(item, bounds, selected);
            paintLabel(index, bounds);
        } else {
            paintMark(bounds, selected);
        }
    }

    private void paintBar(TimelineItem item, Rectangle2D bounds, boolean selected) {
        SensorColours colours = item.colours(theme.palette(), lanes.laneOf(item));
        Shape bar = new RoundRectangle2D.Double(
                bounds.getX() + 0.5, bounds.getY() + 0.5, bounds.getWidth() - 1, bounds.getHeight() - 1, 5, 5);
        g.setColor(Palette.withAlpha(colours.fill(), BAR_ALPHA));
        g.fill(bar);
        g.setColor(selected ? theme.colours().accent() : colours.outline());
        g.setStroke(new BasicStroke(selected ? 2 : 1));
        g.draw(bar);
        if (selected) {
            paintHandle(bounds.getMinX(), bounds);
            paintHandle(bounds.getMaxX(), bounds);
        }
    }

    private void paintHandle(double x, Rectangle2D bounds) {
        g.fill(new Rectangle2D.Double(
                x - HANDLE / 2.0 - 0.5, bounds.getCenterY() - HANDLE, HANDLE + 1.0, 2.0 * HANDLE));
    }

    private void paintLabel(int index, Rectangle2D bounds) {
        if (bounds.getHeight() < lanes.rowHeight() / 2.0 + 3) {
            return;
        }
        Font labelFont = labelFont(bounds.getHeight());
        g.setFont(labelFont);
        FontMetrics metrics = g.getFontMetrics();
        String text = TimelineText.label(lanes.items().get(index));
        double width = metrics.stringWidth(text);
        LaneLayout.LabelRoom room = lanes.labelRoom(index, width, LABEL_ROOM, view.getWidth());
        if (Math.min(width, metrics.stringWidth("mm…")) <= room.width()) {
            Color colour = theme.palette().text();
            paintText(text, labelFont, room.left(), bounds.getY(), bounds.getHeight(), Math.ceil(room.width()), colour);
        }
    }

    /** Returns a font whose letters do not touch the border of a bar of a height, pixels. */
    private Font labelFont(double height) {
        // On the screen, the letters may be one pixel higher than the size of the font.
        return font.deriveFont((float) Math.min(font.getSize(), Math.floor(height - 2 * BORDER - 1)));
    }

    private void paintMark(Rectangle2D bounds, boolean selected) {
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(bounds.getMinX(), bounds.getCenterY());
        diamond.lineTo(bounds.getCenterX(), bounds.getMinY());
        diamond.lineTo(bounds.getMaxX(), bounds.getCenterY());
        diamond.lineTo(bounds.getCenterX(), bounds.getMaxY());
        diamond.closePath();
        g.setColor(theme.palette().canvas());
        g.fill(diamond);
        g.setColor(selected ? theme.colours().accent() : theme.palette().text());
        g.setStroke(DrawContext.solidStroke(selected ? 2.5 : 1.5));
        g.draw(diamond);
    }

    private void paintHint() {
        int lane = Math.min(1, lanes.lanes().size() - 1);
        double x = lanes.axis().left() + LABEL_ROOM;
        paintText(
                Messages.get("timeline.hint"),
                font,
                x,
                lanes.laneTop(lane),
                lanes.rowHeight(),
                view.getWidth() - x,
                theme.palette().muted());
    }

    private void paintNow() {
        double x = lanes.axis().x(view.now());
        if (!lanes.axis().shows(view.now())) {
            return;
        }
        g.setColor(theme.colours().accent());
        g.setStroke(new BasicStroke(1.5f));
        g.draw(new Line2D.Double(x, lanes.top(), x, view.getHeight()));
    }

    /** Paints the times of the item that is being dragged in the ruler. */
    private void paintTimes(TimelineItem item) {
        TimeAxis axis = lanes.axis();
        double from = Math.max(axis.left(), Math.min(axis.right(), axis.x(item.start())));
        double to = Math.max(axis.left(), Math.min(axis.right(), axis.x(item.end())));
        g.setColor(Palette.withAlpha(theme.colours().accent(), BAND_ALPHA));
        g.fill(new Rectangle2D.Double(from, lanes.top(), Math.max(1, to - from), view.getHeight()));
        g.setFont(font.deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        String text = TimelineText.times(item, view.tickLength());
        double width = metrics.stringWidth(text) + 2.0 * LABEL_ROOM;
        double left = Math.max(0, Math.min(view.getWidth() - width, (from + to - width) / 2));
        g.setColor(theme.colours().accent());
        g.fill(new RoundRectangle2D.Double(left, view.rulerTop(), width, lanes.top(), 5, 5));
        g.setColor(theme.colours().onAccent());
        g.drawString(text, (float) (left + LABEL_ROOM), baseline(view.rulerTop(), lanes.top(), metrics));
    }
}
