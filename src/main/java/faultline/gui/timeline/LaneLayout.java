package faultline.gui.timeline;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The places of lanes and items: see {@link Lane}. Items of a lane that overlap in time lie one below the other, in
 * rows of their own.
 */
final class LaneLayout {

    /** No lane or no item. */
    static final int NONE = -1;

    private static final int EDGE = 5;
    private static final int PADDING = 1;
    private static final int MIN_WIDTH = 4;
    /** The greatest height of a lane in rows; more items than that share it. */
    private static final int MAX_ROWS = 4;

    private final List<Lane> lanes;
    private final List<TimelineItem> items;
    private final TimeAxis axis;
    private final int top;
    private final int rowHeight;
    /** The row of each item in its lane, from 0. */
    private final int[] rows;
    /** The number of rows that the items of each lane need, at least 1. */
    private final int[] rowCounts;

    /**
     * Creates a layout.
     *
     * @param lanes the lanes, from the top
     * @param items the items
     * @param axis the times
     * @param top the y coordinate of the first lane, pixels
     * @param rowHeight the height of a lane without overlapping items, pixels
     */
    LaneLayout(List<Lane> lanes, List<TimelineItem> items, TimeAxis axis, int top, int rowHeight) {
        this.lanes = List.copyOf(lanes);
        this.items = List.copyOf(items);
        this.axis = axis;
        this.top = top;
        this.rowHeight = rowHeight;
        rows = new int[items.size()];
        rowCounts = new int[lanes.size()];
        for (int lane = 0; lane < lanes.size(); lane++) {
            rowCounts[lane] = assignRows(lane);
        }
    }

    /** Gives each item of a lane the first row that is free from its start on; returns the number of rows. */
    private int assignRows(int lane) {
        List<Double> ends = new ArrayList<>();
        List<Integer> byStart = itemsIn(lane).stream()
                .filter(index -> items.get(index).isInterval())
                .sorted(Comparator.comparingDouble(index -> items.get(index).start()))
                .toList();
        for (int index : byStart) {
            TimelineItem item = items.get(index);
            int row = 0;
            while (row < ends.size() && ends.get(row) > item.start()) {
                row++;
            }
            if (row == ends.size()) {
                ends.add(item.end());
            } else {
                ends.set(row, item.end());
            }
            rows[index] = row;
        }
        return Math.max(1, ends.size());
    }

    /** The part of an item that the mouse takes hold of. */
    enum Grip {
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
    record Hit(int index, Grip part) {}

    /** Returns the number of rows that all lanes take. */
    static int rowCount(List<Lane> lanes, List<TimelineItem> items) {
        LaneLayout layout = new LaneLayout(lanes, items, new TimeAxis(0, 1, 1), 0, 1);
        return layout.laneTop(lanes.size());
    }

    /** Returns the lanes, from the top. */
    List<Lane> lanes() {
        return lanes;
    }

    /** Returns the items. */
    List<TimelineItem> items() {
        return items;
    }

    /** Returns the times. */
    TimeAxis axis() {
        return axis;
    }

    /** Returns the y coordinate of the first lane, pixels. */
    int top() {
        return top;
    }

    /** Returns the height of a lane without overlapping items, pixels. */
    int rowHeight() {
        return rowHeight;
    }

    /** Returns the index of an item's lane. */
    int laneOf(TimelineItem item) {
        int lane = lanes.indexOf(item.lane());
        return lane == NONE ? lanes.size() - 1 : lane;
    }

    /** Returns the lane at a y coordinate, or {@link #NONE}. */
    int laneAt(double y) {
        for (int lane = 0; lane < lanes.size(); lane++) {
            if (y >= laneTop(lane) && y < laneTop(lane + 1)) {
                return lane;
            }
        }
        return NONE;
    }

    /** Returns the y coordinate of the upper edge of a lane, or of the lower edge of the last for their number. */
    int laneTop(int lane) {
        return top + IntStream.range(0, lane).map(this::laneHeight).sum();
    }

    /** Returns the height of a lane, pixels. */
    int laneHeight(int lane) {
        return Math.min(MAX_ROWS, rowCounts[lane]) * rowHeight;
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
        int lane = laneOf(item);
        double row = (double) laneHeight(lane) / rowCounts[lane];
        double height = row - 2.0 * PADDING;
        double y = laneTop(lane) + rows[index] * row + PADDING;
        if (!item.isInterval()) {
            return new Rectangle2D.Double(axis.x(item.start()) - height / 2, y, height, height);
        }
        double x = axis.x(item.start());
        return new Rectangle2D.Double(x, y, Math.max(MIN_WIDTH, axis.x(item.end()) - x), height);
    }

    /** Returns how far a label of an item may reach, which is to the next item of its row, or {@code right}. */
    double labelEnd(int index, double right) {
        TimelineItem item = items.get(index);
        return itemsIn(laneOf(item)).stream()
                .filter(other -> other != index && rows[other] == rows[index])
                .filter(other -> items.get(other).start() >= item.end())
                .mapToDouble(other -> bounds(other).getMinX())
                .min()
                .orElse(right);
    }

    /** Returns the item at a point; null if there is none. */
    Hit hit(double x, double y) {
        for (int i = items.size() - 1; i >= 0; i--) {
            Rectangle2D bounds = bounds(i);
            if (y >= bounds.getMinY()
                    && y <= bounds.getMaxY()
                    && x >= bounds.getMinX() - EDGE
                    && x <= bounds.getMaxX() + EDGE) {
                return new Hit(i, items.get(i).isInterval() ? part(bounds, x) : Grip.BODY);
            }
        }
        return null;
    }

    private static Grip part(Rectangle2D bounds, double x) {
        double edge = Math.min(EDGE, bounds.getWidth() / 3);
        if (x >= bounds.getMaxX() - edge) {
            return Grip.END;
        }
        return x <= bounds.getMinX() + edge ? Grip.START : Grip.BODY;
    }
}
