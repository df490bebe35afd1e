package faultline.paint.chart;

import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.TextStyle;
import java.util.List;

/** Paints the series of a chart in the colours of a style. */
record SeriesPainter(PlotPainter painter, ChartStyle style) {

    void paint(Series series) {
        series.match(new Series.SeriesCases(
                line -> painter.paintLine(line.points(), style.lineStyle(line.styleIndex())),
                points -> painter.paintMarkers(points.points(), points.styleIndex(), style),
                band -> painter.paintBand(band.upper(), band.lower(), style.band(band.styleIndex())),
                this::paintCells,
                note -> painter.surface()
                        .drawText(
                                note.name(),
                                painter.plot().toPicture(note.position()),
                                TextStyle.plain(
                                        ChartStyle.TEXT_SIZE, style.palette().text()))));
    }

    private void paintCells(Series.Cells cells) {
        double height = 1.0 / cells.rows().size();
        for (int row = 0; row < cells.rows().size(); row++) {
            List<Integer> classes = cells.rows().get(row);
            double width = 1.0 / classes.size();
            for (int column = 0; column < classes.size(); column++) {
                painter.surface()
                        .fill(
                                Shapes.polygon(PlotPainter.corners(
                                        painter.plot().area(),
                                        column * width,
                                        row * height,
                                        (column + 1) * width,
                                        (row + 1) * height)),
                                style.classes().get(classes.get(column)));
            }
        }
    }
}
