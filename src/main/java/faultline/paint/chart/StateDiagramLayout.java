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
        int row = ROWS.get(0).contains(state) ? 0 : 1;
        int column = ROWS.get(row).indexOf(state);
        double x = area.x() + sideMargin + column * (area.width() - 2 * sideMargin - boxWidth) / 2;
        double y = area.y() + (row == 0 ? topMargin : area.height() - bottomMargin - boxHeight);
        return new Rectangle2D.Double(x, y, boxWidth, boxHeight);
    }

    /** The line of an arrow from box to box, its tip with a unit vector, and the position of its number. */
    public record ArrowRoute(Path2D shaft, Vector2 tip, Vector2 direction, Vector2 middle) {

        /** Paints the arrow; the length of its head in pixels. */
        public void paint(Surface surface, LineStyle style, double headLength) {
            surface.draw(shaft, style);
            surface.fill(Shapes.arrowhead(tip, direction, headLength, headLength), style.colour());
        }
    }

    /** Returns the line of an arrow. */
    public ArrowRoute route(Arrow arrow) {
        return arrow.from() == MEASURE && arrow.to() == SEARCH ? archRoute(arrow) : straightRoute(arrow);
    }

    private ArrowRoute straightRoute(Arrow arrow) {
        Vector2 from = centre(arrow.from());
        Vector2 to = centre(arrow.to());
        Vector2 along = to.minus(from).times(1 / to.distanceTo(from));
        // Each direction keeps to its right, so that opposite arrows do not coincide.
        Vector2 lane = new Vector2(-along.y(), along.x()).times(LANE_OFFSET);
        Vector2 start = boxEdge(from.plus(lane), along, arrow.from());
        Vector2 tip = boxEdge(to.plus(lane), along.times(-1), arrow.to());
        return new ArrowRoute(
                Shapes.polyline(List.of(start, tip)),
                tip,
                along,
                start.plus(tip).times(0.5).plus(lane));
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
                new Vector2((from.getCenterX() + to.getCenterX()) / 2, y - ARCH_HEIGHT + 9));
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
