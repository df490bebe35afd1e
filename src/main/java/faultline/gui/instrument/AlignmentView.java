package faultline.gui.instrument;

import faultline.control.TimingRule;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.PixelRectangle;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.List;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;

/**
 * Shows eq. (4) of the paper: the newest turn past a wall with its frames F3 and F4, t_D and t_p, and the error of the
 * resulting heading.
 */
public final class AlignmentView extends AccessibleComponent {

    private static final Dimension MIN_SIZE = new Dimension(560, 150);
    private static final int LEFT_MARGIN = 50;
    private static final int TOP_MARGIN = 30;
    private static final int BOTTOM_MARGIN = 34;
    private static final int GAP = 24;
    private static final int NUMBERS_WIDTH = 210;
    /** The distance from the left end of the names to the right end of the values. */
    static final int VALUE_END = 190;

    private static final int ROW_HEIGHT = 20;

    /** The index of the sensor on the side of the wall, -1 if there is none of this name. */
    private int sensor = -1;
    /** The rule that the tool tip explains. */
    private TimingRule timingRule = TimingRule.EQUAL_READINGS;
    /** Null if there is no manoeuvre. */
    private transient AlignmentTrace trace;

    /** Creates an empty view. */
    public AlignmentView() {
        super(AccessibleRole.SWING_COMPONENT);
        setMinimumSize(MIN_SIZE);
        setPreferredSize(MIN_SIZE);
        setOpaque(true);
        UiText.name(this, "spin");
        RefreshSteps.add(this, AlignmentView::refresh);
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame frame) {
        assert EventQueue.isDispatchThread();
        trace = AlignmentTrace.latest(frame).orElse(null);
        if (trace != null) {
            sensor = frame.snapshot().robot().indexOf(trace.wallSide().fileName());
        }
        TimingRule rule = trace == null ? AlignmentTrace.presentRule(frame) : trace.rule();
        if (rule != timingRule) {
            timingRule = rule;
            refresh();
        }
        updateAccessibleText();
        repaint();
    }

    /** Describes all values in words. */
    private void updateAccessibleText() {
        String words =
                rows().stream().map(row -> row.name() + " " + row.value()).collect(Collectors.joining(", "));
        if (!words.equals(getAccessibleContext().getAccessibleDescription())) {
            getAccessibleContext().setAccessibleDescription(words);
        }
    }

    List<AlignmentText.NamedValue> rows() {
        return trace == null ? List.of() : AlignmentText.rows(trace);
    }

    private void refresh() {
        setToolTipText(Messages.get("spin.tip") + " " + Messages.get("spin.rule.tip." + timingRule.fileName()));
        updateAccessibleText();
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        double scale = TextSize.imageScale(getWidth(), getHeight(), MIN_SIZE);
        Antialiasing.paint(graphics, g -> {
            g.scale(scale, scale);
            if (trace == null) {
                paintMessage(g);
            } else {
                paint(g, trace, getWidth() / scale, getHeight() / scale);
            }
        });
    }

    private void paintMessage(Graphics2D g) {
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        g.setColor(Theme.currentColours().muted());
        g.drawString(Messages.get("spin.none"), 16, 28);
    }

    private void paint(Graphics2D g, AlignmentTrace shown, double width, double height) {
        double radius = Math.min(90, height / 2 - 16);
        double numbers = width - NUMBERS_WIDTH;
        double dial = numbers - GAP - radius;
        PixelRectangle plot = new PixelRectangle(
                LEFT_MARGIN,
                TOP_MARGIN,
                Math.max(1, dial - radius - GAP - LEFT_MARGIN),
                Math.max(1, height - TOP_MARGIN - BOTTOM_MARGIN));
        new AlignmentChart(new GraphicsSurface(g), Theme.current(), shown, sensor, plot).paint();
        new AlignmentDial(g, Theme.current(), dial, height / 2, radius).paint(shown);
        paintNumbers(g, numbers, height);
    }

    private void paintNumbers(Graphics2D g, double x, double height) {
        List<AlignmentText.NamedValue> rows = rows();
        double row = Math.min(ROW_HEIGHT, (height - 16) / rows.size());
        for (int i = 0; i < rows.size(); i++) {
            float y = (float) (height / 2 + (i + 0.75 - rows.size() / 2.0) * row);
            boolean last = i == rows.size() - 1;
            g.setFont(new Font(Font.SANS_SERIF, last ? Font.BOLD : Font.PLAIN, 12));
            g.setColor(
                    last
                            ? Theme.currentColours().text()
                            : Theme.currentColours().muted());
            g.drawString(rows.get(i).name(), (float) x, y);
            g.setColor(Theme.currentColours().text());
            g.drawString(
                    rows.get(i).value(),
                    (float) (x
                            + VALUE_END
                            - g.getFontMetrics().stringWidth(rows.get(i).value())),
                    y);
        }
    }
}
