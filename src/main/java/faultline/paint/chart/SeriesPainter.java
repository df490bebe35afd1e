package faultline.paint.chart;

import faultline.geometry.Vector2;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Drawing;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.TextStyle;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Draws what a chart shows into its plot. */
final class SeriesPainter {

    private final Drawing drawing;
    private final Chart chart;
    private final PixelRectangle plotArea;
    private final ChartStyle theme;

    SeriesPainter(Drawing drawing, Chart chart, PixelRectangle plot, ChartStyle theme) {
        this.drawing = drawing;
        this.chart = chart;
        this.plotArea = plot;
        this.theme = theme;
    }

    void paint(Series mark) {
        if (mark instanceof Series.Line line) {
            paintLine(line);
        } else if (mark instanceof Series.Points points) {
            points.points().stream()
                    .map(this::toFraction)
                    .filter(SeriesPainter::isInside)
                    .forEach(at -> MarkerPainter.paint(drawing, toPicture(at), points.styleIndex(), theme));
        } else if (mark instanceof Series.Band band) {
            paintBand(band);
        } else if (mark instanceof Series.Note note) {
            paintNote(note);
        }
    }

    private void paintLine(Series.Line line) {
        List<Vector2> shares = line.points().stream().map(this::toFraction).toList();
        LineClipper.clip(shares)
                .forEach(piece -> drawing.drawPolyline(
                        piece.stream().map(this::toPicture).toList(), false, theme.lineStyle(line.styleIndex())));
    }

    private void paintBand(Series.Band band) {
        List<Vector2> lower = new ArrayList<>(band.lower());
        Collections.reverse(lower);
        List<Vector2> around = new ArrayList<>(band.upper());
        around.addAll(lower);
        drawing.fillPolygon(
                around.stream()
                        .map(this::toFraction)
                        .map(SeriesPainter::clamp)
                        .map(this::toPicture)
                        .toList(),
                ChartStyle.withOpacity(theme.series(band.styleIndex()), 0.2));
    }

    private void paintNote(Series.Note note) {
        TextStyle style = TextStyle.plain(11, theme.palette().text());
        drawing.drawText(note.name(), toPicture(toFraction(note.position())), style);
    }

    void paintCells(Series.Cells cells) {
        int rows = cells.rows().size();
        for (int row = 0; row < rows; row++) {
            List<Integer> classes = cells.rows().get(row);
            for (int column = 0; column < classes.size(); column++) {
                double left = (double) column / classes.size();
                double right = (column + 1.0) / classes.size();
                double low = (double) row / rows;
                double high = (row + 1.0) / rows;
                drawing.fillPolygon(
                        List.of(
                                plotArea.pointAt(left, low),
                                plotArea.pointAt(right, low),
                                plotArea.pointAt(right, high),
                                plotArea.pointAt(left, high)),
                        theme.classes().get(classes.get(column)));
            }
        }
    }

    private Vector2 toFraction(Vector2 value) {
        return new Vector2(chart.x().fractionOf(value.x()), chart.y().fractionOf(value.y()));
    }

    private Vector2 toPicture(Vector2 share) {
        return plotArea.pointAt(share.x(), share.y());
    }

    private static boolean isInside(Vector2 share) {
        return share.x() >= 0 && share.x() <= 1 && share.y() >= 0 && share.y() <= 1;
    }

    private static Vector2 clamp(Vector2 share) {
        return new Vector2(Math.max(0, Math.min(1, share.x())), Math.max(0, Math.min(1, share.y())));
    }
}
