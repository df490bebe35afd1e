package faultline.gui.instrument;

import faultline.geometry.Vector2;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.Theme;
import faultline.paint.chart.PlotPainter;
import faultline.paint.chart.TickStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import faultline.paint.surface.TextStyle.Anchor;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Paints a strip chart: the bar of controller states, axes and lines. */
final class StripPainter {

    private static final int RIBBON_GAP = 6;
    private static final int RIBBON_HEIGHT = 15;

    private final Surface surface;
    private final Theme theme;
    private final StripScale scale;
    private final PixelRectangle area;
    private final TextStyle textStyle;
    private final TextStyle mutedStyle;

    StripPainter(Surface surface, Theme theme, StripScale scale) {
        this.surface = surface;
        this.theme = theme;
        this.scale = scale;
        this.area = scale.plot().area();
        textStyle = TextStyle.plain(11, theme.palette().text());
        mutedStyle = TextStyle.plain(11, theme.palette().muted());
    }

    void paint(List<StateIntervals.StateInterval> intervals) {
        intervals.forEach(this::paintState);
        PlotPainter painter = new PlotPainter(surface, scale.plot());
        painter.paintGrid(LineStyle.solid(theme.palette().gridMajor(), 1));
        painter.paintTicks(new TickStyle(mutedStyle, 0, 6, 15, " s"));
        surface.drawText(scale.signal().unit(), new Vector2(4, RIBBON_GAP + 12), mutedStyle);
        scale.signal().lines().forEach(line -> painter.paintLine(values(line), line.style(theme)));
        if (scale.isEmpty()) {
            surface.drawText(
                    Messages.get("strip.none"),
                    area.pointAt(0.5, 0.5).minus(new Vector2(0, 4)),
                    mutedStyle.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Paints a section of the ribbon, with the name of the state if there is room for it. */
    private void paintState(StateIntervals.StateInterval interval) {
        double from = Math.max(area.x(), scale.plot().x(interval.start()));
        double to = Math.min(area.x() + area.width(), scale.plot().x(interval.end()));
        if (to <= from) {
            return;
        }
        surface.fill(
                new Rectangle2D.Double(from, RIBBON_GAP, to - from, RIBBON_HEIGHT),
                theme.colours().hover());
        surface.fill(
                new Rectangle2D.Double(from, RIBBON_GAP, 1.5, RIBBON_HEIGHT),
                theme.palette().muted());
        String name = StateText.name(interval.state());
        if (to - from - textStyle.estimateWidth(name) > 8) {
            surface.drawText(name, new Vector2((from + to) / 2, RIBBON_GAP + 12), textStyle.withAnchor(Anchor.MIDDLE));
        }
    }

    /** Returns the values of a line, each bucket from its least to its greatest; a bucket without any is a gap. */
    private List<Vector2> values(ChartLine line) {
        StripData data = scale.data();
        List<Vector2> values = new ArrayList<>();
        for (long bucket = data.from(); bucket < data.to(); bucket++) {
            double time = data.timeOf(bucket);
            float low = data.level().min(line.channel(), bucket);
            float high = data.level().max(line.channel(), bucket);
            values.add(new Vector2(time, low));
            if (high > low) {
                values.add(new Vector2(time, high));
            }
        }
        return values;
    }
}
