package faultline.paint.plot;

import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Draws what a chart shows into its plot. */
final class MarkPainter {

    private final Drawing drawing;
    private final Chart chart;
    private final Area plot;
    private final Theme theme;

    MarkPainter(Drawing drawing, Chart chart, Area plot, Theme theme) {
        this.drawing = drawing;
        this.chart = chart;
        this.plot = plot;
        this.theme = theme;
    }

    void paint(Mark mark) {
        if (mark instanceof Mark.Line line) {
            line(line);
        } else if (mark instanceof Mark.Points points) {
            points.points().stream().map(this::share).filter(MarkPainter::inside)
                    .forEach(at -> Marker.paint(drawing, place(at), points.style(), theme));
        } else if (mark instanceof Mark.Band band) {
            band(band);
        } else if (mark instanceof Mark.Note note) {
            note(note);
        }
    }

    private void line(Mark.Line line) {
        List<Vec> shares = line.points().stream().map(this::share).toList();
        Clip.pieces(shares).forEach(piece -> drawing.stroke(piece.stream().map(this::place).toList(), false, theme.linePen(line.style())));
    }

    private void band(Mark.Band band) {
        List<Vec> lower = new ArrayList<>(band.lower());
        Collections.reverse(lower);
        List<Vec> around = new ArrayList<>(band.upper());
        around.addAll(lower);
        drawing.fill(around.stream().map(this::share).map(MarkPainter::held).map(this::place).toList(), Theme.faint(theme.series(band.style()), 0.2));
    }

    private void note(Mark.Note note) {
        TextStyle style = TextStyle.plain(11, theme.palette().text());
        drawing.text(note.name(), place(share(note.at())), style);
    }

    void map(Mark.Cells cells) {
        int rows = cells.rows().size();
        for (int row = 0; row < rows; row++) {
            List<Integer> classes = cells.rows().get(row);
            for (int column = 0; column < classes.size(); column++) {
                double left = (double) column / classes.size();
                double right = (column + 1.0) / classes.size();
                double low = (double) row / rows;
                double high = (row + 1.0) / rows;
                drawing.fill(List.of(plot.at(left, low), plot.at(right, low), plot.at(right, high), plot.at(left, high)),
                        theme.classes().get(classes.get(column)));
            }
        }
    }

    private Vec share(Vec value) {
        return new Vec(chart.x().share(value.x()), chart.y().share(value.y()));
    }

    private Vec place(Vec share) {
        return plot.at(share.x(), share.y());
    }

    private static boolean inside(Vec share) {
        return share.x() >= 0 && share.x() <= 1 && share.y() >= 0 && share.y() <= 1;
    }

    private static Vec held(Vec share) {
        return new Vec(Math.max(0, Math.min(1, share.x())), Math.max(0, Math.min(1, share.y())));
    }
}
