package faultline.gui.instrument;

import faultline.engine.session.ReferenceRun;
import faultline.geometry.Vector2;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.paint.chart.LegendRows;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.TextStyle;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import javax.swing.JComponent;

/** The legend of a strip chart: one row or two beside the controls, or none if there is no room for all names. */
final class StripLegend extends JComponent {

    private static final int MAX_ROWS = 2;
    private static final int HEIGHT = 28;
    private static final int FONT_SIZE = 11;

    private transient SignalGroup signal = SignalGroup.NONE;
    private transient ReferenceRun reference;

    StripLegend() {
        RefreshSteps.add(this, legend -> legend.setFont(TextSize.scaledFont(Font.PLAIN, FONT_SIZE)));
    }

    void setSignal(SignalGroup newSignal) {
        signal = newSignal;
        refresh();
    }

    /** Sets the reference run whose lines are shown beside those of the run, null for none. */
    void setReference(ReferenceRun run) {
        reference = run;
        refresh();
    }

    private void refresh() {
        revalidate();
        repaint();
    }

    /** Returns whether there is room for the names of all lines. */
    boolean isComplete() {
        LegendRows<LegendEntry> rows = rows(room());
        return rows.rows().size() <= MAX_ROWS && rows.width() <= room();
    }

    private int room() {
        return getParent().getWidth() - getParent().getInsets().right - getX();
    }

    private LegendRows<LegendEntry> rows(double width) {
        return LegendEntry.rows(LegendEntry.of(signal, reference), this::textWidth, width);
    }

    private double textWidth(String name) {
        return getFontMetrics(getFont()).stringWidth(name);
    }

    @Override
    public Dimension getMaximumSize() {
        return new Dimension((int) Math.ceil(rows(Double.MAX_VALUE).width()), TextSize.scaled(HEIGHT));
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
        if (isComplete()) {
            TextStyle style = TextStyle.plain(
                    TextSize.scaled(FONT_SIZE), Theme.currentColours().text());
            LegendRows<LegendEntry> rows = rows(room());
            double rowHeight = (double) getHeight() / rows.rows().size();
            Antialiasing.paint(
                    graphics,
                    g -> LegendEntry.paint(
                            rows, new GraphicsSurface(g), Theme.current(), style, Vector2.ZERO, rowHeight));
        }
    }
}
