package faultline.gui.instrument;

import faultline.control.FollowerState;
import faultline.control.StateDiagram;
import faultline.control.StateDiagram.Arrow;
import faultline.engine.Frame;
import faultline.engine.record.EventLog;
import faultline.engine.record.RunEvent;
import faultline.engine.record.StateTally;
import faultline.geometry.Vec;
import faultline.gui.text.StateText;
import faultline.gui.text.Texts;
import faultline.gui.theme.Smooth;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import java.util.Optional;

/** Paints the state diagram: the state that holds is filled and bold, the arrow taken last is thick and named below. */
final class DiagramPainter {

    private static final Font NAME = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
    private static final Font SMALL = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final double LEAST_LETTERS = 8;
    private static final double SIDES = 8;
    private static final double HEAD = 8;

    private final Graphics2D g;
    private final ThemeColours colours;
    private final DiagramLayout layout;
    private final Frame frame;
    private final StateTally tally;
    private final double dt;

    DiagramPainter(Graphics2D g, DiagramLayout layout, Theme theme, Frame frame) {
        this.g = g;
        this.layout = layout;
        this.colours = theme.colours();
        this.frame = frame;
        this.tally = frame.recording().states();
        this.dt = frame.world().tick() > 0 ? frame.world().time() / frame.world().tick() : 0;
    }

    void paint(double width, double height) {
        Optional<RunEvent.Transition> last = lastTransition(frame);
        StateDiagram.ARROWS.stream().filter(arrow -> !isLast(arrow, last)).forEach(arrow -> arrow(arrow, false));
        StateDiagram.ARROWS.stream().filter(arrow -> isLast(arrow, last)).forEach(arrow -> arrow(arrow, true));
        for (FollowerState state : FollowerState.values()) {
            state(state);
        }
        Font bold = SMALL.deriveFont(Font.BOLD);
        fitted(last.map(transition -> sentence(transition, width - SIDES, bold)).orElseGet(() -> Texts.text("diagram.none")),
                new Vec(width / 2, height - 9), width - SIDES, bold, last.isPresent() ? colours.accent() : colours.muted());
    }

    /** Where all of it does not fit, the condition alone: the arrow that is thick says the rest. */
    private String sentence(RunEvent.Transition last, double room, Font font) {
        String whole = sentence(last);
        return g.getFontMetrics(font).stringWidth(whole) <= room ? whole : condition(last);
    }

    /** The newest transition that the log still has. */
    static Optional<RunEvent.Transition> lastTransition(Frame frame) {
        EventLog log = frame.recording().events();
        for (long i = log.end() - 1; i >= log.first(); i--) {
            if (log.get(i) instanceof RunEvent.Transition transition) {
                return Optional.of(transition);
            }
        }
        return Optional.empty();
    }

    static String sentence(RunEvent.Transition last) {
        return Texts.text("diagram.last", StateText.name(last.from()), StateText.name(last.to()), condition(last));
    }

    private static String condition(RunEvent.Transition last) {
        return StateText.condition(last.from(), last.to(), last.condition());
    }

    private static boolean isLast(Arrow arrow, Optional<RunEvent.Transition> last) {
        return last.isPresent() && arrow.from().name().equals(last.get().from()) && arrow.to().name().equals(last.get().to());
    }

    private void arrow(Arrow arrow, boolean lit) {
        DiagramLayout.Route route = layout.route(arrow);
        Color colour = lit ? colours.accent() : colours.border();
        g.setColor(colour);
        g.setStroke(Smooth.line(lit ? 3 : 1.3));
        g.draw(route.shaft());
        g.fill(head(route, lit ? HEAD * 1.4 : HEAD));
        long count = tally.count(arrow.from().name(), arrow.to().name());
        if (count > 0) {
            centred(Long.toString(count), route.middle().x(), route.middle().y() + 4, lit ? SMALL.deriveFont(Font.BOLD) : SMALL,
                    lit ? colours.accent() : colours.muted());
        }
    }

    private static Path2D head(DiagramLayout.Route route, double size) {
        double x = route.tip().x();
        double y = route.tip().y();
        double dx = route.direction().x() * size;
        double dy = route.direction().y() * size;
        Path2D head = new Path2D.Double();
        head.moveTo(x, y);
        head.lineTo(x - dx - dy / 2, y - dy + dx / 2);
        head.lineTo(x - dx + dy / 2, y - dy - dx / 2);
        head.closePath();
        return head;
    }

    private void state(FollowerState state) {
        boolean active = state.name().equals(frame.control().state());
        Rectangle2D box = layout.box(state);
        g.setColor(active ? colours.accent() : colours.field());
        g.fill(Smooth.box(box.getX(), box.getY(), box.getWidth(), box.getHeight()));
        g.setColor(active ? colours.text() : colours.border());
        g.setStroke(Smooth.line(active ? 2.5 : 1));
        g.draw(Smooth.box(box.getX(), box.getY(), box.getWidth(), box.getHeight()));
        double middle = box.getCenterY();
        fitted(StateText.name(state.name()), new Vec(box.getCenterX(), middle - 2), box.getWidth() - 4, active ? NAME.deriveFont(Font.BOLD) : NAME,
                active ? colours.onAccent() : colours.text());
        fitted(stay(state), new Vec(box.getCenterX(), middle + 13), box.getWidth() - 4, SMALL, active ? colours.onAccent() : colours.muted());
    }

    /** How long and how often; a dash where never. */
    private String stay(FollowerState state) {
        return tally.stay(state.name()).map(stay -> String.format(Locale.ROOT, "%.1f s · %d×", stay.ticks() * dt, stay.visits())).orElse("–");
    }

    /** In smaller letters where the room is short. */
    private void fitted(String text, Vec foot, double room, Font font, Color colour) {
        double share = Math.min(1, room / g.getFontMetrics(font).stringWidth(text));
        centred(text, foot.x(), foot.y(), font.deriveFont((float) Math.max(LEAST_LETTERS, font.getSize2D() * share)), colour);
    }

    private void centred(String text, double x, double baseLine, Font font, Color colour) {
        g.setFont(font);
        g.setColor(colour);
        g.drawString(text, (float) (x - g.getFontMetrics().stringWidth(text) / 2.0), (float) baseLine);
    }
}
