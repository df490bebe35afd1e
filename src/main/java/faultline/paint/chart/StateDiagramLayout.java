package faultline.paint.chart;

import static faultline.control.FollowerState.ALIGN;
import static faultline.control.FollowerState.FOLLOW;
import static faultline.control.FollowerState.MEASURE;
import static faultline.control.FollowerState.ROUND;
import static faultline.control.FollowerState.SEARCH;
import static faultline.control.FollowerState.TURN;

import faultline.control.FollowerState;
import faultline.control.wallfollower.StateDiagram.Arrow;
import faultline.geometry.Vector2;
import faultline.paint.surface.LineStyle;
import faultline.paint.surface.PixelRectangle;
import faultline.paint.surface.Shapes;
import faultline.paint.surface.Surface;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * The positions of the boxes and arrows of the state diagram, pixels: two rows of three, in which the usual sequence of
 * states runs clockwise.
 */
public final class StateDiagramLayout {

    private static final List<List<FollowerState>> ROWS =
            List.of(List.of(SEARCH, TURN, MEASURE), List.of(ROUND, FOLLOW, ALIGN));
    /** The width below which the margins and the gaps between the columns shrink, and that of the smallest ones. */
    private static final double FULL_WIDTH = 330;

    private static final double SMALL_WIDTH = 150;
    private static final double SMALL_SIDE_MARGIN = 4;
    private static final double SMALL_COLUMN_GAP_SHARE = 0.15;
    private static final double SIDE_MARGIN = 14;
    private static final double TOP_MARGIN = 30;
    private static final double BOTTOM_MARGIN = 30;

    /** The height below which the margins and the gaps between the rows shrink, and that of the smallest ones. */
    private static final double FULL_HEIGHT = 150;

    private static final double SMALL_HEIGHT = 100;
    private static final double SMALL_TOP_MARGIN = 25;
    private static final double SMALL_BOTTOM_MARGIN = 18;
    private static final double SMALL_GAP_SHARE = 0.16;
    private static final double MAX_BOX_WIDTH = 132;
    private static final double MAX_BOX_HEIGHT = 46;
    private static final double GAP_SHARE = 0.3;

    /** Offset of two opposite arrows between the same boxes from the centre line, pixels. */
    private static final double LANE_OFFSET = 7;

    /** The least distance of a number from its line, pixels. */
    private static final double NUMBER_GAP = 2;

    /** Where arrows between the rows start and end, from the centre of a box, as a share of its width. */
    private static final double START_SHARE = 0.15;

    private static final double END_SHARE = 0.35;

    /** Height above the boxes of the arrow that spans a row, pixels. */
    private static final double ARCH_HEIGHT = 22;

    private final PixelRectangle area;
    private final double sideMargin;
    private final double topMargin;
    private final double bottomMargin;
    private final double boxWidth;
    private final double boxHeight;

    /** Creates the layout that fills an area. */
    public StateDiagramLayout(PixelRectangle area) {
        this.area = area;
        double width = (area.width() - SMALL_WIDTH) / (FULL_WIDTH - SMALL_WIDTH);
        sideMargin = between(SMALL_SIDE_MARGIN, SIDE_MARGIN, width);
        double gapShare = between(SMALL_COLUMN_GAP_SHARE, GAP_SHARE, width);
        boxWidth = Math.min(MAX_BOX_WIDTH, (area.width() - 2 * sideMargin) / 3 * (1 - gapShare));
        topMargin = shrunk(SMALL_TOP_MARGIN, TOP_MARGIN);
        bottomMargin = shrunk(SMALL_BOTTOM_MARGIN, BOTTOM_MARGIN);
        boxHeight = Math.min(
                MAX_BOX_HEIGHT,
                (area.height() - topMargin - bottomMargin) / 2 * (1 - shrunk(SMALL_GAP_SHARE, GAP_SHARE)));
    }

    /** Returns a value between that of a low area and the full one. */
    private double shrunk(double small, double full) {
        return between(small, full, (area.height() - SMALL_HEIGHT) / (FULL_HEIGHT - SMALL_HEIGHT));
    }

    private static double between(double small, double full, double share) {
        return small + Math.max(0, Math.min(1, share)) * (full - small);
    }

    public Rectangle2D box(FollowerState state) {
        int row = row(state);
        double x = area.x() + sideMargin + column(state) * (area.width() - 2 * sideMargin - boxWidth) / 2;
        double y = area.y() + (row == 0 ? topMargin : area.height() - bottomMargin - boxHeight);
        return new Rectangle2D.Double(x, y, boxWidth, boxHeight);
    }

    private static int row(FollowerState state) {
        return ROWS.get(0).contains(state) ? 0 : 1;
    }

    private static int column(FollowerState state) {
        return ROWS.get(row(state)).indexOf(state);
    }

    /**
     * The line of an arrow from box to box, its tip with a unit vector, the position of a short number, and the unit
     * vector from the line to the number.
     */
    public record ArrowRoute(Path2D shaft, Vector2 tip, Vector2 direction, Vector2 middle, Vector2 aside) {

        /** Returns the centre of a number of a size in pixels at which it does not touch the line. */
        public Vector2 numberCentre(double width, double height) {
            double reach = Math.abs(aside.x()) * width / 2 + Math.abs(aside.y()) * height / 2 + NUMBER_GAP;
            return middle.plus(aside.times(Math.max(0, reach - LANE_OFFSET)));
        }

        /** Paints the arrow; the length of its head in pixels. */
        public void paint(Surface surface, LineStyle style, double headLength) {
            surface.draw(shaft, style);
            surface.fill(Shapes.arrowhead(tip, direction, headLength, headLength), style.colour());
        }
    }

    /** Returns the line of an arrow between two different states, which crosses no box. */
    public ArrowRoute route(Arrow arrow) {
        if (arrow.from() == MEASURE && arrow.to() == SEARCH) {
            return archRoute(arrow);
        }
        return Math.abs(column(arrow.from()) - column(arrow.to())) > 1 ? gapRoute(arrow) : straightRoute(arrow);
    }

    private ArrowRoute straightRoute(Arrow arrow) {
        Vector2 from = centre(arrow.from());
        Vector2 to = centre(arrow.to());
        Vector2 along = to.minus(from).times(1 / to.distanceTo(from));
        // Each direction keeps to its right, so that opposite arrows do not coincide.
        Vector2 aside = new Vector2(-along.y(), along.x());
        Vector2 lane = aside.times(LANE_OFFSET);
        Vector2 start = boxEdge(from.plus(lane), along, arrow.from());
        Vector2 tip = boxEdge(to.plus(lane), along.times(-1), arrow.to());
        return new ArrowRoute(
                Shapes.polyline(List.of(start, tip)),
                tip,
                along,
                start.plus(tip).times(0.5).plus(lane),
                aside);
    }

    /** Returns a route over the box in between. */
    private ArrowRoute archRoute(Arrow arrow) {
        Rectangle2D from = box(arrow.from());
        Rectangle2D to = box(arrow.to());
        double y = from.getY();
        Path2D shaft = new Path2D.Double();
        shaft.moveTo(from.getCenterX(), y);
        shaft.curveTo(
                from.getCenterX(),
                y - ARCH_HEIGHT,
                from.getCenterX(),
                y - ARCH_HEIGHT,
                from.getCenterX() - ARCH_HEIGHT,
                y - ARCH_HEIGHT);
        shaft.lineTo(to.getCenterX() + ARCH_HEIGHT, y - ARCH_HEIGHT);
        shaft.curveTo(to.getCenterX(), y - ARCH_HEIGHT, to.getCenterX(), y - ARCH_HEIGHT, to.getCenterX(), y);
        return new ArrowRoute(
                shaft,
                new Vector2(to.getCenterX(), y),
                new Vector2(0, 1),
                new Vector2((from.getCenterX() + to.getCenterX()) / 2, y - ARCH_HEIGHT + 9),
                new Vector2(0, 1));
    }

    /** Returns a route between the rows, which passes the box in between. */
    private ArrowRoute gapRoute(Arrow arrow) {
        double side = Math.signum(column(arrow.to()) - column(arrow.from()));
        Vector2 start = gapEdge(arrow.from(), side * START_SHARE);
        Vector2 tip = gapEdge(arrow.to(), -side * END_SHARE);
        double gap = box(FOLLOW).getY() - box(TURN).getMaxY();
        double y = box(FOLLOW).getY() - gap / 2 + side * Math.min(gap, LANE_OFFSET) / 2;
        double bend = side * gap / 2;
        Path2D shaft = new Path2D.Double();
        shaft.moveTo(start.x(), start.y());
        shaft.quadTo(start.x(), y, start.x() + bend, y);
        shaft.lineTo(tip.x() - bend, y);
        shaft.quadTo(tip.x(), y, tip.x(), tip.y());
        double quarter = (3 * centre(arrow.from()).x() + centre(arrow.to()).x()) / 4;
        return new ArrowRoute(
                shaft,
                tip,
                new Vector2(0, row(arrow.to()) == 0 ? -1 : 1),
                new Vector2(quarter, y + side * LANE_OFFSET),
                new Vector2(0, side));
    }

    /** Returns the point of a box at the gap between the rows, at a share of its width from its centre. */
    private Vector2 gapEdge(FollowerState state, double share) {
        Rectangle2D box = box(state);
        return new Vector2(box.getCenterX() + share * boxWidth, row(state) == 0 ? box.getMaxY() : box.getY());
    }

    private Vector2 centre(FollowerState state) {
        Rectangle2D box = box(state);
        return new Vector2(box.getCenterX(), box.getCenterY());
    }

    /** Returns the point at which a ray from inside a box leaves it. */
    private Vector2 boxEdge(Vector2 inside, Vector2 direction, FollowerState state) {
        Rectangle2D box = box(state);
        double across = direction.x() > 0
                ? (box.getMaxX() - inside.x()) / direction.x()
                : (box.getX() - inside.x()) / direction.x();
        double down = direction.y() > 0
                ? (box.getMaxY() - inside.y()) / direction.y()
                : (box.getY() - inside.y()) / direction.y();
        double length = Math.min(direction.x() == 0 ? down : across, direction.y() == 0 ? across : down);
        return inside.plus(direction.times(length));
    }
}
