package faultline.gui.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.CpuTime;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Lanes of items that overlap in time. */
class LaneLayoutTest {

    private static final List<Lane> LANES =
            List.of(new Lane.SensorLane("front"), new Lane.SensorLane("left"), new Lane.SensorLane("rear"), Lane.OTHER);
    private static final int TOP = 14;
    private static final int ROW = 12;

    private static TimelineItem item(String sensor, double from, double to) {
        return new TimelineItem(new Command.InjectFault(sensor, new Fault.Stuck(0.4)), from, to);
    }

    private static LaneLayout layout(TimelineItem... items) {
        return new LaneLayout(LANES, List.of(items), new TimeAxis(80, 480, 40), TOP, ROW);
    }

    @Test
    void itemsThatOverlapHaveRowsWithRoomForTheirLabels() {
        LaneLayout lanes = layout(item("left", 0, 20), item("left", 10, 30), item("left", 20, 40), item("rear", 5, 9));
        for (int i = 0; i < 4; i++) {
            assertEquals(ROW - 1, lanes.bounds(i).getHeight());
            Rectangle2D bounds = lanes.bounds(i);
            IntStream.range(0, i).forEach(other -> assertFalse(bounds.intersects(lanes.bounds(other))));
        }
        assertEquals(lanes.bounds(0).getY(), lanes.bounds(2).getY(), "its row is free again");
        assertEquals(List.of(ROW, 2 * ROW, ROW, ROW), heights(lanes));
    }

    private static List<Integer> heights(LaneLayout lanes) {
        return IntStream.range(0, LANES.size()).mapToObj(lanes::laneHeight).toList();
    }

    @Test
    void aLabelThatDoesNotFitOnItsBarIsDrawnAfterItOrShortened() {
        // 10 pixels are a second: the first bar is at 80 to 130, the second at 280 to 480.
        LaneLayout lanes = layout(item("left", 0, 5), item("left", 20, 40), item("left", 30, 40), item("rear", 6, 7));
        assertEquals(new LaneLayout.LabelRoom(86, 124), lanes.labelRoom(0, 38, 6, 500));
        assertEquals(new LaneLayout.LabelRoom(136, 274), lanes.labelRoom(0, 39, 6, 500));
        assertEquals(new LaneLayout.LabelRoom(86, 124), lanes.labelRoom(0, 139, 6, 500), "too long for either");
        assertEquals(new LaneLayout.LabelRoom(286, 474), lanes.labelRoom(1, 100, 6, 500));
        assertEquals(new LaneLayout.LabelRoom(156, 494), lanes.labelRoom(3, 100, 6, 500));
    }

    @Test
    void aLabelDoesNotCoverAMark() {
        TimelineItem mark = TimelineItem.from(new Command.SwitchSensor("left", true), 8);
        LaneLayout lanes = layout(item("left", 0, 5), mark);
        assertFalse(mark.isInterval());
        assertEquals(new LaneLayout.LabelRoom(86, 124), lanes.labelRoom(0, 40, 6, 500));
    }

    @Test
    void aPointIsInTheLaneThatIsDrawnThere() {
        LaneLayout lanes = layout(item("left", 0, 20), item("left", 10, 30));
        int[] expected = {-1, 0, 1, 1, 2, 3, -1};
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], lanes.laneAt(TOP + (i - 0.5) * ROW));
        }
        assertEquals(new LaneLayout.ItemHit(1, LaneLayout.ItemPart.BODY), lanes.hit(80 + 150, TOP + 2.5 * ROW));
    }

    @Test
    void aBarAndAMarkLieInTheirLaneAtTheirTimes() {
        TimelineItem mark = TimelineItem.from(new Command.SwitchSensor("left", true), 8);
        LaneLayout lanes = layout(item("left", 10, 20), mark, item("left", 30, 30.1));
        assertEquals(new Rectangle2D.Double(180, TOP + ROW + 1, 100, 11), lanes.bounds(0));
        assertEquals(new Rectangle2D.Double(155, TOP + ROW + 1, 10, 10), lanes.bounds(1));
        assertEquals(new Rectangle2D.Double(380, TOP + ROW + 1, 4, 11), lanes.bounds(2));
    }

    @Test
    void anItemOfASensorThatTheRobotLacksIsInTheLastLane() {
        LaneLayout lanes = layout(item("nose", 10, 20));
        assertEquals(3, lanes.laneOf(lanes.items().get(0)));
        assertEquals(TOP + 3 * ROW + 1, lanes.bounds(0).getY());
    }

    @Test
    void itemsInAnotherOrderThanThatOfTheirStartsShareARow() {
        LaneLayout lanes = layout(item("left", 20, 40), item("left", 0, 20));
        assertEquals(ROW, lanes.laneHeight(1));
        assertEquals(new LaneLayout.LabelRoom(86, 274), lanes.labelRoom(1, 20, 6, 500));
    }

    @Test
    void aLaneBeginsAtItsUpperEdge() {
        LaneLayout lanes = layout();
        assertEquals(0, lanes.laneAt(TOP));
        assertEquals(1, lanes.laneAt(TOP + ROW));
        assertEquals(LaneLayout.NONE, lanes.laneAt(TOP + 4 * ROW));
    }

    /** The axis shows 10 s to 20 s, 40 pixels a second. */
    @Test
    void whatIsBesideAPartOfTheRunIsHidden() {
        List<TimelineItem> items =
                List.of(item("left", 0, 15), item("rear", 0, 9), item("front", 21, 30), item("nose", 15, 30));
        LaneLayout lanes = new LaneLayout(LANES, items, new TimeAxis(80, 480, 10, 20, 40), TOP, ROW);
        assertEquals(new Rectangle2D.Double(77, TOP + ROW + 1, 203, 11), lanes.visibleBounds(0, 3));
        assertEquals(0, lanes.visibleBounds(1, 3).getWidth());
        assertTrue(lanes.isVisible(0) && !lanes.isVisible(1) && !lanes.isVisible(2));
        assertNull(lanes.hit(74, TOP + 1.5 * ROW));
        assertEquals(0, lanes.hit(75, TOP + 1.5 * ROW).index());
        assertEquals(new Rectangle2D.Double(280, TOP + 3 * ROW + 1, 203, 11), lanes.visibleBounds(3, 3));
        assertEquals(3, lanes.hit(485, TOP + 3.5 * ROW).index());
        assertNull(lanes.hit(486, TOP + 3.5 * ROW));
    }

    private static LaneLayout.ItemPart partAt(double x, LaneLayout lanes) {
        LaneLayout.ItemHit hit = lanes.hit(x, TOP + 1.5 * ROW);
        return hit == null ? null : hit.part();
    }

    @Test
    void anIntervalIsTakenAtItsEndsWithinFivePixels() {
        // The bar is at 180 to 280.
        LaneLayout lanes = layout(item("left", 10, 20));
        assertNull(partAt(174, lanes));
        assertEquals(LaneLayout.ItemPart.START, partAt(175, lanes));
        assertEquals(LaneLayout.ItemPart.START, partAt(185, lanes));
        assertEquals(LaneLayout.ItemPart.BODY, partAt(186, lanes));
        assertEquals(LaneLayout.ItemPart.BODY, partAt(274, lanes));
        assertEquals(LaneLayout.ItemPart.END, partAt(275, lanes));
        assertEquals(LaneLayout.ItemPart.END, partAt(285, lanes));
        assertNull(partAt(286, lanes));
    }

    @Test
    void theMiddleThirdOfAShortIntervalIsItsBody() {
        // The bar is at 180 to 189.
        LaneLayout lanes = layout(item("left", 10, 10.9));
        assertEquals(LaneLayout.ItemPart.START, partAt(182, lanes));
        assertEquals(LaneLayout.ItemPart.BODY, partAt(184.5, lanes));
        assertEquals(LaneLayout.ItemPart.END, partAt(187, lanes));
    }

    @Test
    void anItemThatFindsAllRowsTakenLiesInTheOneThatIsFreeNext() {
        double[] ends = {40, 40, 40, 20, 40, 30, 40, 40};
        TimelineItem[] items = IntStream.rangeClosed(0, ends.length)
                .mapToObj(i -> item("front", i, i < ends.length ? ends[i] : 40))
                .toArray(TimelineItem[]::new);
        LaneLayout lanes = layout(items);
        assertEquals(lanes.bounds(3).getY(), lanes.bounds(8).getY());
    }

    @Test
    void manyItemsShareFourRows() {
        TimelineItem[] items =
                IntStream.range(0, 7).mapToObj(i -> item("front", i, 30 + i)).toArray(TimelineItem[]::new);
        LaneLayout lanes = layout(items);
        assertEquals(4 * ROW, lanes.laneHeight(0));
        assertTrue(lanes.bounds(6).getMaxY() <= lanes.laneTop(1));
        assertEquals(4 + 3, LaneLayout.rowCount(LANES, List.of(items)));
    }

    @Test
    void tensOfThousandsOfItemsAreLaidOutAtOnce() {
        CpuTime time = CpuTime.start();
        TimelineItem[] items = IntStream.range(0, 50_000)
                .mapToObj(i -> item("front", i, i % 2 == 0 ? Double.POSITIVE_INFINITY : i + 1.5))
                .toArray(TimelineItem[]::new);
        LaneLayout lanes = layout(items);
        for (int i = 0; i < items.length; i++) {
            assertTrue(lanes.bounds(i).getHeight() > 0);
            assertTrue(lanes.labelRoom(i, 20, 6, 500).left() >= 86);
        }
        time.assertBelow(20);
    }
}
