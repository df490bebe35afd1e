package faultline.gui.instrument;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javax.swing.JComponent;

/** The legend of a strip chart: one row or two beside the controls, or none if there is no room for all names. */
final class StripLegend extends JComponent {

    private static final int SAMPLE_WIDTH = 26;
    private static final int GAP = 6;
    private static final int ENTRY_GAP = 16;
    private static final int MAX_ROWS = 2;
    private static final int HEIGHT = 28;

    private transient List<ChartLine> lines = List.of();

    StripLegend() {
        RefreshSteps.add(this, legend -> legend.setFont(TextSize.scaledFont(Font.PLAIN, 11)));
    }

    void setSignal(SignalGroup signal) {
        lines = signal.lines();
        revalidate();
        repaint();
    }

    /** Returns whether there is room for the names of all lines. */
    boolean isComplete() {
        return rowCount().isPresent();
    }

    /** Returns the number of rows that show all lines, empty if there is no room. */
    private OptionalInt rowCount() {
        return IntStream.rangeClosed(1, MAX_ROWS)
                .filter(rows -> width(rows) <= room())
                .findFirst();
    }

    private int room() {
        return getParent().getWidth() - getX();
    }

    /** Returns the width of the legend in a number of rows; the lines are numbered from the front, column by column. */
    private int width(int rows) {
        int width = -ENTRY_GAP;
        for (int first = 0; first < lines.size(); first += rows) {
            width += columnWidth(first, rows) + ENTRY_GAP;
        }
        return width;
    }

    private int columnWidth(int first, int rows) {
        return IntStream.range(first, Math.min(first + rows, lines.size()))
                .map(i -> width(fromFront(i)))
                .max()
                .orElse(0);
    }

    private ChartLine fromFront(int index) {
        return lines.get(lines.size() - 1 - index);
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension(Math.max(0, width(1)), TextSize.scaled(HEIGHT));
    }

    private int width(ChartLine curve) {
        return SAMPLE_WIDTH + GAP + getFontMetrics(getFont()).stringWidth(curve.name());
    }

    /** Returns no width: the legend gets the room that the controls leave. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, TextSize.scaled(HEIGHT));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Antialiasing.paint(graphics, g -> {
            g.setFont(getFont());
            rowCount().ifPresent(rows -> paint(g, rows));
        });
    }

    private void paint(Graphics2D g, int rows) {
        double x = 0;
        double rowHeight = (double) getHeight() / rows;
        for (int first = 0; first < lines.size(); first += rows) {
            for (int i = first; i < Math.min(first + rows, lines.size()); i++) {
                paint(g, fromFront(i), x, (i - first + 0.5) * rowHeight);
            }
            x += columnWidth(first, rows) + ENTRY_GAP;
        }
    }

    private void paint(Graphics2D g, ChartLine curve, double x, double middle) {
        g.setColor(curve.colour().apply(Theme.current()));
        g.setStroke(curve.style(Theme.current()).stroke());
        g.draw(new Line2D.Double(x, middle, x + SAMPLE_WIDTH, middle));
        g.setColor(Theme.currentColours().text());
        g.drawString(curve.name(), (float) (x + SAMPLE_WIDTH + GAP), (float)
                (middle + g.getFontMetrics().getAscent() / 2.0 - 2));
    }
}
