package faultline.gui.timeline;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * The places of lanes and items: see {@link Lane}. Items that overlap in time share the height of their lane.
 *
 * @param lanes the lanes, from the top
 * @param items the items
 * @param axis the times
 * @param top the y coordinate of the first lane, pixels
 * @param rowHeight the height of a lane, pixels
 */
record LaneLayout(List<Lane> lanes, List<TimelineItem> items, TimeAxis axis, int top, int rowHeight) {

    /** No lane or no item. */
    static final int NONE = -1;

    private static final int EDGE = 5;
    private static final int PADDING = 1;
    private static final int MIN_WIDTH = 4;

    LaneLayout {
        lanes = List.copyOf(lanes);
        items = List.copyOf(items);
    }

    /** The part of an item that the mouse takes hold of. */
    enum Part {
        START,
        BODY,
        END
    }

    /**
     * An item under the mouse.
     *
     * @param index the index of the item
     * @param part its part
     */
    record Hit(int index, Part part) {}

    /** Returns the index of an item's lane. */
    int laneOf(TimelineItem item) {
        int lane = lanes.indexOf(item.lane());
        return lane == NONE ? lanes.size() - 1 : lane;
    }

    /** Returns the lane at a y coordinate, or {@link #NONE}. */
    int laneAt(double y) {
        int lane = (int) Math.floor((y - top) / rowHeight);
        return lane >= 0 && lane < lanes.size() ? lane : NONE;
    }

    /** Returns the y coordinate of the upper edge of a lane. */
    int laneTop(int lane) {
        return top + lane * rowHeight;
    }

    /** Returns the indices of a lane's items. */
    List<Integer> itemsIn(int lane) {
        List<Integer> result = new ArrayList<>();
        for (int i = 0; i < items.size(); i++) {
            if (laneOf(items.get(i)) == lane) {
                result.add(i);
            }
        }
        return result;
    }

    /** Returns the bounds of an item. */
    Rectangle2D bounds(int index) {
        TimelineItem item = items.get(index);
        List<Integer> overlapping = item.isInterval()
                ? itemsIn(laneOf(item)).stream()
                        .filter(other -> overlaps(items.get(other), item))
                        .toList()
                : List.of(index);
        double height = (rowHeight - 2.0 * PADDING) / overlapping.size();
        double y = laneTop(laneOf(item)) + PADDING + overlapping.indexOf(index) * height;
        if (!item.isInterval()) {
            return new Rectangle2D.Double(axis.x(item.start()) - height / 2, y, height, height);
        }
        double x = axis.x(item.start());
        return new Rectangle2D.Double(x, y, Math.max(MIN_WIDTH, axis.x(item.end()) - x), height);
    }

    private static boolean overlaps(TimelineItem other, TimelineItem item) {
        return other.isInterval() && other.start() < item.end() && item.start() < other.end() || other == item;
    }

    /** Returns the item at a point; null if there is none. */
    Hit hit(double x, double y) {
        for (int i = items.size() - 1; i >= 0; i--) {
            Rectangle2D bounds = bounds(i);
            if (y >= bounds.getMinY()
                    && y <= bounds.getMaxY()
                    && x >= bounds.getMinX() - EDGE
                    && x <= bounds.getMaxX() + EDGE) {
                return new Hit(i, items.get(i).isInterval() ? part(bounds, x) : Part.BODY);
            }
        }
        return null;
    }

    private static Part part(Rectangle2D bounds, double x) {
        double edge = Math.min(EDGE, bounds.getWidth() / 3);
        if (x >= bounds.getMaxX() - edge) {
            return Part.END;
        }
        return x <= bounds.getMinX() + edge ? Part.START : Part.BODY;
    }
}
