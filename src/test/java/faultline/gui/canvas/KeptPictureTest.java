package faultline.gui.canvas;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.Path;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.Pixels;
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
 * The canvas moves and mends the parts of its picture that it keeps, and paints them over several frames. Whatever is done to it in
 * whatever order, soon after it looks as if it had been painted at once. No display is needed.
 */
class KeptPictureTest {

    private static final int OBSTACLES = 300;
    private static final int STEPS = 120;
    /** After so many frames all that can be wanted in these tests is painted. */
    private static final int FRAMES = 40;
    /** Where two strokes of the path meet, a few pixels are unlike those of one stroke. */
    private static final int JOINTS = 25;

    private final Path path = SampleFrames.path(IntStream.range(0, 3000)
            .mapToObj(i -> new Vec(3 + (0.2 + i * 8e-4) * Math.cos(i * 0.1), 2 + (0.2 + i * 5e-4) * Math.sin(i * 0.1))).toArray(Vec[]::new));
    private final List<Obstacle> obstacles = new ArrayList<>();
    private final AtomicLong clock = new AtomicLong();
    private long tick;
    private final SimulationCanvas canvas = onEdt(() -> new SimulationCanvas(command -> { }, () -> clock.addAndGet(tick)));
    private Palette palette = Palette.LIGHT;
    private boolean labels;
    private int deviceScale;
    private Random random = new Random(0);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void afterAnythingWasDoneThePictureIsSoonAsIfPaintedAtOnce(long seed) {
        random = new Random(seed);
        deviceScale = 1 + (int) (seed % 2);
        edt(() -> canvas.setSize(600, 440));
        IntStream.range(0, OBSTACLES).forEach(i -> obstacles.add(obstacle("o" + i)));
        show();
        for (int step = 0; step < STEPS; step++) {
            int kind = random.nextInt(12);
            edt(() -> disturb(kind));
            show();
            paint(random.nextInt(3));
            if (step % 10 == 9) {
                assertLooksPaintedAtOnce("seed " + seed + ", step " + step);
            }
        }
    }

    @Test
    void whereTheClockIsAlwaysTooFastEachFrameStillPaintsALittle() {
        tick = TimeUnit.SECONDS.toNanos(1);
        deviceScale = 1;
        edt(() -> canvas.setSize(600, 440));
        IntStream.range(0, OBSTACLES).forEach(i -> obstacles.add(obstacle("o" + i)));
        show();
        paint(OBSTACLES);
        assertLooksPaintedAtOnce("a late clock");
    }

    private void disturb(int kind) {
        switch (kind) {
            case 0, 1, 2 -> pan(random.nextInt(200) - 100, random.nextInt(160) - 80);
            case 3 -> canvas.zoomIn();
            case 4 -> canvas.zoomOut();
            case 5 -> obstacles.replaceAll(obstacle -> random.nextInt(OBSTACLES) < 3 ? obstacle.at(pose()) : obstacle);
            case 6 -> obstacles.remove(random.nextInt(obstacles.size()));
            case 7 -> obstacles.add(random.nextInt(obstacles.size()), obstacle("n" + random.nextInt()));
            case 8 -> canvas.tools().select(obstacles.stream().map(Obstacle::id).limit(random.nextInt(40)).toList());
            case 9 -> canvas.setPalette(palette = palette == Palette.LIGHT ? Palette.DARK : Palette.LIGHT);
            case 10 -> canvas.setSize(560 + random.nextInt(80), 400 + random.nextInt(80));
            default -> canvas.setLayer(Layer.LABELS, labels = !labels);
        }
    }

    /** As the middle button does. */
    private void pan(int dx, int dy) {
        mouse(MouseEvent.MOUSE_PRESSED, 300, 200);
        mouse(MouseEvent.MOUSE_DRAGGED, 300 + dx, 200 + dy);
        mouse(MouseEvent.MOUSE_RELEASED, 300 + dx, 200 + dy);
    }

    private void mouse(int kind, int x, int y) {
        canvas.dispatchEvent(new MouseEvent(canvas, kind, 0, InputEvent.BUTTON2_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON2));
    }

    private Obstacle obstacle(String id) {
        return new Obstacle(id, new ObstacleShape.Rectangle(0.1 + 0.2 * random.nextDouble(), 0.1), pose());
    }

    private Pose pose() {
        return new Pose(6 * random.nextDouble(), 4 * random.nextDouble(), 6 * random.nextDouble());
    }

    private Frame frame() {
        return SampleFrames.frame(new Pose(2, 1, 0.3), path, List.of(), obstacles, List.of(), Optional.empty());
    }

    private void show() {
        edt(() -> canvas.show(frame()));
    }

    private void assertLooksPaintedAtOnce(String when) {
        edt(() -> canvas.tools().select(List.of()));
        BufferedImage shown = paint(FRAMES);
        BufferedImage atOnce = onEdt(() -> canvas.shot(palette).map(shot -> shot.image(deviceScale)).orElseThrow());
        int unlike = Pixels.unlike(atOnce, shown);
        assertTrue(unlike <= JOINTS, when + ": " + unlike + " pixels differ");
    }

    /** The last of so many frames. */
    private BufferedImage paint(int frames) {
        return onEdt(() -> {
            BufferedImage image = new BufferedImage(canvas.getWidth() * deviceScale, canvas.getHeight() * deviceScale, BufferedImage.TYPE_INT_RGB);
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
