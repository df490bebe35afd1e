package faultline.gui.export;

import faultline.engine.Simulation;
import faultline.gui.document.TaskProgress;
import faultline.paint.export.AnimatedGifWriter;
import faultline.paint.export.FilmRenderer;
import faultline.paint.export.RenderRequest;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;

/**
 * Writes an animated GIF of the run so far from a tick on, at real time. It is made from the ticks of a replay, so no
 * image is missing at any speed of the run. Each image shows its time.
 */
record AnimatedGifExport(RenderRequest renderRequest, CompletableFuture<Scenario> run, long firstTick)
        implements FileExport {

    /**
     * The shortest time between two images, hundredths of a second: twenty images per second are enough for a robot.
     */
    static final int FRAME_DELAY = 5;

    @Override
    public void write(OutputStream out, TaskProgress progress) throws IOException {
        FilmRenderer renderer = new FilmRenderer();
        try (AnimatedGifWriter gif = new AnimatedGifWriter(
                out,
                renderRequest.palette(),
                renderRequest.frame().snapshot().robot().sensors().size())) {
            HeadlessReplay.run(run, simulation -> addFrame(gif, renderer, simulation), progress);
        }
    }

    private void addFrame(AnimatedGifWriter gif, FilmRenderer renderer, Simulation simulation) throws IOException {
        int delay = AnimatedGifWriter.delayOf(
                simulation.ticks() - firstTick, simulation.setup().dt(), FRAME_DELAY);
        if (delay > 0) {
            gif.addFrame(renderer.render(renderRequest.withFrame(simulation.frame())), delay);
        }
    }
}
