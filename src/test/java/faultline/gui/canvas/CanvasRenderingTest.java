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
import faultline.gui.theme.TextSize;
import faultline.paint.export.FrameRenderer;
import faultline.paint.scene.Layer;
import faultline.paint.scene.Pixels;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.SampleReferenceOverlays;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** With its cached layers, the canvas looks as if it had been painted at once. No display is needed. */
class CanvasRenderingTest {

    private static final int WIDTH = 600;
    private static final int HEIGHT = 440;
    private static final int MAX_FRAMES = 4;
    private static final Pose ROBOT = new Pose(2, 1, 0.3);
    private static final Obstacle BOX =
            new Obstacle("box", new ObstacleShape.RectangleShape(1, 0.5), new Pose(4, 3, 0.2));

    private final SimulationCanvas canvas = callOnEdt(() -> {
        SimulationCanvas made = new SimulationCanvas(new CommandSender((commands, onExecuted) -> {}), () -> 0);
        made.setSize(WIDTH, HEIGHT);
        return made;
    });

    @Test
    void theCanvasShowsWhatAPictureFileShows() {
        Frame frame = SampleFrames.fullFrame();
        assertLooksLikeAFile(frame);
        assertLooksLikeAFile(frame);
    }

    @Test
    void anObstacleThatWasMovedLeavesNothingBehind() {
        shown(SampleFrames.frameOf(ROBOT, BOX));
        assertLooksLikeAFile(SampleFrames.frameOf(ROBOT, BOX.withPose(new Pose(1, 3, 0))));
    }

    @Test
    void aPathThatGoesOnIsDrawnOnWithoutAGap() {
        List<RobotPath> grown = SampleFrames.growingPathViews(line(0, 100), line(200, 800));
        shown(SampleFrames.frameOf(ROBOT, grown.get(0), List.of()));
        assertLooksLikeAFileButForJoints(SampleFrames.frameOf(ROBOT, grown.get(1), List.of()));
    }

    @Test
    void aVeryLongPathIsDrawnInSeveralFrames() {
        List<Vector2> spiral = new ArrayList<>();
        for (int i = 0; i < 60_000; i++) {
            double r = 0.2 + i * 25e-6;
            spiral.add(new Vector2(3 + r * Math.cos(i * 0.03), 2 + r * Math.sin(i * 0.03)));
        }
        Frame frame = SampleFrames.frameOf(ROBOT, SampleFrames.pathThrough(spiral.toArray(Vector2[]::new)), List.of());
        assertTrue(Pixels.countVisiblyDifferent(picture(frame), shown(frame)) > 1000, "all in one go");
        for (int go = 0; go < 20; go++) {
            paint(1);
        }
        assertLooksLikeAFileButForJoints(frame);
    }

    @Test
    void aHundredThousandSmallObstaclesAreShownWithinThirtyFrames() {
        Obstacle[] dots = IntStream.range(0, 99_000)
                .mapToObj(i -> new Obstacle(
                        "o" + i,
                        new ObstacleShape.CircleShape(0.004),
                        new Pose(0.1 + i % 330 * 0.0175, 0.1 + i / 330 * 0.0125, 0)))
                .toArray(Obstacle[]::new);
        Frame frame = SampleFrames.frameOf(ROBOT, dots);
        runOnEdt(() -> canvas.setFrame(frame));
        for (int painted = 0; painted < 29; painted++) {
            paint(1);
        }
        assertEquals(0, Pixels.countDifferent(picture(frame), paint(1)));
    }

    @Test
    void thePathOfARestartedRunDoesNotKeepTheOldOne() {
        shown(SampleFrames.frameOf(ROBOT, SampleFrames.pathThrough(line(0, 400).toArray(Vector2[]::new)), List.of()));
        assertLooksLikeAFileButForJoints(SampleFrames.frameOf(
                ROBOT, SampleFrames.pathThrough(new Vector2(1, 1), new Vector2(1.5, 1)), List.of()));
    }

    @Test
    void anEarlierRunLooksLikeInAFileAndLeavesNothingWhenItIsRemoved() {
        Frame frame = SampleFrames.fullFrame();
        ReferenceOverlay overlay = SampleReferenceOverlays.office();
        shown(frame);
        runOnEdt(() -> canvas.setReferenceOverlay(overlay));
        BufferedImage file = callOnEdt(
                () -> canvas.renderRequest(Palette.LIGHT).orElseThrow().toImage(1));
        assertTrue(Pixels.countVisiblyDifferent(file, picture(frame)) > 100, "the reference run is shown");
        assertTrue(Pixels.countVisiblyDifferent(file, shown(frame)) < 30, "but for joints of its path");
        runOnEdt(() -> canvas.setReferenceOverlay(null));
        assertLooksLikeAFile(frame);
    }

    @Test
    void anotherPaletteIsTakenAtOnce() {
        Frame frame = SampleFrames.fullFrame();
        shown(frame);
        runOnEdt(() -> canvas.setPalette(Palette.DARK));
        assertEquals(0, Pixels.countDifferent(FrameRenderer.render(frame, Palette.DARK, WIDTH, HEIGHT), shown(frame)));
    }

    @Test
    void anotherSizeIsFittedAgain() {
        Frame frame = SampleFrames.fullFrame();
        shown(frame);
        runOnEdt(() -> canvas.setSize(WIDTH - 100, HEIGHT - 60));
        assertEquals(
                0,
                Pixels.countDifferent(
                        FrameRenderer.render(frame, Palette.LIGHT, WIDTH - 100, HEIGHT - 60), shown(frame)));
    }

    @Test
    void afterZoomingInAndFittingThePictureIsTheSameAgain() {
        Frame frame = SampleFrames.fullFrame();
        shown(frame);
        runOnEdt(canvas::zoomIn);
        assertTrue(Pixels.countDifferent(picture(frame), shown(frame)) > 1000);
        runOnEdt(canvas::fit);
        assertLooksLikeAFile(frame);
    }

    @Test
    void eachLayerCanBeHiddenAndShownAgain() {
        Frame frame = SampleFrames.fullFrame();
        for (Layer layer : Layer.values()) {
            boolean usual = callOnEdt(() -> canvas.isLayerOn(layer));
            runOnEdt(() -> canvas.setLayer(layer, !usual));
            assertTrue(Pixels.countDifferent(picture(frame), shown(frame)) > 20, layer + " makes no difference");
            runOnEdt(() -> canvas.setLayer(layer, usual));
            assertLooksLikeAFile(frame);
        }
    }

    @Test
    void aCollisionThatIsReportedElsewhereIsOnlyMarked() {
        Frame frame = SampleFrames.fullFrame();
        runOnEdt(() -> canvas.setCollisionReported(false));
        BufferedImage marked = shown(frame);
        assertTrue(Pixels.countDifferent(picture(frame), marked) > 1000, "the report is still there");
        assertEquals(0, Pixels.countDifferent(belowReport(picture(frame)), belowReport(marked)));
        runOnEdt(() -> canvas.setCollisionReported(true));
        assertLooksLikeAFile(frame);
    }

    private static BufferedImage belowReport(BufferedImage image) {
        return image.getSubimage(0, 80, WIDTH, HEIGHT - 80);
    }

    @Test
    void theSelectedObstacleIsMarkedAndTheMarkGoesAway() {
        Frame frame = SampleFrames.frameOf(ROBOT, BOX);
        shown(frame);
        runOnEdt(() -> canvas.tools().select(List.of("box")));
        assertTrue(Pixels.countDifferent(picture(frame), shown(frame)) > 100);
        runOnEdt(() -> canvas.tools().select(List.of()));
        assertLooksLikeAFile(frame);
    }

    @Test
    void aCanvasWithoutAFrameIsEmpty() {
        assertEquals(Palette.LIGHT.canvas().getRGB(), paint(1).getRGB(WIDTH / 2, HEIGHT / 2));
    }

    @Test
    void lettersAreAsLargeAsTheTextsOfTheWindow() {
        try {
            Frame frame = SampleFrames.fullFrame();
            int usual = Pixels.countVisiblyDifferent(shownWithoutScaleBar(frame), shown(frame));
            runOnEdt(TextSize.LARGEST::install);
            int largest = Pixels.countVisiblyDifferent(shownWithoutScaleBar(frame), shown(frame));
            assertTrue(largest > 1.3 * usual, "a scale bar's name of " + usual + " pixels became one of " + largest);
        } finally {
            runOnEdt(TextSize.NORMAL::install);
        }
    }

    private BufferedImage shownWithoutScaleBar(Frame frame) {
        runOnEdt(() -> canvas.setLayer(Layer.SCALE_BAR, false));
        BufferedImage image = shown(frame);
        runOnEdt(() -> canvas.setLayer(Layer.SCALE_BAR, true));
        return image;
    }

    @Test
    void onAHighResolutionScreenCachedLayersHaveTheScreensResolution() {
        runOnEdt(() -> canvas.setFrame(SampleFrames.frameOf(ROBOT, BOX)));
        int mixed = blocksOfMoreThanOneColour(paint(2));
        assertTrue(
                mixed > 1000,
                "only " + mixed + " blocks of 2 x 2 pixels have more than one colour: the image was enlarged");
    }

    private static int blocksOfMoreThanOneColour(BufferedImage image) {
        int mixed = 0;
        for (int y = 0; y + 1 < image.getHeight(); y += 2) {
            for (int x = 0; x + 1 < image.getWidth(); x += 2) {
                mixed += image.getRGB(x, y) == image.getRGB(x + 1, y) && image.getRGB(x, y) == image.getRGB(x, y + 1)
                        ? 0
                        : 1;
            }
        }
        return mixed;
    }

    private void assertLooksLikeAFile(Frame frame) {
        assertEquals(0, Pixels.countDifferent(picture(frame), shown(frame)));
    }

    /** A path of two strokes is blended slightly differently from one stroke, so some pixels differ where they meet. */
    private void assertLooksLikeAFileButForJoints(Frame frame) {
        int unlike = Pixels.countVisiblyDifferent(picture(frame), shown(frame));
        assertTrue(unlike < 5, unlike + " pixels differ");
    }

    private static BufferedImage picture(Frame frame) {
        return FrameRenderer.render(frame, Palette.LIGHT, WIDTH, HEIGHT);
    }

    private BufferedImage shown(Frame frame) {
        runOnEdt(() -> canvas.setFrame(frame));
        return paintedUntilComplete();
    }

    /** Returns the image when everything is painted, which may take several frames. */
    private BufferedImage paintedUntilComplete() {
        for (int frame = 1; frame < MAX_FRAMES; frame++) {
            paint(1);
        }
        return paint(1);
    }

    private BufferedImage paint(int deviceScale) {
        return callOnEdt(() -> {
            int width = canvas.getWidth() * deviceScale;
            int height = canvas.getHeight() * deviceScale;
            BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            graphics.scale(deviceScale, deviceScale);
            canvas.paint(graphics);
            graphics.dispose();
            return image;
        });
    }

    private static List<Vector2> line(int from, int to) {
        List<Vector2> points = new ArrayList<>();
        for (int i = from; i < to; i++) {
            points.add(new Vector2(0.5 + 0.006 * i, 2 + 0.5 * Math.sin(i * 0.05)));
        }
        return points;
    }
}
