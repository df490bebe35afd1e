package faultline.gui.canvas;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.Path;
import faultline.engine.SampleFrames;
import faultline.geometry.Pose;
import faultline.geometry.Vec;
import faultline.gui.theme.TextSize;
import faultline.paint.FrameImage;
import faultline.paint.Ghost;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.Pixels;
import faultline.paint.SampleGhosts;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** The canvas keeps parts of its picture; whatever happens, it must look as if it had been painted at once. No display is needed. */
class CanvasPictureTest {

    private static final int WIDTH = 600;
    private static final int HEIGHT = 440;
    private static final int MOST_FRAMES = 4;
    private static final Pose ROBOT = new Pose(2, 1, 0.3);
    private static final Obstacle BOX = new Obstacle("box", new ObstacleShape.Rectangle(1, 0.5), new Pose(4, 3, 0.2));

    private final SimulationCanvas canvas = onEdt(() -> {
        SimulationCanvas made = new SimulationCanvas(command -> { }, () -> 0);
        made.setSize(WIDTH, HEIGHT);
        return made;
    });

    @Test
    void theCanvasShowsWhatAPictureFileShows() {
        Frame frame = SampleFrames.everything();
        assertLooksLikeAFile(frame);
        assertLooksLikeAFile(frame);
    }

    @Test
    void anObstacleThatWasMovedLeavesNothingBehind() {
        shown(SampleFrames.of(ROBOT, BOX));
        assertLooksLikeAFile(SampleFrames.of(ROBOT, BOX.at(new Pose(1, 3, 0))));
    }

    @Test
    void aPathThatGoesOnIsDrawnOnWithoutAGap() {
        List<Path> grown = SampleFrames.grown(line(0, 100), line(200, 800));
        shown(SampleFrames.of(ROBOT, grown.get(0), List.of()));
        assertLooksLikeAFileButForJoints(SampleFrames.of(ROBOT, grown.get(1), List.of()));
    }

    @Test
    void aVeryLongPathIsDrawnInSeveralGoes() {
        List<Vec> spiral = new ArrayList<>();
        for (int i = 0; i < 60_000; i++) {
            double r = 0.2 + i * 25e-6;
            spiral.add(new Vec(3 + r * Math.cos(i * 0.03), 2 + r * Math.sin(i * 0.03)));
        }
        Frame frame = SampleFrames.of(ROBOT, SampleFrames.path(spiral.toArray(Vec[]::new)), List.of());
        assertTrue(Pixels.unlike(picture(frame), shown(frame)) > 1000, "all in one go");
        for (int go = 0; go < 20; go++) {
            paint(1);
        }
        assertLooksLikeAFileButForJoints(frame);
    }

    @Test
    void thePathOfARestartedRunDoesNotKeepTheOldOne() {
        shown(SampleFrames.of(ROBOT, SampleFrames.path(line(0, 400).toArray(Vec[]::new)), List.of()));
        assertLooksLikeAFileButForJoints(SampleFrames.of(ROBOT, SampleFrames.path(new Vec(1, 1), new Vec(1.5, 1)), List.of()));
    }

    @Test
    void anEarlierRunLooksLikeInAFileAndLeavesNothingWhenItIsRemoved() {
        Frame frame = SampleFrames.everything();
        Ghost ghost = SampleGhosts.ofTheOffice();
        shown(frame);
        edt(() -> canvas.setGhost(Optional.of(ghost)));
        BufferedImage file = onEdt(() -> canvas.shot(Palette.LIGHT).orElseThrow().image(1));
        assertTrue(Pixels.unlike(file, picture(frame)) > 100, "the ghost shows");
        assertTrue(Pixels.unlike(file, shown(frame)) < 30, "but for joints of its path");
        edt(() -> canvas.setGhost(Optional.empty()));
        assertLooksLikeAFile(frame);
    }

    @Test
    void anotherPaletteIsTakenAtOnce() {
        Frame frame = SampleFrames.everything();
        shown(frame);
        edt(() -> canvas.setPalette(Palette.DARK));
        assertEquals(0, Pixels.differing(FrameImage.render(frame, Palette.DARK, WIDTH, HEIGHT), shown(frame)));
    }

    @Test
    void anotherSizeIsFittedAgain() {
        Frame frame = SampleFrames.everything();
        shown(frame);
        edt(() -> canvas.setSize(WIDTH - 100, HEIGHT - 60));
        assertEquals(0, Pixels.differing(FrameImage.render(frame, Palette.LIGHT, WIDTH - 100, HEIGHT - 60), shown(frame)));
    }

    @Test
    void afterZoomingInAndFittingThePictureIsTheSameAgain() {
        Frame frame = SampleFrames.everything();
        shown(frame);
        edt(canvas::zoomIn);
        assertTrue(Pixels.differing(picture(frame), shown(frame)) > 1000);
        edt(canvas::fit);
        assertLooksLikeAFile(frame);
    }

    @Test
    void eachLayerCanBeHiddenAndShownAgain() {
        Frame frame = SampleFrames.everything();
        for (Layer layer : Layer.values()) {
            boolean usual = onEdt(() -> canvas.isLayerOn(layer));
            edt(() -> canvas.setLayer(layer, !usual));
            assertTrue(Pixels.differing(picture(frame), shown(frame)) > 20, layer + " makes no difference");
            edt(() -> canvas.setLayer(layer, usual));
            assertLooksLikeAFile(frame);
        }
    }

    @Test
    void theSelectedObstacleIsMarkedAndTheMarkGoesAway() {
        Frame frame = SampleFrames.of(ROBOT, BOX);
        shown(frame);
        edt(() -> canvas.tools().select(List.of("box")));
        assertTrue(Pixels.differing(picture(frame), shown(frame)) > 100);
        edt(() -> canvas.tools().select(List.of()));
        assertLooksLikeAFile(frame);
    }

    @Test
    void aCanvasWithoutAFrameIsEmpty() {
        assertEquals(Palette.LIGHT.canvas().getRGB(), paint(1).getRGB(WIDTH / 2, HEIGHT / 2));
    }

    @Test
    void lettersAreAsLargeAsTheTextsOfTheWindow() {
        try {
            Frame frame = SampleFrames.everything();
            int usual = Pixels.unlike(shownUnlettered(frame), shown(frame));
            edt(TextSize.LARGEST::install);
            int largest = Pixels.unlike(shownUnlettered(frame), shown(frame));
            assertTrue(largest > 1.3 * usual, "a scale bar's name of " + usual + " pixels became one of " + largest);
        } finally {
            edt(TextSize.NORMAL::install);
        }
    }

    private BufferedImage shownUnlettered(Frame frame) {
        edt(() -> canvas.setLayer(Layer.SCALE_BAR, false));
        BufferedImage image = shown(frame);
        edt(() -> canvas.setLayer(Layer.SCALE_BAR, true));
        return image;
    }

    @Test
    void onAFinerScreenTheKeptPartsAreAsFineAsTheScreen() {
        edt(() -> canvas.show(SampleFrames.of(ROBOT, BOX)));
        int mixed = blocksOfMoreThanOneColour(paint(2));
        assertTrue(mixed > 1000, "only " + mixed + " blocks of 2 x 2 pixels have more than one colour: the picture was blown up");
    }

    private static int blocksOfMoreThanOneColour(BufferedImage image) {
        int mixed = 0;
        for (int y = 0; y + 1 < image.getHeight(); y += 2) {
            for (int x = 0; x + 1 < image.getWidth(); x += 2) {
                mixed += image.getRGB(x, y) == image.getRGB(x + 1, y) && image.getRGB(x, y) == image.getRGB(x, y + 1) ? 0 : 1;
            }
        }
        return mixed;
    }

    private void assertLooksLikeAFile(Frame frame) {
        assertEquals(0, Pixels.differing(picture(frame), shown(frame)));
    }

    /** A path of two strokes is blended a little differently from one stroke, and where they meet some pixels are unlike. */
    private void assertLooksLikeAFileButForJoints(Frame frame) {
        int unlike = Pixels.unlike(picture(frame), shown(frame));
        assertTrue(unlike < 5, unlike + " pixels differ");
    }

    private static BufferedImage picture(Frame frame) {
        return FrameImage.render(frame, Palette.LIGHT, WIDTH, HEIGHT);
    }

    private BufferedImage shown(Frame frame) {
        edt(() -> canvas.show(frame));
        return settled();
    }

    /** What shows when all is painted, which may take several frames. */
    private BufferedImage settled() {
        for (int frame = 1; frame < MOST_FRAMES; frame++) {
            paint(1);
        }
        return paint(1);
    }

    private BufferedImage paint(int deviceScale) {
        return onEdt(() -> {
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

    private static List<Vec> line(int from, int to) {
        List<Vec> points = new ArrayList<>();
        for (int i = from; i < to; i++) {
            points.add(new Vec(0.5 + 0.006 * i, 2 + 0.5 * Math.sin(i * 0.05)));
        }
        return points;
    }
}
