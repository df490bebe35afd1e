package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.ladder.Rung;
import faultline.control.wallfollower.StateDiagram;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.engine.ControllerFactory;
import faultline.engine.recording.EventLog;
import faultline.engine.recording.RunEvent;
import faultline.engine.recording.StateTally;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Vector2;
import faultline.gui.text.HealthText;
import faultline.gui.text.Messages;
import faultline.gui.text.StateText;
import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.Theme;
import faultline.gui.theme.ThemeColours;
import faultline.paint.chart.StateDiagramLayout;
import faultline.paint.surface.DashPattern;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.ShortenedText;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Paints the state diagram. The current state is filled and bold; the last transition is a thick arrow and is described
 * below the diagram.
 */
final class DiagramPainter {

    private static final Font NAME_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
    private static final Font SMALL_FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final double MIN_FONT_SIZE = 8;
    private static final double FONT_STEP = 0.25;
    /** The height of a box that has room for a second line. */
    private static final double TWO_LINES = 31;

    private static final double TEXT_MARGIN = 8;
    private static final double ARROWHEAD_SIZE = 8;
    private static final double DIGIT_HEIGHT = 8;
    /** The width of the other arrows as a share of that of the wall follower's own. */
    private static final double OTHER_WIDTH = 0.75;

    private final Graphics2D g;
    private final ThemeColours colours;
    private final StateDiagramLayout layout;
    private final SessionFrame frame;
    private final StateTally tally;

    DiagramPainter(Graphics2D g, StateDiagramLayout layout, Theme theme, SessionFrame frame) {
        this.g = g;
        this.layout = layout;
        this.colours = theme.colours();
        this.frame = frame;
        this.tally = frame.recording().stateTally();
    }

    void paint(double width, double height) {
        Optional<RunEvent.StateChanged> last = lastTransition(frame);
        Predicate<Arrow> isLast =
                arrow -> last.filter(transition -> connects(arrow, transition)).isPresent();
        List<Arrow> arrows = arrows(tally);
        arrows.stream().filter(isLast.negate()).forEach(arrow -> paintArrow(arrow, false));
        arrows.stream().filter(isLast).forEach(arrow -> paintArrow(arrow, true));
        for (FollowerState state : FollowerState.values()) {
            paintState(state);
        }
        Font bold = SMALL_FONT.deriveFont(Font.BOLD);
        drawFitted(
                caption(frame, last.orElse(null), width, g.getFontMetrics(bold)),
                new Vector2(width / 2, height - Math.min(9, 9 * height / 150)),
                width - TEXT_MARGIN,
                bold,
                last.isPresent() ? colours.accent() : colours.muted());
    }

    /**
     * Returns the transitions of the wall follower, and those that a run has taken besides, such as the ones of its
     * other strategies, which have no condition.
     */
    static List<Arrow> arrows(StateTally tally) {
        Stream<Arrow> others = tally.transitions().stream()
                .filter(taken -> StateDiagram.TRANSITIONS.stream()
                        .noneMatch(arrow -> arrow.from() == taken.from() && arrow.to() == taken.to()))
                .filter(taken -> !taken.from().equals(taken.to()))
                .flatMap(taken -> taken.from() instanceof FollowerState from && taken.to() instanceof FollowerState to
                        ? Stream.of(new Arrow(from, to, ""))
                        : Stream.empty());
        return Stream.concat(StateDiagram.TRANSITIONS.stream(), others).toList();
    }

    /**
     * Returns the text below a diagram of a width, pixels: the name of the controller, the strategy, and the last
     * transition, null for none.
     */
    static String caption(SessionFrame frame, RunEvent.StateChanged last, double width, FontMetrics metrics) {
        String before = nameText(frame, width / 3, metrics) + strategyText(frame);
        double room = width - TEXT_MARGIN - metrics.stringWidth(before);
        return before + (last == null ? Messages.get("diagram.none") : transitionText(last, room, metrics));
    }

    /** Returns the name that the controller gives itself, if it does, shortened to a width in pixels. */
    private static String nameText(SessionFrame frame, double room, FontMetrics metrics) {
        String name = frame.controllerName();
        return name.isEmpty() ? "" : ShortenedText.of(name, metrics, room) + " · ";
    }

    /** Returns which strategy of the ladder drives, if it is not the first one, before the last transition. */
    static String strategyText(SessionFrame frame) {
        String rung = frame.telemetry().diagnosis().rung();
        return rung.isEmpty() || rung.equals(Rung.ALL.name()) ? "" : HealthText.rungPosition(rung) + " · ";
    }

    /**
     * Returns the description of the last transition, or its condition alone, if any, if the full text does not fit.
     */
    private static String transitionText(RunEvent.StateChanged last, double room, FontMetrics metrics) {
        String whole = transitionText(last);
        String condition = conditionText(last);
        return condition.isEmpty() || metrics.stringWidth(whole) <= room ? whole : condition;
    }

    /** Returns the newest transition that is still in the log; none is the first state of a controller from outside. */
    static Optional<RunEvent.StateChanged> lastTransition(SessionFrame frame) {
        EventLog log = frame.recording().events();
        for (long i = log.endIndex() - 1; i >= log.firstIndex(); i--) {
            if (log.get(i) instanceof RunEvent.StateChanged transition) {
                return Optional.of(transition).filter(found -> !isFirstState(found, frame.controller()));
            }
        }
        return Optional.empty();
    }

    private static boolean isFirstState(RunEvent.StateChanged found, ControllerSpec controller) {
        return !(controller instanceof ControllerSpec.BuiltIn)
                && found.from().equals(ControllerFactory.initialState(controller));
    }

    static String transitionText(RunEvent.StateChanged last) {
        return StateText.transition(last.from(), last.to(), last.condition());
    }

    private static String conditionText(RunEvent.StateChanged last) {
        return StateText.condition(last.from(), last.to(), last.condition());
    }

    private static boolean connects(Arrow arrow, RunEvent.StateChanged transition) {
        return arrow.from() == transition.from() && arrow.to() == transition.to();
    }

    private void paintArrow(Arrow arrow, boolean lit) {
        StateDiagramLayout.ArrowRoute route = layout.route(arrow);
        route.paint(new GraphicsSurface(g), style(arrow, lit), lit ? ARROWHEAD_SIZE * 1.4 : ARROWHEAD_SIZE);
        long count = tally.transitionCount(arrow.from(), arrow.to());
        if (count > 0) {
            String number = Long.toString(count);
            Font font = lit ? SMALL_FONT.deriveFont(Font.BOLD) : SMALL_FONT;
            Vector2 centre = route.numberCentre(g.getFontMetrics(font).stringWidth(number), DIGIT_HEIGHT);
            drawCentred(
                    number, centre.x(), centre.y() + DIGIT_HEIGHT / 2, font, lit ? colours.accent() : colours.muted());
        }
    }

    /** Returns the style of an arrow; one that is not the wall follower's own is dashed. */
    private LineStyle style(Arrow arrow, boolean lit) {
        boolean own = StateDiagram.TRANSITIONS.contains(arrow);
        Color colour = lit ? colours.accent() : colours.border();
        double width = (lit ? 3 : 1.3) * (own ? 1 : OTHER_WIDTH);
        return new LineStyle(colour, width, own ? DashPattern.SOLID : DashPattern.DASHED);
    }

    private void paintState(FollowerState state) {
        boolean active = state == frame.telemetry().state();
        Rectangle2D box = layout.box(state);
        g.setColor(active ? colours.accent() : colours.field());
        g.fill(Antialiasing.roundedRectangle(box.getX(), box.getY(), box.getWidth(), box.getHeight()));
        g.setColor(active ? colours.text() : colours.border());
        g.setStroke(DrawContext.solidStroke(active ? 2.5 : 1));
        g.draw(Antialiasing.roundedRectangle(box.getX(), box.getY(), box.getWidth(), box.getHeight()));
        double middle = box.getCenterY();
        boolean visitsFit = box.getHeight() >= TWO_LINES;
        String name = StateText.name(state);
        drawFitted(
                name,
                new Vector2(box.getCenterX(), visitsFit ? middle - 2 : middle + 5),
                box.getWidth() - 4,
                active ? boldIfFitting(name, NAME_FONT, box.getWidth() - 4, g::getFontMetrics) : NAME_FONT,
                active ? colours.onAccent() : colours.text());
        if (visitsFit) {
            drawFitted(
                    visitText(state),
                    new Vector2(box.getCenterX(), middle + 13),
                    box.getWidth() - 4,
                    SMALL_FONT,
                    active ? colours.onAccent() : colours.muted());
        }
    }

    /** Returns the total duration and the number of visits of a state, or a dash if there are none. */
    private String visitText(FollowerState state) {
        return tally.visitsTo(state)
                .map(interval ->
                        String.format(Locale.ROOT, "%.1f s · %d×", interval.ticks() * frame.dt(), interval.visits()))
                .orElse("–");
    }

    /** Draws a text, in a smaller font if the width is too small, and shortened if it is too small for the smallest. */
    private void drawFitted(String text, Vector2 foot, double room, Font font, Color colour) {
        boolean fits = g.getFontMetrics(font).stringWidth(text) <= room;
        // Whole pixels would place the letters of a smaller font unevenly.
        g.setRenderingHint(
                RenderingHints.KEY_FRACTIONALMETRICS,
                fits ? RenderingHints.VALUE_FRACTIONALMETRICS_DEFAULT : RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        Font fitted = fitted(text, font, room, g::getFontMetrics);
        drawCentred(ShortenedText.of(text, g.getFontMetrics(fitted), room), foot.x(), foot.y(), fitted, colour);
    }

    /** Returns the bold version of a font, or the font itself if a bold text is too wide even in the smallest size. */
    static Font boldIfFitting(String text, Font font, double room, Function<Font, FontMetrics> metrics) {
        Font bold = font.deriveFont(Font.BOLD);
        return metrics.apply(fitted(text, bold, room, metrics)).stringWidth(text) <= room ? bold : font;
    }

    /** Returns the largest font up to a given one in which a text has the room, pixels, or else the smallest font. */
    static Font fitted(String text, Font font, double room, Function<Font, FontMetrics> metrics) {
        double share = Math.min(1, room / metrics.apply(font).stringWidth(text));
        Font result = font.deriveFont((float) Math.max(MIN_FONT_SIZE, font.getSize2D() * share));
        // The width of a text is not exactly in proportion to the size of its font.
        while (metrics.apply(result).stringWidth(text) > room && result.getSize2D() > MIN_FONT_SIZE) {
            result = result.deriveFont((float) Math.max(MIN_FONT_SIZE, result.getSize2D() - FONT_STEP));
        }
        return result;
    }

    private void drawCentred(String text, double x, double baseLine, Font font, Color colour) {
        g.setFont(font);
        g.setColor(colour);
        g.drawString(text, (float) (x - g.getFontMetrics().stringWidth(text) / 2.0), (float) baseLine);
    }
}
