package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.List;

/** The names of a chart's series with a sample of each, in rows above the data. */
final class Legend {

    private static final double ROW_HEIGHT = 16;

    private final ChartStyle style;
    private final TextStyle textStyle;
    private final LegendRows<LegendItem> rows;

    /** A name, and the series or class that it belongs to. */
    private record LegendItem(String name, Series series, int index) {}

    Legend(List<Series> allSeries, ChartStyle style, double width) {
        this.style = style;
        textStyle = TextStyle.plain(11, style.palette().text());
        rows = LegendRows.of(items(allSeries), LegendItem::name, textStyle::estimateWidth, width);
    }

    private static List<LegendItem> items(List<Series> allSeries) {
        List<LegendItem> items = new ArrayList<>();
        for (Series series : allSeries) {
            if (series instanceof Series.Cells cells) {
                for (int i = 0; i < cells.names().size(); i++) {
                    items.add(new LegendItem(cells.names().get(i), series, i));
                }
            } else if (!(series instanceof Series.Note) && !series.name().isEmpty()) {
                items.add(new LegendItem(series.name(), series, 0));
            }
        }
        return items;
    }

    /** Returns the height of all rows, pixels. */
    double height() {
        return rows.rows().isEmpty() ? 0 : rows.rows().size() * ROW_HEIGHT + 4;
    }

    void paint(Surface surface, double x, double y) {
        rows.paint(surface, textStyle, new Vector2(x, y), ROW_HEIGHT, (item, left) -> paintSample(surface, item, left));
    }

    private void paintSample(Surface surface, LegendItem entry, Vector2 left) {
        List<Vector2> box = PlotPainter.corners(
                new PixelRectangle(left.x(), left.y() - 5, LegendRows.SAMPLE_WIDTH, 10), 0, 1, 1, 0);
        if (entry.series() instanceof Series.Line line) {
            Vector2 right = left.plus(new Vector2(LegendRows.SAMPLE_WIDTH, 0));
            surface.draw(Shapes.polyline(List.of(left, right)), style.lineStyle(line.styleIndex()));
        } else if (entry.series() instanceof Series.Points points) {
            MarkerPainter.paint(
                    surface, left.plus(new Vector2(LegendRows.SAMPLE_WIDTH / 2, 0)), points.styleIndex(), style);
        } else if (entry.series() instanceof Series.Band band) {
            surface.fill(Shapes.polygon(box), ChartStyle.withOpacity(style.series(band.styleIndex()), 0.2));
        } else {
            surface.fill(Shapes.polygon(box), style.classes().get(entry.index()));
            surface.draw(Shapes.polygon(box), LineStyle.solid(style.palette().text(), 0.6));
        }
    }
}
