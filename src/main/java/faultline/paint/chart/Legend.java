package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import faultline.paint.surface.TextStyle;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The names of a chart's series with a sample of each, in rows above the data. */
final class Legend {

    private static final double ROW_HEIGHT = 16;

    private final ChartStyle style;
    private final TextStyle textStyle;
    private final LegendRows<LegendItem> rows;

    /** Paints a sample of a series at the point in the middle of its left edge. */
    private interface ItemSample {
        void paint(Surface surface, Vector2 left);
    }

    private record LegendItem(String name, ItemSample sample) {}

    Legend(List<Series> allSeries, ChartStyle style, double width) {
        this.style = style;
        textStyle = TextStyle.plain(ChartStyle.TEXT_SIZE, style.palette().text());
        List<LegendItem> items = new ArrayList<>();
        allSeries.forEach(series -> addItems(series, items));
        rows = LegendRows.of(items, LegendItem::name, textStyle::estimateWidth, width);
    }

    /** Returns the height of all rows, pixels. */
    double height() {
        return rows.rows().isEmpty() ? 0 : rows.rows().size() * ROW_HEIGHT + 4;
    }

    void paint(Surface surface, double x, double y) {
        rows.paint(surface, textStyle, new Vector2(x, y), ROW_HEIGHT, (item, left) -> item.sample.paint(surface, left));
    }

    private static List<Vector2> box(Vector2 left) {
        return PlotPainter.corners(new PixelRectangle(left.x(), left.y() - 5, LegendRows.SAMPLE_WIDTH, 10), 0, 1, 1, 0);
    }

    private void addItems(Series series, List<LegendItem> items) {
        Consumer<ItemSample> add = sample -> {
            if (!series.name().isEmpty()) {
                items.add(new LegendItem(series.name(), sample));
            }
        };
        series.match(new Series.SeriesCases(
                line -> add.accept((surface, left) -> {
                    Vector2 right = left.plus(new Vector2(LegendRows.SAMPLE_WIDTH, 0));
                    surface.draw(Shapes.polyline(List.of(left, right)), style.lineStyle(line.styleIndex()));
                }),
                points -> add.accept((surface, left) -> {
                    Vector2 middle = left.plus(new Vector2(LegendRows.SAMPLE_WIDTH / 2, 0));
                    MarkerPainter.paint(surface, middle, points.styleIndex(), style);
                }),
                band -> add.accept((surface, left) -> {
                    surface.fill(Shapes.polygon(box(left)), style.band(band.styleIndex()));
                }),
                cells -> addClasses(cells, items),
                note -> {
                    // A text explains itself.
                }));
    }

    private void addClasses(Series.Cells cells, List<LegendItem> items) {
        for (int i = 0; i < cells.names().size(); i++) {
            Color colour = style.classes().get(i);
            items.add(new LegendItem(cells.names().get(i), (surface, left) -> {
                surface.fill(Shapes.polygon(box(left)), colour);
                surface.draw(
                        Shapes.polygon(box(left)),
                        LineStyle.solid(style.palette().text(), 0.6));
            }));
        }
    }
}
