package faultline.gui.export;

import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Vector2;
import faultline.gui.document.TaskProgress;
import faultline.paint.export.AnimatedGifWriter;
import faultline.paint.export.RenderRequest;
import faultline.paint.surface.GraphicsSurface;
import faultline.paint.surface.TextStyle;
import faultline.scenario.Scenario;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;

/**
 * Writes an animated GIF of the run so far, at real time. It is made from the ticks of a replay, so no image is missing
 * at any speed of the run. Each image shows its time.
 *
 * @param renderRequest the settings for rendering each image; its frame is replaced
 * @param run completes with the scenario that replays the run
 * @param firstTick the first tick that is shown
 */
record AnimatedGifExport(RenderRequest renderRequest, CompletableFuture<Scenario> run, long firstTick)
        implements FileExport {

    /** The time between two images, hundredths of a second: twenty images per second are enough for a robot. */
    static final int FRAME_DELAY = 5;

    /** The size of the text of the clock, its distance from the edge of the image and the room around it, pixels. */
    private static final int CLOCK_SIZE = 14;

    private static final int CLOCK_MARGIN = 6;
    private static final int CLOCK_PADDING = 4;
    /** The height of the baseline as a share of the size of the text, from above. */
    private static final double CLOCK_BASELINE = 0.85;

    @Override
    public void write(OutputStream out, TaskProgress progress) throws IOException {
        try (AnimatedGifWriter gif = new AnimatedGifWriter(out, renderRequest.palette(), FRAME_DELAY)) {
            HeadlessReplay.run(run, simulation -> addFrame(gif, simulation), progress);
        }
    }

    private void addFrame(AnimatedGifWriter gif, Simulation simulation) throws IOException {
        if (isDue(simulation.ticks(), simulation.setup())) {
            gif.addFrame(image(simulation.frame()));
        }
    }

    /** Returns the image of a frame with its time at the middle of the lower edge, where no legend is. */
    BufferedImage image(Frame frame) {
        BufferedImage image = renderRequest.withFrame(frame).toImage(1);
        TextStyle style = TextStyle.plain(CLOCK_SIZE, renderRequest.palette().text());
        String time = String.format(Locale.ROOT, "%.1f s", frame.snapshot().time());
        double width = style.estimateWidth(time) + 2 * CLOCK_PADDING;
        double height = CLOCK_SIZE + 2 * CLOCK_PADDING;
        double left = (image.getWidth() - width) / 2;
        double top = image.getHeight() - CLOCK_MARGIN - height;
        Graphics2D graphics = image.createGraphics();
        GraphicsSurface surface = new GraphicsSurface(graphics);
        surface.fill(
                new Rectangle2D.Double(left, top, width, height),
                renderRequest.palette().canvas());
        surface.drawText(
                time, new Vector2(left + CLOCK_PADDING, top + CLOCK_PADDING + CLOCK_SIZE * CLOCK_BASELINE), style);
        graphics.dispose();
        return image;
    }

    /** Returns whether a tick is shown. */
    boolean isDue(long tick, SimulationSetup setup) {
        return AnimatedGifWriter.isDue(tick - firstTick, setup.dt(), FRAME_DELAY);
    }
}
