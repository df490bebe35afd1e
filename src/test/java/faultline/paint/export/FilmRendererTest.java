package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.paint.scene.Pixels;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WaypointPath;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** The images of films equal those that are painted whole, and cost what moves. */
class FilmRendererTest {

    private static final int WIDTH = 640;
    private static final int HEIGHT = 400;
    /** The number of images, of which the cheapest counts: the first ones are painted by interpreted code. */
    private static final int IMAGES = 40;

    private final FilmRenderer renderer = new FilmRenderer();

    @Test
    void everyImageEqualsOneThatIsPaintedWhole() {
        Obstacle box = new Obstacle("box", new ObstacleShape.CircleShape(0.3), new Pose(1, 0.5, 0));
        Obstacle visitor = new Obstacle(
                "visitor",
                new ObstacleShape.CircleShape(0.2),
                new Pose(3, 1, 0),
                new WaypointPath(0.1, true, List.of(new Vector2(3, 1), new Vector2(3, 2))));
        assertPainted(SampleFrames.frameOf(new Pose(1, 1.5, 0), box, visitor));
        assertPainted(SampleFrames.frameOf(new Pose(1.2, 1.5, 0.3), box, visitor.withPose(new Pose(3, 1.4, 0))));
        assertPainted(SampleFrames.frameOf(new Pose(1.2, 1.5, 0.3), box.withPose(new Pose(2, 0.5, 0)), visitor));
        assertPainted(SampleFrames.frameOf(new Pose(1.2, 1.5, 0.3), visitor));
        assertPainted(SampleFrames.fullFrame());
    }

    private void assertPainted(Frame frame) {
        RenderRequest request = request(frame);
        BufferedImage whole = request.toImage(1);
        FilmClock.paint(whole, frame.snapshot().time(), Palette.LIGHT);
        assertEquals(0, Pixels.countDifferent(whole, renderer.render(request)));
    }

    private static RenderRequest request(Frame frame) {
        return FrameRenderer.request(frame, Palette.LIGHT, WIDTH, HEIGHT);
    }

    @Test
    void anImageOfALargePlanCostsWhatMoves() {
        Obstacle plan = new Obstacle("plan", new ObstacleShape.PlanShape(rings()), new Pose(0, 0, 0));
        long whole = leastTime(plan, frame -> request(frame).toImage(1));
        long kept = leastTime(plan, frame -> renderer.render(request(frame)));
        assertTrue(3 * kept < whole, kept / 1000 + " us instead of " + whole / 1000);
    }

    private static List<List<Vector2>> rings() {
        List<List<Vector2>> rings = new ArrayList<>();
        for (int i = 0; i < 20_000; i++) {
            double x = 0.03 * (i % 200);
            double y = 0.04 * (i / 200);
            rings.add(List.of(
                    new Vector2(x, y),
                    new Vector2(x + 0.02, y),
                    new Vector2(x + 0.02, y + 0.02),
                    new Vector2(x, y + 0.02)));
        }
        return rings;
    }

    /** Calls an action for frames of a moving robot and returns the least of its processor times, nanoseconds. */
    private static long leastTime(Obstacle plan, Consumer<Frame> action) {
        return LongStream.range(0, IMAGES)
                .map(i -> {
                    Frame frame = SampleFrames.frameOf(new Pose(1 + 0.02 * i, 1, 0), plan);
                    long start = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
                    action.accept(frame);
                    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - start;
                })
                .min()
                .orElseThrow();
    }
}
