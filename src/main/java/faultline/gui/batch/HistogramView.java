package faultline.gui.batch;

import faultline.campaign.report.LowerQuantile;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.NamedChoice;
import faultline.gui.text.Messages;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.paint.chart.Chart;
import faultline.paint.chart.ChartPainter;
import faultline.paint.chart.Histogram;
import faultline.paint.surface.ChartStyle;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.PixelRectangle;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Graphics;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.function.Function;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** A histogram of a number of the runs, with a choice of the number and its median and range in words. */
final class HistogramView extends JPanel {

    private static final Dimension MIN_SIZE = new Dimension(420, 260);
    private static final MathContext THREE_DIGITS = new MathContext(3);

    private final NamedChoice<HistogramQuantity> choice = new NamedChoice<>(
            HistogramQuantity.values(),
            quantity -> Messages.get("batch.quantity." + quantity),
            ignored -> showChosen());
    private final JLabel summary = new JLabel(" ");
    private final HistogramPlot canvas = new HistogramPlot();
    private final transient Function<HistogramQuantity, double[]> values;
    private boolean outdated;

    /** A number of a run. */
    enum HistogramQuantity {
        COVERAGE("coverage", 1),
        DISTANCE_RMS("distance_rms_m", 1000),
        FOLLOW_RMS("follow_rms_m", 1000);

        private final String column;
        private final double scale;

        HistogramQuantity(String column, double scale) {
            this.column = column;
            this.scale = scale;
        }

        /** Returns its column in {@code runs.csv}. */
        String column() {
            return column;
        }
    }

    /** Creates a view; the function returns the values of a number, of those runs that have it. */
    HistogramView(Function<HistogramQuantity, double[]> values) {
        super(new BorderLayout(0, 6));
        this.values = values;
        setBorder(BorderFactory.createEmptyBorder(8, 8, 0, 8));
        UiText.name(choice, "batch.quantity");
        RefreshSteps.add(canvas, self -> update());
        addHierarchyListener(event -> {
            if (outdated && isShowing()) {
                showChosen();
            }
        });
        JPanel heading = new JPanel(new FlowLayout(FlowLayout.LEADING, 8, 0));
        heading.add(FormConstraints.label("batch.quantity", choice));
        heading.add(choice);
        summary.setBorder(BorderFactory.createEmptyBorder(4, 8, 0, 8));
        JPanel texts = new JPanel(new BorderLayout());
        texts.add(heading, BorderLayout.NORTH);
        texts.add(summary, BorderLayout.SOUTH);
        add(texts, BorderLayout.NORTH);
        add(canvas, BorderLayout.CENTER);
    }

    /** Updates the histogram, now or when the view becomes visible. */
    void update() {
        outdated = true;
        if (isShowing()) {
            showChosen();
        }
    }

    private void showChosen() {
        outdated = false;
        HistogramQuantity quantity = choice.value();
        double[] found = Arrays.stream(values.apply(quantity))
                .map(value -> value * quantity.scale)
                .toArray();
        summary.setText(
                found.length == 0
                        ? Messages.get("batch.histogram.none")
                        : Messages.get(
                                "batch.histogram.summary",
                                Integer.toString(found.length),
                                quantile(found, 0.5),
                                quantile(found, 0),
                                quantile(found, 1)));
        String name = Messages.get("batch.quantity." + quantity);
        canvas.chart = found.length == 0 ? null : Histogram.chart("", name, Messages.get("batch.runs"), found);
        canvas.getAccessibleContext().setAccessibleName(name + ": " + summary.getText());
        canvas.repaint();
    }

    private static String quantile(double[] found, double share) {
        double value = LowerQuantile.of(found, share).orElseThrow();
        return new BigDecimal(value).round(THREE_DIGITS).toPlainString();
    }

    /** Paints the chart. */
    private static final class HistogramPlot extends AccessibleComponent {
        private transient Chart chart;

        HistogramPlot() {
            super(AccessibleRole.SWING_COMPONENT);
            setPreferredSize(MIN_SIZE);
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            graphics.setColor(Theme.current().palette().canvas());
            graphics.fillRect(0, 0, getWidth(), getHeight());
            double scale = TextSize.imageScale(getWidth(), getHeight(), MIN_SIZE);
            if (chart != null) {
                Antialiasing.paint(graphics, g -> {
                    g.scale(scale, scale);
                    ChartStyle style = Theme.current() == Theme.DARK ? ChartStyle.DARK : ChartStyle.LIGHT;
                    PixelRectangle area = new PixelRectangle(0, 0, getWidth() / scale, getHeight() / scale);
                    ChartPainter.paint(new GraphicsSurface(g), chart, area, style);
                });
            }
        }
    }
}
