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
    private static final double SAMPLE_WIDTH = 26;
    private static final double GAP = 14;

    private final ChartStyle style;
    private final TextStyle textStyle;
    private final List<LegendItem> entries = new ArrayList<>();
    private double nextX;
    private int row;

    /** A name, the series or class that it belongs to, and its position. */
    private record LegendItem(String name, Series series, int index, double x, int row) {}

    Legend(List<Series> allSeries, ChartStyle style, double width) {
        this.style = style;
        textStyle = TextStyle.plain(11, style.palette().text());
        for (Series series : allSeries) {
            if (series instanceof Series.Cells cells) {
                for (int i = 0; i < cells.names().size(); i++) {
                    addEntry(cells.names().get(i), series, i, width);
                }
            } else if (!(series instanceof Series.Note) && !series.name().isEmpty()) {
                addEntry(series.name(), series, 0, width);
            }
        }
    }

    private void addEntry(String name, Series series, int index, double width) {
        double needed = SAMPLE_WIDTH + 5 + textStyle.estimateWidth(name);
        if (nextX > 0 && nextX + needed > width) {
            nextX = 0;
            row++;
        }
        entries.add(new LegendItem(name, series, index, nextX, row));
        nextX += needed + GAP;
    }

    /** Returns the height of all rows, pixels. */
    double height() {
        return entries.isEmpty() ? 0 : (row + 1) * ROW_HEIGHT + 4;
    }

    void paint(Surface surface, double x, double y) {
        for (LegendItem entry : entries) {
            Vector2 left = new Vector2(x + entry.x(), y + entry.row() * ROW_HEIGHT + ROW_HEIGHT / 2);
            paintSample(surface, entry, left);
            surface.drawText(entry.name(), left.plus(new Vector2(SAMPLE_WIDTH + 5, 4)), textStyle);
        }
    }

    private void paintSample(Surface surface, LegendItem entry, Vector2 left) {
        List<Vector2> box =
                PlotPainter.corners(new PixelRectangle(left.x(), left.y() - 5, SAMPLE_WIDTH, 10), 0, 1, 1, 0);
        if (entry.series() instanceof Series.Line line) {
            Vector2 right = left.plus(new Vector2(SAMPLE_WIDTH, 0));
            surface.draw(Shapes.polyline(List.of(left, right)), style.lineStyle(line.styleIndex()));
        } else if (entry.series() instanceof Series.Points points) {
            MarkerPainter.paint(surface, left.plus(new Vector2(SAMPLE_WIDTH / 2, 0)), points.styleIndex(), style);
        } else if (entry.series() instanceof Series.Band band) {
            surface.fill(Shapes.polygon(box), ChartStyle.withOpacity(style.series(band.styleIndex()), 0.2));
        } else {
            surface.fill(Shapes.polygon(box), style.classes().get(entry.index()));
            surface.draw(Shapes.polygon(box), LineStyle.solid(style.palette().text(), 0.6));
        }
    }
}
