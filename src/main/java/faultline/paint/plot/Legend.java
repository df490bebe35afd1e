package faultline.paint.plot;

import faultline.geometry.Vec;
import java.util.ArrayList;
import java.util.List;

/** What the marks of a chart are called, in rows above its data. */
final class Legend {

    private static final double ROW = 16;
    private static final double SAMPLE = 26;
    private static final double GAP = 14;

    private final Theme theme;
    private final TextStyle style;
    private final List<Entry> entries = new ArrayList<>();
    private double across;
    private int row;

    /** A name, its sample, and where it stands. */
    private record Entry(String name, Mark mark, int index, double x, int row) {
    }

    Legend(List<Mark> marks, Theme theme, double width) {
        this.theme = theme;
        style = TextStyle.plain(11, theme.palette().text());
        for (Mark mark : marks) {
            if (mark instanceof Mark.Cells cells) {
                for (int i = 0; i < cells.names().size(); i++) {
                    add(cells.names().get(i), mark, i, width);
                }
            } else if (!(mark instanceof Mark.Note) && !mark.name().isEmpty()) {
                add(mark.name(), mark, 0, width);
            }
        }
    }

    private void add(String name, Mark mark, int index, double width) {
        double needed = SAMPLE + 5 + style.width(name);
        if (across > 0 && across + needed > width) {
            across = 0;
            row++;
        }
        entries.add(new Entry(name, mark, index, across, row));
        across += needed + GAP;
    }

    /** How much room it takes, pixels. */
    double height() {
        return entries.isEmpty() ? 0 : (row + 1) * ROW + 4;
    }

    void paint(Drawing drawing, double x, double y) {
        for (Entry entry : entries) {
            Vec left = new Vec(x + entry.x(), y + entry.row() * ROW + ROW / 2);
            sample(drawing, entry, left);
            drawing.text(entry.name(), left.plus(new Vec(SAMPLE + 5, 4)), style);
        }
    }

    private void sample(Drawing drawing, Entry entry, Vec left) {
        Vec right = left.plus(new Vec(SAMPLE, 0));
        if (entry.mark() instanceof Mark.Line line) {
            drawing.stroke(List.of(left, right), false, theme.linePen(line.style()));
        } else if (entry.mark() instanceof Mark.Points points) {
            Marker.paint(drawing, left.plus(new Vec(SAMPLE / 2, 0)), points.style(), theme);
        } else if (entry.mark() instanceof Mark.Band band) {
            drawing.fill(box(left), Theme.faint(theme.series(band.style()), 0.2));
        } else {
            drawing.fill(box(left), theme.classes().get(entry.index()));
            drawing.stroke(box(left), true, Pen.solid(theme.palette().text(), 0.6));
        }
    }

    private static List<Vec> box(Vec left) {
        return List.of(left.plus(new Vec(0, -5)), left.plus(new Vec(SAMPLE, -5)), left.plus(new Vec(SAMPLE, 5)), left.plus(new Vec(0, 5)));
    }
}
