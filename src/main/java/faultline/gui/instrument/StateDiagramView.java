package faultline.gui.instrument;

import faultline.control.FollowerState;
import faultline.control.StateDiagram;
import faultline.control.StateDiagram.Arrow;
import faultline.engine.Frame;
import faultline.gui.text.StateText;
import faultline.gui.text.Texts;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;
import javax.swing.ToolTipManager;

/** The six-state diagram as it runs. What is under the mouse explains itself. */
public final class StateDiagramView extends JComponent {

    private static final int NONE_AT = 14;
    private static final Dimension LEAST = new Dimension(330, 150);
    private static final int NEAR = 10;

    private transient Optional<Frame> frame = Optional.empty();

    /** A diagram that shows nothing yet. */
    public StateDiagramView() {
        setMinimumSize(LEAST);
        setPreferredSize(LEAST);
        setOpaque(true);
        getAccessibleContext().setAccessibleName(Texts.text("diagram"));
        ToolTipManager.sharedInstance().registerComponent(this);
    }

    /**
     * Shows a newer frame.
     *
     * @param newest with the recording of its run
     */
    public void show(Frame newest) {
        assert EventQueue.isDispatchThread();
        boolean moved = frame.isEmpty() || frame.get().control().transitions() != newest.control().transitions()
                || !frame.get().control().state().equals(newest.control().state());
        frame = Optional.of(newest);
        if (moved) {
            getAccessibleContext().setAccessibleDescription(description(newest));
        }
        repaint();
    }

    private static String description(Frame newest) {
        return Texts.text("diagram.now", StateText.name(newest.control().state()))
                + DiagramPainter.lastTransition(newest).map(last -> ". " + DiagramPainter.sentence(last)).orElse("");
    }

    private static boolean isFollower(Frame shown) {
        return Arrays.stream(FollowerState.values()).anyMatch(state -> state.name().equals(shown.control().state()));
    }

    private double scale() {
        return TextSize.enlargement(getWidth(), getHeight(), LEAST);
    }

    private DiagramLayout layoutNow() {
        return new DiagramLayout(getWidth() / scale(), getHeight() / scale());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        Smooth.paint(graphics, g -> frame.ifPresent(shown -> {
            g.scale(scale(), scale());
            if (isFollower(shown)) {
                new DiagramPainter(g, layoutNow(), Theme.current(), shown).paint(getWidth() / scale(), getHeight() / scale());
            } else {
                paintNone(g, Texts.text("diagram.other", StateText.name(shown.control().state())));
            }
        }));
    }

    /** The parts of a sentence, one below the other: it is longer than a narrow window is wide. */
    private static void paintNone(Graphics2D g, String sentence) {
        String[] parts = sentence.split("(?<=;) ");
        g.setColor(Theme.now().muted());
        for (int i = 0; i < parts.length; i++) {
            g.drawString(parts[i], NONE_AT, NONE_AT + (i + 1) * g.getFontMetrics().getHeight());
        }
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        return StateDiagram.ARROWS.stream().filter(arrow -> isNear(arrow, event)).findFirst().map(this::explain)
                .orElseGet(() -> super.getToolTipText(event));
    }

    private boolean isNear(Arrow arrow, MouseEvent event) {
        return new BasicStroke(NEAR).createStrokedShape(layoutNow().route(arrow).shaft()).contains(event.getX() / scale(), event.getY() / scale());
    }

    private String explain(Arrow arrow) {
        long count = frame.map(shown -> shown.recording().states().count(arrow.from().name(), arrow.to().name())).orElse(0L);
        return Texts.text("diagram.arrow", StateText.name(arrow.from().name()), StateText.name(arrow.to().name()), StateText.condition(arrow),
                String.format(Locale.ROOT, "%d", count));
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
