package faultline.gui.canvas;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.RobotPath;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.edit.CommandSender;
import faultline.paint.scene.Layer;
import faultline.paint.scene.Pixels;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The canvas moves and repairs the parts of its picture that it caches, and paints them over several frames. Whatever
 * is done to it in whatever order, soon after it looks as if it had been painted at once. No display is needed.
 */
class CachedSceneRendererTest {

    private static final int OBSTACLES = 300;
    private static final int STEPS = 120;
    /** The number of frames after which everything in these tests is painted. */
    private static final int FRAMES = 40;
    /** The number of pixels that may differ where two strokes of the path meet. */
    private static final int JOINTS = 25;

    private final RobotPath path = SampleFrames.pathThrough(IntStream.range(0, 3000)
            .mapToObj(i ->
                    new Vector2(3 + (0.2 + i * 8e-4) * Math.cos(i * 0.1), 2 + (0.2 + i * 5e-4) * Math.sin(i * 0.1)))
            .toArray(Vector2[]::new));
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final AtomicLong clock = new AtomicLong();
    private long tick;
    private final SimulationCanvas canvas = callOnEdt(
            () -> new SimulationCanvas(new CommandSender((commands, onExecuted) -> {}), () -> clock.addAndGet(tick)));
    private Palette palette = Palette.LIGHT;
    private boolean labels;
    private double deviceScale;
    private Random random = new Random(0);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void afterAnyChangeTheCachedRenderingConvergesToADirectOne(long seed) {
        random = new Random(seed);
        deviceScale = List.of(1.0, 2.0, 1.25, 1.5).get((int) (seed % 4));
        runOnEdt(() -> canvas.setSize(600, 440));
        IntStream.range(0, OBSTACLES).forEach(i -> obstacles.add(obstacle("o" + i)));
        showFrame();
        for (int step = 0; step < STEPS; step++) {
            int kind = random.nextInt(12);
            runOnEdt(() -> applyRandomChange(kind));
            showFrame();
            paint(random.nextInt(3));
            if (step % 10 == 9) {
                assertMatchesDirectRendering("seed " + seed + ", step " + step);
            }
        }
    }

    @Test
    void eachFramePaintsSomethingEvenIfTheBudgetIsExhausted() {
        tick = TimeUnit.SECONDS.toNanos(1);
        deviceScale = 1;
        runOnEdt(() -> canvas.setSize(600, 440));
        IntStream.range(0, OBSTACLES).forEach(i -> obstacles.add(obstacle("o" + i)));
        showFrame();
        paint(OBSTACLES);
        assertMatchesDirectRendering("a late clock");
    }

    @Test
    void aMovedFloorPlanIsPaintedOverSeveralFramesWhileItsOldImageShows() {
        deviceScale = 1;
        runOnEdt(() -> canvas.setSize(600, 440));
        Obstacle plan = new Obstacle("plan", new ObstacleShape.PlanShape(smallSquares(5000)), new Pose(0, 0, 0));
        obstacles.add(plan);
        showFrame();
        BufferedImage before = paint(FRAMES);
        obstacles.set(0, plan.withPose(new Pose(0.5, 0, 0)));
        showFrame();
        assertEquals(0, Pixels.countVisiblyDifferent(before, paint(1)));
        assertMatchesDirectRendering("a moved plan");
    }

    private static List<List<Vector2>> smallSquares(int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> new Vector2(i % 100 * 0.05, i / 100 * 0.07))
                .map(corner -> List.of(
                        corner,
                        corner.plus(new Vector2(0.03, 0)),
                        corner.plus(new Vector2(0.03, 0.03)),
                        corner.plus(new Vector2(0, 0.03))))
                .toList();
    }

    private void applyRandomChange(int kind) {
        switch (kind) {
            case 0, 1, 2 -> pan(random.nextInt(200) - 100, random.nextInt(160) - 80);
            case 3 -> canvas.zoomIn();
            case 4 -> canvas.zoomOut();
            case 5 ->
                obstacles.replaceAll(obstacle -> random.nextInt(OBSTACLES) < 3 ? obstacle.withPose(pose()) : obstacle);
            case 6 -> obstacles.remove(random.nextInt(obstacles.size()));
            case 7 -> obstacles.add(random.nextInt(obstacles.size()), obstacle("n" + random.nextInt()));
            case 8 ->
                canvas.tools()
                        .select(obstacles.stream()
                                .map(Obstacle::id)
                                .limit(random.nextInt(40))
                                .toList());
            case 9 -> canvas.setPalette(palette = palette == Palette.LIGHT ? Palette.DARK : Palette.LIGHT);
            // Whole device pixels at all scales: the last one of a part belongs to the next component.
            case 10 -> canvas.setSize(560 + 4 * random.nextInt(20), 400 + 4 * random.nextInt(20));
            default -> canvas.setLayer(Layer.LABELS, labels = !labels);
        }
    }

    /** Pans as the middle button does. */
    private void pan(int dx, int dy) {
        mouse(MouseEvent.MOUSE_PRESSED, 300, 200);
        mouse(MouseEvent.MOUSE_DRAGGED, 300 + dx, 200 + dy);
        mouse(MouseEvent.MOUSE_RELEASED, 300 + dx, 200 + dy);
    }

    private void mouse(int kind, int x, int y) {
        canvas.dispatchEvent(
                new MouseEvent(canvas, kind, 0, InputEvent.BUTTON2_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON2));
    }

    private Obstacle obstacle(String id) {
        return new Obstacle(id, new ObstacleShape.RectangleShape(0.1 + 0.2 * random.nextDouble(), 0.1), pose());
    }

    private Pose pose() {
        return new Pose(6 * random.nextDouble(), 4 * random.nextDouble(), 6 * random.nextDouble());
    }

    private Frame frame() {
        return SampleFrames.frame(new Pose(2, 1, 0.3), path, List.of(), obstacles, List.of(), Optional.empty());
    }

    private void showFrame() {
        runOnEdt(() -> canvas.setFrame(frame()));
    }

    private void assertMatchesDirectRendering(String when) {
        runOnEdt(() -> canvas.tools().select(List.of()));
        BufferedImage shown = paint(FRAMES);
        BufferedImage atOnce = callOnEdt(() -> canvas.renderRequest(palette)
                .map(shot -> shot.toImage(deviceScale))
                .orElseThrow());
        int unlike = Pixels.countVisiblyDifferent(atOnce, shown);
        assertTrue(unlike <= JOINTS, when + ": " + unlike + " pixels differ");
    }

    /** Returns the last of a number of frames. */
    private BufferedImage paint(int frames) {
        return callOnEdt(() -> {
            BufferedImage image = new BufferedImage(
                    (int) Math.ceil(canvas.getWidth() * deviceScale),
                    (int) Math.ceil(canvas.getHeight() * deviceScale),
                    BufferedImage.TYPE_INT_RGB);
            for (int i = 0; i < frames; i++) {
                Graphics2D graphics = image.createGraphics();
                graphics.scale(deviceScale, deviceScale);
                canvas.paint(graphics);
                graphics.dispose();
            }
            return image;
        });
    }
}
