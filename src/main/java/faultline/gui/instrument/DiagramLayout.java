package faultline.gui.instrument;

import static faultline.control.FollowerState.ALIGN;
import static faultline.control.FollowerState.FOLLOW;
import static faultline.control.FollowerState.MEASURE;
import static faultline.control.FollowerState.ROUND;
import static faultline.control.FollowerState.SEARCH;
import static faultline.control.FollowerState.TURN;

import faultline.control.FollowerState;
import faultline.control.StateDiagram.Arrow;
import faultline.geometry.Vector2;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * Where the boxes and arrows of the state diagram are, pixels: two rows of three, so that the usual course of things
 * goes round clockwise.
 */
final class DiagramLayout {

    private static final List<List<FollowerState>> ROWS =
            List.of(List.of(SEARCH, TURN, MEASURE), List.of(ROUND, FOLLOW, ALIGN));
    private static final double SIDE_MARGIN = 14;
    private static final double TOP_MARGIN = 30;
    private static final double BOTTOM_MARGIN = 30;
    private static final double MAX_BOX_WIDTH = 132;
    private static final double MAX_BOX_HEIGHT = 46;
    private static final double GAP_SHARE = 0.3;

    /** Two arrows between the same boxes run side by side, this far off the middle. */
    private static final double LANE_OFFSET = 7;

    /** How far above the boxes the arrow from end to end of a row runs. */
    private static final double ARCH_HEIGHT = 22;

    private final double width;
    private final double height;
    private final double boxWidth;
    private final double boxHeight;

    DiagramLayout(double width, double height) {
        this.width = width;
        this.height = height;
        boxWidth = Math.min(MAX_BOX_WIDTH, (width - 2 * SIDE_MARGIN) / 3 * (1 - GAP_SHARE));
        boxHeight = Math.min(MAX_BOX_HEIGHT, (height - TOP_MARGIN - BOTTOM_MARGIN) / 2 * (1 - GAP_SHARE));
    }

    Rectangle2D box(FollowerState state) {
        int row = ROWS.get(0).contains(state) ? 0 : 1;
        int column = ROWS.get(row).indexOf(state);
        double x = SIDE_MARGIN + column * (width - 2 * SIDE_MARGIN - boxWidth) / 2;
        double y = row == 0 ? TOP_MARGIN : height - BOTTOM_MARGIN - boxHeight;
        return new Rectangle2D.Double(x, y, boxWidth, boxHeight);
    }

    /**
     * The line of an arrow.
     *
     * @param shaft from box to box
     * @param tip where it ends
     * @param direction of the tip, of length 1
     * @param middle where its number stands
     */
    record ArrowRoute(Path2D shaft, Vector2 tip, Vector2 direction, Vector2 middle) {}

    ArrowRoute route(Arrow arrow) {
        return arrow.from() == MEASURE && arrow.to() == SEARCH ? archRoute(arrow) : straightRoute(arrow);
    }

    private ArrowRoute straightRoute(Arrow arrow) {
        Vector2 from = centre(arrow.from());
        Vector2 to = centre(arrow.to());
        Vector2 along = to.minus(from).times(1 / to.distanceTo(from));
        // Each way keeps to its right, so that there and back do not lie on each other.
        Vector2 lane = new Vector2(-along.y(), along.x()).times(LANE_OFFSET);
        Vector2 start = boxEdge(from.plus(lane), along, arrow.from());
        Vector2 tip = boxEdge(to.plus(lane), along.times(-1), arrow.to());
        Path2D shaft = new Path2D.Double();
        shaft.moveTo(start.x(), start.y());
        shaft.lineTo(tip.x(), tip.y());
        return new ArrowRoute(shaft, tip, along, start.plus(tip).times(0.5).plus(lane));
    }

    /** Over the box between. */
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

    /** Where a line from inside a box leaves it. */
    private Vector2 boxEdge(Vector2 inside, Vector2 direction, FollowerState state) {
        Rectangle2D box = box(state);
        double across = direction.x() > 0
                ? (box.getMaxX() - inside.x()) / direction.x()
                : (box.getX() - inside.x()) / direction.x();
        double down = direction.y() > 0
                ? (box.getMaxY() - inside.y()) / direction.y()
                : (box.getY() - inside.y()) / direction.y();
        double way = Math.min(direction.x() == 0 ? down : across, direction.y() == 0 ? across : down);
        return inside.plus(direction.times(way));
    }
}
