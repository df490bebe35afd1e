package faultline.gui.instrument;

import faultline.engine.Frame;
import faultline.gui.text.Texts;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;

/** The paper's eq. (4) at work: the newest spin past a wall, its frames F3 and F4, t_D and t_p, and how well the heading came out. */
public final class TimingInstrument extends JComponent {

    private static final Dimension LEAST = new Dimension(560, 150);
    private static final int LEFT = 50;
    private static final int TOP = 30;
    private static final int BOTTOM = 34;
    private static final int GAP = 24;
    private static final int NUMBERS = 210;
    private static final int VALUE = 140;
    private static final int ROW = 20;

    private transient Optional<Spin> spin = Optional.empty();

    /** An instrument that shows nothing yet. */
    public TimingInstrument() {
        setMinimumSize(LEAST);
        setPreferredSize(LEAST);
        setOpaque(true);
        setToolTipText(Texts.text("spin.tip"));
        getAccessibleContext().setAccessibleName(Texts.text("spin"));
    }

    /**
     * Shows a newer frame.
     *
     * @param frame with the recording of its run
     */
    public void show(Frame frame) {
        assert EventQueue.isDispatchThread();
        spin = Spin.latest(frame);
        String words = words();
        if (!words.equals(getAccessibleContext().getAccessibleDescription())) {
            getAccessibleContext().setAccessibleDescription(words);
        }
        repaint();
    }

    /** All numbers. */
    private String words() {
        return rows().stream().map(row -> row.name() + " " + row.value()).collect(Collectors.joining(", "));
    }

    List<SpinText.Row> rows() {
        return spin.map(SpinText::rows).orElse(List.of());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        double scale = TextSize.enlargement(getWidth(), getHeight(), LEAST);
        Smooth.paint(graphics, g -> {
            g.scale(scale, scale);
            spin.ifPresentOrElse(shown -> paint(g, shown, getWidth() / scale, getHeight() / scale), () -> paintNone(g));
        });
    }

    private void paintNone(Graphics2D g) {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        g.setColor(Theme.now().muted());
        g.drawString(Texts.text("spin.none"), 16, 28);
    }

    private void paint(Graphics2D g, Spin shown, double width, double height) {
        double radius = Math.min(90, height / 2 - 16);
        double numbers = width - NUMBERS;
        double dial = numbers - GAP - radius;
        Rectangle2D plot = new Rectangle2D.Double(LEFT, TOP, Math.max(1, dial - radius - GAP - LEFT), Math.max(1, height - TOP - BOTTOM));
        new SpinChart(g, Theme.current(), shown, plot).paint();
        new SpinDial(g, Theme.current(), dial, height / 2, radius).paint(shown);
        paintNumbers(g, numbers, height);
    }

    private void paintNumbers(Graphics2D g, double x, double height) {
        List<SpinText.Row> rows = rows();
        double row = Math.min(ROW, (height - 16) / rows.size());
        for (int i = 0; i < rows.size(); i++) {
            float y = (float) (height / 2 + (i + 0.75 - rows.size() / 2.0) * row);
            boolean last = i == rows.size() - 1;
            g.setFont(new Font(Font.SANS_SERIF, last ? Font.BOLD : Font.PLAIN, 12));
            g.setColor(last ? Theme.now().text() : Theme.now().muted());
            g.drawString(rows.get(i).name(), (float) x, y);
            g.setColor(Theme.now().text());
            g.drawString(rows.get(i).value(), (float) (x + VALUE - g.getFontMetrics().stringWidth(rows.get(i).value()) + 50), y);
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
            };
        }
        return accessibleContext;
    }
}
