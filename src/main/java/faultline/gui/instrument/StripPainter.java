package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.engine.PathTag;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.CommandRole;
import faultline.gui.timeline.TimelineItem;
import faultline.paint.chart.PlotPainter;
import faultline.paint.chart.TickStyle;
import faultline.paint.scene.PathStyle;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.Palette;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.Color;
import java.awt.geom.Rectangle2D;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Paints a strip chart: the bar of controller states, faults behind the lines, axes, lines and collisions. */
final class StripPainter {

    private static final int RIBBON_GAP = 2;
    /** The distance from the upper edge of the ribbon down to the baseline of its texts, pixels. */
    private static final int RIBBON_BASELINE = 12;

    private static final int RIBBON_HEIGHT = 15;
    private static final int STATE_COLOUR_HEIGHT = 3;
    private static final int FAULT_ALPHA = 45;
    /** The opacity of all shades together. */
    private static final int MAX_ALPHA = 90;

    /** The distance between two lines of the text in an empty plot, pixels. */
    private static final int REASON_LINE_HEIGHT = 15;

    private static final int GRID_ALPHA = 75;

    private final Surface surface;
    private final Theme theme;
    private final StripScale scale;
    private final StripContent content;
    private final PixelRectangle area;
    /** The y coordinate of the upper edge of the ribbon, pixels. */
    private final double ribbonTop;

    /** The pixel columns that have a line; another one of its style would show nothing new, and many would be slow. */
    private final Map<LineStyle, BitSet> markedColumns = new HashMap<>();

    private final TextStyle textStyle;
    private final TextStyle mutedStyle;

    StripPainter(Surface surface, Theme theme, StripScale scale, StripContent content) {
        this.surface = surface;
        this.theme = theme;
        this.scale = scale;
        this.content = content;
        this.area = scale.plot().area();
        ribbonTop = area.y() - StripScale.TOP_MARGIN + RIBBON_GAP;
        textStyle = TextStyle.plain(StripScale.FONT_SIZE, theme.palette().text());
        mutedStyle = TextStyle.plain(StripScale.FONT_SIZE, theme.palette().muted());
    }

    void paint() {
        LegendPlace legend = scale.legend();
        LegendEntry.paint(legend.rows(), surface, theme, textStyle, legend.corner(), LegendPlace.ROW_HEIGHT);
        StateIntervals.within(content.frame(), content.span()).forEach(this::paintState);
        paintShades();
        content.items().forEach(this::paintItem);
        PlotPainter painter = new PlotPainter(surface, scale.plot());
        // Translucent, so that it differs from the shading of faults as well as from the canvas.
        painter.paintGrid(LineStyle.solid(Palette.withAlpha(theme.palette().muted(), GRID_ALPHA), 1));
        painter.paintTicks(new TickStyle(mutedStyle, 0, 6, 15, " s"));
        surface.drawText(scale.signal().unit(), new Vector2(4, ribbonTop + RIBBON_BASELINE), mutedStyle);
        StripLines lines = new StripLines(painter, theme, scale, content);
        lines.paintHalos();
        lines.paintReference();
        scale.signal().lines().forEach(lines::paint);
        paintEvents();
        if (scale.isEmpty() && content.reference() == null) {
            paintReason();
        }
    }

    /** Paints why there is no data, if there is room for it. */
    private void paintReason() {
        boolean foreign = content.frame().controller() instanceof ControllerSpec.Foreign;
        List<String> reason = Messages.get(foreign && content.signal().isDistance() ? "strip.noDistance" : "strip.none")
                .lines()
                .toList();
        boolean fits = reason.stream().allMatch(line -> textStyle.estimateWidth(line) < area.width());
        List<String> lines = fits ? reason : List.of(Messages.get("strip.none"));
        for (int i = 0; i < lines.size(); i++) {
            surface.drawText(
                    lines.get(i),
                    area.pointAt(0.5, 0.5).plus(new Vector2(0, i * REASON_LINE_HEIGHT - 4)),
                    mutedStyle.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Paints a section of the ribbon, with the name of the state if there is room for it. */
    private void paintState(StateIntervals.StateInterval interval) {
        double from = x(interval.start());
        double to = x(interval.end());
        if (to <= from) {
            return;
        }
        surface.fill(
                new Rectangle2D.Double(from, ribbonTop, to - from, RIBBON_HEIGHT),
                theme.colours().hover());
        surface.fill(
                new Rectangle2D.Double(from, ribbonTop, 1.5, RIBBON_HEIGHT),
                theme.palette().muted());
        surface.fill(
                new Rectangle2D.Double(from, ribbonTop + RIBBON_HEIGHT, to - from, STATE_COLOUR_HEIGHT),
                PathStyle.stateColour(theme.palette().dark(), PathTag.stateIndex(PathTag.of(interval.state(), false))));
        String name = TextStyle.literal(StateText.name(interval.state()));
        if (to - from - textStyle.estimateWidth(name) > 8) {
            surface.drawText(
                    name,
                    new Vector2((from + to) / 2, ribbonTop + RIBBON_BASELINE),
                    textStyle.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Returns the x coordinate of a time, limited to the plot. */
    private double x(double time) {
        return Math.max(area.x(), Math.min(area.x() + area.width(), scale.plot().x(Math.min(time, 1e9))));
    }

    /**
     * Shades the intervals of faults in the colours of their sensors. Several faults of a sensor shade an interval
     * once, and all sensors together leave the lines readable.
     */
    private void paintShades() {
        Map<Color, List<TimelineItem>> faults = content.items().stream()
                .filter(TimelineItem::isInterval)
                .collect(Collectors.groupingBy(this::colour, LinkedHashMap::new, Collectors.toList()));
        int alpha = Math.min(FAULT_ALPHA, MAX_ALPHA / Math.max(1, faults.size()));
        faults.forEach((colour, items) -> {
            double shaded = area.x();
            for (TimelineItem item : sorted(items)) {
                double from = Math.max(shaded, x(item.start()));
                double to = x(item.end());
                if (to > from) {
                    surface.fill(
                            new Rectangle2D.Double(from, area.y(), to - from, area.height()),
                            Palette.withAlpha(colour, alpha));
                    shaded = to;
                }
            }
        });
    }

    private static List<TimelineItem> sorted(List<TimelineItem> items) {
        return items.stream()
                .sorted(Comparator.comparingDouble(TimelineItem::start))
                .toList();
    }

    private Color colour(TimelineItem item) {
        return item.colours(theme.palette(), content.frame().snapshot().robot()).outline();
    }

    /** Marks the start and the end of a fault in the colour of its sensor, or a moment. */
    private void paintItem(TimelineItem item) {
        if (!item.isInterval()) {
            paintMoment(item.start(), theme.palette().muted(), DashPattern.DOTTED);
        } else if (x(item.end()) > x(item.start())) {
            paintMoment(item.start(), colour(item), DashPattern.SOLID);
            paintMoment(item.end(), colour(item), DashPattern.SOLID);
        }
    }

    private void paintMoment(double time, Color colour, DashPattern dash) {
        if (time >= content.span().start() && time <= content.span().end()) {
            double at = scale.plot().x(time);
            LineStyle style = new LineStyle(colour, 1, dash);
            BitSet columns = markedColumns.computeIfAbsent(style, first -> new BitSet());
            int column = (int) at;
            if (!columns.get(column)) {
                columns.set(column);
                paintMark(at, style);
            }
        }
    }

    /** Paints a vertical line; a solid one as an area, which takes a small part of the time. */
    private void paintMark(double x, LineStyle style) {
        if (style.dash() == DashPattern.SOLID) {
            surface.fill(
                    new Rectangle2D.Double(x - style.width() / 2, area.y(), style.width(), area.height()),
                    style.colour());
        } else {
            surface.draw(
                    Shapes.polyline(List.of(new Vector2(x, area.y()), new Vector2(x, area.y() + area.height()))),
                    style);
        }
    }

    private void paintEvents() {
        EventLog log = content.frame().recording().events();
        for (long i = log.firstIndex(); i < log.endIndex(); i++) {
            if (log.get(i) instanceof RunEvent.CommandExecuted done && CommandRole.isSettingChange(done.command())) {
                paintMoment(done.time(), theme.palette().muted(), DashPattern.DOTTED);
            } else if (log.get(i) instanceof RunEvent.Collided collided) {
                paintMoment(collided.time(), theme.palette().collision(), DashPattern.SOLID);
            }
        }
        if (content.reference() != null) {
            content.reference()
                    .collision()
                    .ifPresent(
                            first -> paintMoment(first.time(), theme.palette().reference(), DashPattern.DASHED));
        }
    }
}
