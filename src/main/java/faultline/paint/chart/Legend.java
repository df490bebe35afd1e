package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Drawing;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.List;

/** What the marks of a chart are called, in rows above its data. */
final class Legend {

    private static final double ROW_HEIGHT = 16;
    private static final double SAMPLE_WIDTH = 26;
    private static final double GAP = 14;

    private final ChartStyle theme;
    private final TextStyle style;
    private final List<Entry> entries = new ArrayList<>();
    private double nextX;
    private int row;

    /** A name, its sample, and where it stands. */
    private record Entry(String name, Series series, int index, double x, int row) {}

    Legend(List<Series> marks, ChartStyle theme, double width) {
        this.theme = theme;
        style = TextStyle.plain(11, theme.palette().text());
        for (Series mark : marks) {
            if (mark instanceof Series.Cells cells) {
                for (int i = 0; i < cells.names().size(); i++) {
                    addEntry(cells.names().get(i), mark, i, width);
                }
            } else if (!(mark instanceof Series.Note) && !mark.name().isEmpty()) {
                addEntry(mark.name(), mark, 0, width);
            }
        }
    }

    private void addEntry(String name, Series mark, int index, double width) {
        double needed = SAMPLE_WIDTH + 5 + style.estimateWidth(name);
        if (nextX > 0 && nextX + needed > width) {
            nextX = 0;
            row++;
        }
        entries.add(new Entry(name, mark, index, nextX, row));
        nextX += needed + GAP;
    }

    /** How much room it takes, pixels. */
    double height() {
        return entries.isEmpty() ? 0 : (row + 1) * ROW_HEIGHT + 4;
    }

    void paint(Drawing drawing, double x, double y) {
        for (Entry entry : entries) {
            Vector2 left = new Vector2(x + entry.x(), y + entry.row() * ROW_HEIGHT + ROW_HEIGHT / 2);
            paintSample(drawing, entry, left);
            drawing.drawText(entry.name(), left.plus(new Vector2(SAMPLE_WIDTH + 5, 4)), style);
        }
    }

    private void paintSample(Drawing drawing, Entry entry, Vector2 left) {
        Vector2 right = left.plus(new Vector2(SAMPLE_WIDTH, 0));
        if (entry.series() instanceof Series.Line line) {
            drawing.drawPolyline(List.of(left, right), false, theme.lineStyle(line.styleIndex()));
        } else if (entry.series() instanceof Series.Points points) {
            MarkerPainter.paint(drawing, left.plus(new Vector2(SAMPLE_WIDTH / 2, 0)), points.styleIndex(), theme);
        } else if (entry.series() instanceof Series.Band band) {
            drawing.fillPolygon(sampleBox(left), ChartStyle.withOpacity(theme.series(band.styleIndex()), 0.2));
        } else {
            drawing.fillPolygon(sampleBox(left), theme.classes().get(entry.index()));
            drawing.drawPolyline(
                    sampleBox(left), true, LineStyle.solid(theme.palette().text(), 0.6));
        }
    }

    private static List<Vector2> sampleBox(Vector2 left) {
        return List.of(
                left.plus(new Vector2(0, -5)),
                left.plus(new Vector2(SAMPLE_WIDTH, -5)),
                left.plus(new Vector2(SAMPLE_WIDTH, 5)),
                left.plus(new Vector2(0, 5)));
    }
}
