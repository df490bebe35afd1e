package faultline.gui.timeline;

import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The places of lanes and items: see {@link Lane}. Items of a lane that overlap in time lie one below the other, in
 * separate rows.
 */
final class LaneLayout {

    /** No lane or no item. */
    static final int NONE = -1;

    private static final int EDGE = 5;
    private static final int PADDING = 1;
    private static final int MIN_WIDTH = 4;
    /** The greatest height of a lane, in heights of a row without overlapping items. */
    private static final int MAX_HEIGHT = 4;
    /** The maximum number of rows of a lane. */
    private static final int MAX_ROWS = 8;

    private final List<Lane> lanes;
    private final List<TimelineItem> items;
    private final TimeAxis axis;
    private final int rowHeight;
    private final Map<Lane, Integer> laneNumbers = new HashMap<>();
    /** The number of rows of each lane, at least 1. */
    private final int[] rowCounts;
    /** The y coordinates of the upper edges of the lanes, then that of the lower edge of the last one. */
    private final int[] tops;
    /** The lane of each item, and the row in it, from 0. */
    private final int[] laneOfItem;

    private final int[] rows;
    /** For each item, the next one in its row, marks included, or {@link #NONE}. */
    private final int[] nextInRow;

    /**
     * Creates a layout, given the y coordinate of the first lane and the height of a lane without overlapping items,
     * pixels.
     */
    LaneLayout(List<Lane> lanes, List<TimelineItem> items, TimeAxis axis, int top, int rowHeight) {
        this.lanes = List.copyOf(lanes);
        this.items = List.copyOf(items);
        this.axis = axis;
        this.rowHeight = rowHeight;
        for (int lane = 0; lane < lanes.size(); lane++) {
            laneNumbers.put(lanes.get(lane), lane);
        }
        laneOfItem = this.items.stream().mapToInt(this::laneOf).toArray();
        rows = new int[items.size()];
        nextInRow = new int[items.size()];
        rowCounts = assignRows();
        tops = new int[lanes.size() + 1];
        tops[0] = top;
        for (int lane = 0; lane < lanes.size(); lane++) {
            tops[lane + 1] = tops[lane] + laneHeight(lane);
        }
    }

    /**
     * Gives each interval the first row of its lane that is free from its start on, or the one that is free next if the
     * lane has no more rows, and finds the next item of each one's row. Returns the number of rows of each lane.
     */
    private int[] assignRows() {
        int[] counts = new int[lanes.size()];
        Arrays.fill(counts, 1);
        Arrays.fill(nextInRow, NONE);
        int[][] lastInterval = emptyRows();
        int[][] last = emptyRows();
        IntStream.range(0, items.size())
                .boxed()
                .sorted(Comparator.comparingDouble(index -> items.get(index).start()))
                .forEach(index -> {
                    int lane = laneOfItem[index];
                    if (items.get(index).isInterval()) {
                        rows[index] =
                                freeRow(lastInterval[lane], items.get(index).start());
                        lastInterval[lane][rows[index]] = index;
                        counts[lane] = Math.max(counts[lane], rows[index] + 1);
                    }
                    if (last[lane][rows[index]] != NONE) {
                        nextInRow[last[lane][rows[index]]] = index;
                    }
                    last[lane][rows[index]] = index;
                });
        return counts;
    }

    private int[][] emptyRows() {
        int[][] empty = new int[lanes.size()][MAX_ROWS];
        Stream.of(empty).forEach(row -> Arrays.fill(row, NONE));
        return empty;
    }

    /** Returns the first row whose last item has ended, or else the one whose last item ends first. */
    private int freeRow(int[] last, double start) {
        int best = 0;
        for (int row = 0; row < last.length; row++) {
            if (last[row] == NONE || items.get(last[row]).end() <= start) {
                return row;
            }
            if (items.get(last[row]).end() < items.get(last[best]).end()) {
                best = row;
            }
        }
        return best;
    }

    /** The part of an item that the mouse takes hold of. */
    enum ItemPart {
        START,
        BODY,
        END
    }

    /** An item under the mouse: its index and the part. */
    record ItemHit(int index, ItemPart part) {}

    /**
     * Returns whether this is the layout of some lanes and items. Comparing takes little time if these are the same.
     */
    boolean isOf(List<Lane> otherLanes, List<TimelineItem> otherItems, TimeAxis otherAxis, int top, int height) {
        return lanes.equals(otherLanes)
                && items.equals(otherItems)
                && axis.equals(otherAxis)
                && tops[0] == top
                && rowHeight == height;
    }

    /** Returns the number of rows that all lanes take. */
    static int rowCount(List<Lane> lanes, List<TimelineItem> items) {
        LaneLayout layout = new LaneLayout(lanes, items, new TimeAxis(0, 1, 1), 0, 1);
        return layout.laneTop(lanes.size());
    }

    /** Returns the lanes, from the top. */
    List<Lane> lanes() {
        return lanes;
    }

    List<TimelineItem> items() {
        return items;
    }

    TimeAxis axis() {
        return axis;
    }

    /** Returns the y coordinate of the first lane, pixels. */
    int top() {
        return tops[0];
    }

    /** Returns the height of a lane without overlapping items, pixels. */
    int rowHeight() {
        return rowHeight;
    }

    /** Returns the index of an item's lane. */
    int laneOf(TimelineItem item) {
        return laneNumbers.getOrDefault(item.lane(), lanes.size() - 1);
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
        return tops[lane];
    }

    /** Returns the height of a lane, pixels. */
    int laneHeight(int lane) {
        return Math.min(MAX_HEIGHT, rowCounts[lane]) * rowHeight;
    }

    /** Returns the indices of a lane's items. */
    List<Integer> itemsIn(int lane) {
        return IntStream.range(0, items.size())
                .filter(index -> laneOfItem[index] == lane)
                .boxed()
                .toList();
    }

    /** Returns the bounds of an item. */
    Rectangle2D bounds(int index) {
        TimelineItem item = items.get(index);
        int lane = laneOfItem[index];
        double row = (double) laneHeight(lane) / rowCounts[lane];
        double y = laneTop(lane) + rows[index] * row + PADDING;
        if (!item.isInterval()) {
            double height = row - 2.0 * PADDING;
            return new Rectangle2D.Double(axis.x(item.start()) - height / 2, y, height, height);
        }
        double x = axis.x(item.start());
        // The padding of the next row keeps the bars apart, so that there is more room for their labels.
        return new Rectangle2D.Double(x, y, Math.max(MIN_WIDTH, axis.x(item.end()) - x), row - PADDING);
    }

    /**
     * Returns where the label of an interval is drawn: on its bar, or after it if only there is room for all of it. All
     * lengths are in pixels; {@code right} is the right edge of the lanes.
     */
    LabelRoom labelRoom(int index, double textWidth, double padding, double right) {
        Rectangle2D bar = visibleBounds(index, 0);
        double end = nextInRow[index] == NONE
                ? right
                : Math.min(right, bounds(nextInRow[index]).getMinX());
        LabelRoom onBar = new LabelRoom(bar.getMinX() + padding, Math.min(bar.getMaxX(), end) - padding);
        LabelRoom after = new LabelRoom(bar.getMaxX() + padding, end - padding);
        return textWidth > onBar.width() && textWidth <= after.width() ? after : onBar;
    }

    /** The x coordinates of the edges of a label, pixels. */
    record LabelRoom(double left, double right) {

        double width() {
            return right - left;
        }
    }

    /**
     * Returns the bounds of an item without what is further than a margin, pixels, from the axis of a part of the run.
     */
    Rectangle2D visibleBounds(int index, double margin) {
        Rectangle2D bounds = bounds(index);
        if (axis.isWhole()) {
            return bounds;
        }
        double minX = Math.max(bounds.getMinX(), axis.left() - margin);
        double maxX = Math.min(bounds.getMaxX(), axis.right() + margin);
        return new Rectangle2D.Double(minX, bounds.getY(), Math.max(0, maxX - minX), bounds.getHeight());
    }

    /** Returns whether some of an item is visible. */
    boolean isVisible(int index) {
        TimelineItem item = items.get(index);
        return axis.x(item.end()) >= axis.left() && axis.x(item.start()) <= axis.right();
    }

    /** Returns the item at a point; null if there is none. */
    ItemHit hit(double x, double y) {
        if (!axis.isWhole() && (x < axis.left() - EDGE || x > axis.right() + EDGE)) {
            return null;
        }
        for (int i = items.size() - 1; i >= 0; i--) {
            Rectangle2D bounds = bounds(i);
            if (y >= bounds.getMinY()
                    && y <= bounds.getMaxY()
                    && x >= bounds.getMinX() - EDGE
                    && x <= bounds.getMaxX() + EDGE) {
                return new ItemHit(i, items.get(i).isInterval() ? part(bounds, x) : ItemPart.BODY);
            }
        }
        return null;
    }

    private static ItemPart part(Rectangle2D bounds, double x) {
        double edge = Math.min(EDGE, bounds.getWidth() / 3);
        if (x >= bounds.getMaxX() - edge) {
            return ItemPart.END;
        }
        return x <= bounds.getMinX() + edge ? ItemPart.START : ItemPart.BODY;
    }
}
