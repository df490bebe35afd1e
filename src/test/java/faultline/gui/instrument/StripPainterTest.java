package faultline.gui.instrument;

import static org.junit.jupiter.api.Assertions.assertNotEquals;

import faultline.CpuTime;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.theme.Theme;
import faultline.gui.timeline.TimelineItem;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Strip charts with more faults and commands than pixels. */
class StripPainterTest {

    private static final SessionFrame FRAME = SampleRuns.frame(2000);
    private static final List<String> SENSORS = FRAME.snapshot().robot().sensorIds();
    private static final int MANY = 20_000;

    private static StripContent content(List<TimelineItem> items) {
        return new StripContent(
                FRAME, SignalGroup.allOf(SENSORS).get(0), new TimeSpan(10, 10), ValueRange.FROM_ZERO, items, null);
    }

    private static StripContent content(IntFunction<TimelineItem> itemOf) {
        return content(IntStream.range(0, MANY).mapToObj(itemOf).toList());
    }

    private static TimelineItem fault(String sensor, double start, double end) {
        return new TimelineItem(new Command.InjectFault(sensor, new Fault.Bias(0.01)), start, end);
    }

    private static double time(int index) {
        return 10 + 9.0 * index / MANY;
    }

    private static void assertPaintedQuickly(StripContent content) {
        content.toImage(Theme.LIGHT, 1);
        CpuTime time = CpuTime.start();
        content.toImage(Theme.LIGHT, 1);
        time.assertBelow(0.5);
    }

    @Test
    void manyFaultsArePaintedQuickly() {
        assertPaintedQuickly(content(i -> fault(SENSORS.get(i % SENSORS.size()), time(i), time(i) + 0.0002)));
    }

    @Test
    void manyMovesArePaintedQuickly() {
        assertPaintedQuickly(
                content(i -> new TimelineItem(new Command.MoveObstacle("pole", new Pose(1, 1, 0)), time(i), time(i))));
    }

    @Test
    void faultsOfTwoSensorsThatStartTogetherAreBothMarked() {
        TimelineItem left = fault("left", 12.3, 12.301);
        TimelineItem front = fault("front", 12.3, 12.301);
        int both = rgb(List.of(left, front), 12.3);
        assertNotEquals(rgb(List.of(left), 12.3), both);
        assertNotEquals(rgb(List.of(front, left), 12.3), both, "the last one is in front");
    }

    private static int rgb(List<TimelineItem> items, double time) {
        StripContent content = content(items);
        BufferedImage image = content.toImage(Theme.LIGHT, 1);
        StripScale scale = content.scale(900, 420, true);
        return image.getRGB((int) scale.plot().x(time), (int) scale.plot().y(0.03)) & 0xFFFFFF;
    }
}
