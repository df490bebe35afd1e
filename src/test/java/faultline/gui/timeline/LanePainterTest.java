package faultline.gui.timeline;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.SimulationSetup.TimedCommand;
import faultline.gui.EdtChecker;
import faultline.gui.document.DocumentStore;
import faultline.gui.document.RunController;
import faultline.gui.document.SessionFrames;
import faultline.gui.document.Workspace;
import faultline.gui.edit.CommandSender;
import faultline.gui.edit.UndoController;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Blend;
import faultline.paint.surface.Contrast;
import faultline.paint.surface.Palette;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The lanes of several heights as pictures, without a display. */
@ExtendWith(EdtChecker.class)
class LanePainterTest {

    private static final int WIDTH = 800;
    private static final int RULER = 14;
    private static final int LABEL_WIDTH = 110;

    private Workspace workspace;
    private RunController run;
    private LaneView view;

    @BeforeEach
    void openWithOneLongFault() {
        run = callOnEdt(() -> {
            Theme.LIGHT.install();
            workspace = new Workspace();
            RunController created = new RunController(workspace);
            new DocumentStore(workspace).open(Path.of("scenarios/mirror.xml"));
            return created;
        });
        SessionFrames.awaitScenario(workspace);
        runOnEdt(() -> {
            view = new LaneView(new TimelineEditor(
                    workspace, run, new UndoController(new CommandSender(run::send), () -> {}), note -> {}));
            run.change(old -> old.withSetup(old.setup()
                    .withTimeline(List.of(
                            new TimedCommand(10, new Command.InjectFault("left", new Fault.Dropout(0.3))),
                            new TimedCommand(50, new Command.ClearFaults("left"))))));
            view.update(List.of(new Lane.SensorLane("left"), Lane.OTHER), new TimeAxis(0, WIDTH, 60), 0);
        });
    }

    @AfterEach
    void close() {
        runOnEdt(workspace::close);
    }

    private BufferedImage picture(int rowHeight) {
        return callOnEdt(() -> {
            view.setSize(WIDTH, RULER + 2 * rowHeight);
            BufferedImage image = new BufferedImage(WIDTH, view.getHeight(), BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = image.createGraphics();
            view.print(graphics);
            graphics.dispose();
            return image;
        });
    }

    /** Returns how many pixels of a line of the bar, from its top, differ from those where there is no label. */
    private long labelPixels(BufferedImage picture, Rectangle2D bar, int line) {
        int y = (int) bar.getMinY() + line;
        int left = (int) bar.getMinX() + 4;
        // The first line of the grid is further to the right.
        int right = left + LABEL_WIDTH;
        long count = 0;
        for (int x = left; x < right; x++) {
            count += picture.getRGB(x, y) == picture.getRGB(right, y) ? 0 : 1;
        }
        return count;
    }

    @ParameterizedTest
    @ValueSource(ints = {12, 14, 17})
    void theLabelOfABarDoesNotTouchItsBorder(int rowHeight) {
        BufferedImage picture = picture(rowHeight);
        Rectangle2D bar = callOnEdt(() -> view.lanes().bounds(0));
        int height = (int) bar.getHeight();
        for (int line : new int[] {0, height - 1}) {
            assertEquals(0, labelPixels(picture, bar, line), "line " + line + " of " + height);
        }
        assertTrue(labelPixels(picture, bar, height / 2) > 10, "there is no label");
    }

    @ParameterizedTest
    @EnumSource(Theme.class)
    void theLabelOfABarHasContrast(Theme theme) {
        for (int sensor = 0; sensor < 16; sensor++) {
            Color bar = Palette.withAlpha(theme.palette().sensorColours(sensor).fill(), LanePainter.BAR_ALPHA);
            double contrast = Contrast.of(
                    theme.palette().text(), Blend.of(bar, theme.palette().canvas()));
            assertTrue(contrast >= 4.5, "sensor " + sensor + ": " + contrast);
        }
    }

    @Test
    void barsAndThePresentTimeAreVisibleAndTheSelectedBarHasHandles() {
        int accent = Theme.LIGHT.colours().accent().getRGB();
        runOnEdt(() -> view.update(List.of(new Lane.SensorLane("left"), Lane.OTHER), new TimeAxis(0, WIDTH, 60), 31.3));
        BufferedImage picture = picture(17);
        Rectangle2D bar = callOnEdt(() -> view.lanes().bounds(0));
        int left = (int) bar.getMinX();
        int middle = (int) bar.getCenterY();
        assertNotEquals(picture.getRGB(left - 20, middle), picture.getRGB(left + 200, middle), "the bar");
        int now = (int) (31.3 / 60 * WIDTH);
        int otherLane = RULER + 17 + 8;
        assertEquals(accent, picture.getRGB(now, otherLane), "the present time");
        assertNotEquals(accent, picture.getRGB(left - 1, middle));

        runOnEdt(() -> view.select(0, 0));
        assertEquals(accent, picture(17).getRGB(left - 1, middle), "a handle");
    }

    /** Returns how many pixels of a rectangle differ from the one at its upper left corner. */
    private static long paintedPixels(BufferedImage picture, int left, int top, int width, int height) {
        int ground = picture.getRGB(left, top);
        return IntStream.range(0, width * height)
                .filter(i -> picture.getRGB(left + i % width, top + i / width) != ground)
                .count();
    }

    @Test
    void lanesHaveTheirNamesAndColoursAndTheRulerHasTimes() {
        runOnEdt(() -> view.update(List.of(new Lane.SensorLane("left"), Lane.OTHER), new TimeAxis(100, WIDTH, 60), 50));
        BufferedImage picture = picture(17);
        assertEquals(
                Theme.LIGHT.palette().sensorColours(0).fill().getRGB(), picture.getRGB(9, RULER + 8), "the swatch");
        assertTrue(paintedPixels(picture, 20, RULER + 2, 70, 14) > 10, "the name of the sensor");
        assertTrue(paintedPixels(picture, 20, RULER + 19, 70, 14) > 10, "the name of the other lane");
        assertTrue(paintedPixels(picture, 105, 1, 600, RULER - 2) > 10, "the times");
        assertNotEquals(picture.getRGB(50, RULER), picture.getRGB(50, RULER + 1), "the line between the lanes");
    }

    @Test
    void aMarkIsADiamondThatTheSelectionColours() {
        List<TimedCommand> mark = List.of(new TimedCommand(35, new Command.SetPlatform(0.25, 0.2, 0.3)));
        runOnEdt(() -> {
            run.change(old -> old.withSetup(old.setup().withTimeline(mark)));
            view.update(List.of(new Lane.SensorLane("left"), Lane.OTHER), new TimeAxis(0, WIDTH, 60), 0);
        });
        BufferedImage picture = picture(17);
        Rectangle2D bounds = callOnEdt(() -> view.lanes().bounds(0));
        int left = (int) bounds.getMinX();
        int top = (int) bounds.getMinY();
        int size = (int) bounds.getWidth();
        assertTrue(paintedPixels(picture, left - 1, top, size + 2, size / 2) > 10, "the upper half");
        assertTrue(paintedPixels(picture, left - 1, top + size / 2 + 2, size + 2, size / 2 - 2) > 8, "the lower half");
        int accent = Theme.LIGHT.colours().accent().getRGB();
        int middle = (int) bounds.getCenterY();
        assertNotEquals(accent, picture.getRGB(left, middle));
        runOnEdt(() -> view.select(1, 0));
        assertEquals(accent, picture(17).getRGB(left, middle));
    }

    @Test
    void theTimesOfADraggedItemAreInTheRuler() {
        runOnEdt(() -> {
            view.select(0, 0);
            view.setPreview(view.selectedItem().orElseThrow().withTimes(20, 30));
        });
        BufferedImage picture = picture(17);
        int accent = Theme.LIGHT.colours().accent().getRGB();
        int middle = WIDTH * 25 / 60;
        assertTrue(
                IntStream.range(middle - 15, middle + 15)
                                .filter(x -> picture.getRGB(x, 2) == accent)
                                .count()
                        > 20,
                "the label is in the middle of the item");
        assertNotEquals(picture.getRGB(WIDTH * 21 / 60, RULER + 26), picture.getRGB(WIDTH * 19 / 60, RULER + 26));
    }

    @ParameterizedTest
    @ValueSource(doubles = {3.24, 7, 40, 180, 3600})
    void theLabelsOfTheRulerAreAtEqualDistances(double end) {
        Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
        for (int width = 150; width < 1500; width += 50) {
            List<Double> ticks = LanePainter.labelledTicks(new TimeAxis(0, width, end), graphics.getFontMetrics());
            double step = ticks.get(1);
            for (int i = 0; i < ticks.size(); i++) {
                assertEquals(i * step, ticks.get(i), 1e-9, "tick " + i + " of " + ticks);
            }
            assertTrue(step * width / end > 30, "labels of " + ticks + " overlap");
        }
        graphics.dispose();
    }
}
