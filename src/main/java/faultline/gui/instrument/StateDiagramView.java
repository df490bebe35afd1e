package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.FollowerState;
import faultline.control.ladder.FaultTolerantFollower;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.engine.ControllerFactory;
import faultline.engine.recording.StateTally;
import faultline.engine.session.SessionFrame;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.AccessibleComponent;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.RefreshSteps;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import faultline.paint.chart.StateDiagramLayout;
import faultline.paint.surface.PixelRectangle;
import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.font.LineBreakMeasurer;
import java.awt.font.TextAttribute;
import java.awt.font.TextLayout;
import java.text.AttributedString;
import java.util.Locale;
import java.util.stream.Collectors;
import javax.accessibility.AccessibleRole;
import javax.swing.ToolTipManager;

/** The live state diagram, with tool tips for its boxes and arrows. */
public final class StateDiagramView extends AccessibleComponent {

    private static final int MESSAGE_INSET = 14;
    private static final Dimension MIN_SIZE = new Dimension(330, 150);
    private static final int PICK_WIDTH = 10;

    /** Null before the first frame. */
    private transient SessionFrame frame;

    /** Creates an empty diagram. */
    public StateDiagramView() {
        super(AccessibleRole.SWING_COMPONENT);
        setMinimumSize(MIN_SIZE);
        setPreferredSize(MIN_SIZE);
        setOpaque(true);
        UiText.name(this, "diagram");
        RefreshSteps.add(this, StateDiagramView::describe);
        ToolTipManager.sharedInstance().registerComponent(this);
    }

    /** Shows a frame with the recording of its run. */
    public void setFrame(SessionFrame newest) {
        assert EventQueue.isDispatchThread();
        boolean moved = frame == null
                || frame.telemetry().transitions() != newest.telemetry().transitions()
                || !frame.telemetry().state().equals(newest.telemetry().state())
                || !frame.controllerName().equals(newest.controllerName())
                || frame.controller() != newest.controller()
                || (frame.snapshot().tick() == 0) != (newest.snapshot().tick() == 0);
        frame = newest;
        if (moved) {
            describe();
        }
        repaint();
    }

    private void describe() {
        if (frame != null) {
            getAccessibleContext().setAccessibleDescription(accessibleText(frame));
        }
    }

    private String accessibleText(SessionFrame newest) {
        boolean isForeign = !isFollower(newest) && !(newest.controller() instanceof ControllerSpec.BuiltIn);
        String now = isForeign
                ? foreignText(newest)
                : Messages.get("diagram.now", StateText.name(newest.telemetry().state()));
        return now
                + DiagramPainter.lastTransition(newest)
                        .map(last -> ". " + DiagramPainter.transitionText(last))
                        .orElse("")
                + (isFollower(newest) ? ". " + arrowTexts(newest.recording().stateTally()) : "");
    }

    /** Describes all arrows, whose conditions are otherwise in tool tips only. */
    private String arrowTexts(StateTally tally) {
        return DiagramPainter.arrows(tally).stream()
                .map(arrow -> arrowText(arrow, tally.transitionCount(arrow.from(), arrow.to())))
                .collect(Collectors.joining("; "));
    }

    /** Returns whether the wall follower drives, or has stopped because it has no strategy left. */
    private static boolean isFollower(SessionFrame shown) {
        ControllerState state = shown.telemetry().state();
        return state instanceof FollowerState || state.equals(FaultTolerantFollower.STOP);
    }

    /** Returns what is shown instead of the diagram. */
    static String otherText(SessionFrame shown) {
        if (!(shown.controller() instanceof ControllerSpec.BuiltIn)) {
            return foreignText(shown);
        }
        String kind =
                shown.controller() instanceof ControllerSpec.None ? "controller.kind.NONE" : "controller.kind.DRIVE";
        return Messages.get("diagram.foreign", Messages.get("diagram.controller.named", Messages.get(kind)));
    }

    private static String foreignText(SessionFrame shown) {
        String name = shown.controllerName();
        String who =
                name.isEmpty() ? Messages.get("diagram.controller") : Messages.get("diagram.controller.named", name);
        ControllerState state = shown.telemetry().state();
        if (shown.snapshot().tick() == 0) {
            return shown.controller() instanceof ControllerSpec.Extern
                    ? Messages.get("diagram.notChosen")
                    : Messages.get("diagram.undecided", who);
        }
        boolean namesState =
                !state.name().equals(name) && !state.equals(ControllerFactory.initialState(shown.controller()));
        return namesState
                ? Messages.get("diagram.foreign.state", who, StateText.name(state))
                : Messages.get("diagram.foreign", who);
    }

    private double scale() {
        return TextSize.imageScale(getWidth(), getHeight(), MIN_SIZE);
    }

    private StateDiagramLayout currentLayout() {
        return new StateDiagramLayout(new PixelRectangle(0, 0, getWidth() / scale(), getHeight() / scale()));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        graphics.setColor(Theme.current().palette().canvas());
        graphics.fillRect(0, 0, getWidth(), getHeight());
        if (frame != null) {
            Antialiasing.paint(graphics, this::paintFrame);
        }
    }

    private void paintFrame(Graphics2D g) {
        if (isFollower(frame)) {
            g.scale(scale(), scale());
            new DiagramPainter(g, currentLayout(), Theme.current(), frame)
                    .paint(getWidth() / scale(), getHeight() / scale());
        } else {
            paintMessage(g, otherText(frame));
        }
    }

    /** Draws a sentence in as many lines as the width needs. */
    private void paintMessage(Graphics2D g, String sentence) {
        AttributedString text = new AttributedString(sentence);
        text.addAttribute(TextAttribute.FONT, g.getFont());
        LineBreakMeasurer lines = new LineBreakMeasurer(text.getIterator(), g.getFontRenderContext());
        float width = Math.max(1, getWidth() - 2 * MESSAGE_INSET);
        g.setColor(Theme.currentColours().muted());
        float y = MESSAGE_INSET;
        while (lines.getPosition() < sentence.length()) {
            TextLayout line = lines.nextLayout(width);
            y += line.getAscent();
            line.draw(g, MESSAGE_INSET, y);
            y += line.getDescent() + line.getLeading();
        }
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        if (frame == null || !isFollower(frame)) {
            return super.getToolTipText(event);
        }
        StateTally tally = frame.recording().stateTally();
        return DiagramPainter.arrows(tally).stream()
                .filter(arrow -> isNear(arrow, event))
                .findFirst()
                .map(arrow -> arrowText(arrow, tally.transitionCount(arrow.from(), arrow.to())))
                .orElseGet(() -> super.getToolTipText(event));
    }

    private boolean isNear(Arrow arrow, MouseEvent event) {
        return new BasicStroke(PICK_WIDTH)
                .createStrokedShape(currentLayout().route(arrow).shaft())
                .contains(event.getX() / scale(), event.getY() / scale());
    }

    /** Describes a transition; the conditions are the wall follower's, which another controller does not have. */
    private String arrowText(Arrow arrow, long count) {
        String condition = frame.controller() instanceof ControllerSpec.BuiltIn ? arrow.condition() : "";
        return Messages.get(
                "diagram.arrow",
                StateText.transition(arrow.from(), arrow.to(), condition),
                String.format(Locale.ROOT, "%d", count));
    }
}
