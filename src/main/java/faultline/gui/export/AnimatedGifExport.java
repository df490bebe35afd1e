package faultline.gui.export;

import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.paint.export.AnimatedGifWriter;
import faultline.paint.export.RenderRequest;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;

/**
 * A film of a stretch of the run so far, as fast as real time. It is made of the run's own ticks, so no picture is lost
 * however fast the run was.
 *
 * @param renderRequest how each picture is taken; its own frame does not matter
 * @param run completed with the scenario that replays it
 * @param firstTick the first tick that shows
 */
record AnimatedGifExport(RenderRequest renderRequest, CompletableFuture<Scenario> run, long firstTick)
        implements FileExport {

    /** Hundredths of a second between two pictures: twenty of them in a second, more than enough for a robot. */
    static final int FRAME_DELAY = 5;

    @Override
    public void write(OutputStream out, ProgressListener progress) throws IOException {
        HeadlessReplay replay = HeadlessReplay.of(run);
        try (AnimatedGifWriter film = new AnimatedGifWriter(out, renderRequest.palette(), FRAME_DELAY)) {
            replay.run(simulation -> addFrame(film, simulation), progress);
        }
    }

    private void addFrame(AnimatedGifWriter film, Simulation simulation) throws IOException {
        if (isDue(simulation.ticks(), simulation.setup())) {
            film.addFrame(renderRequest.withFrame(simulation.frame()).toImage(1));
        }
    }

    /** Whether a picture is taken at a tick: the first one, and the first of each stretch of the delay's length. */
    boolean isDue(long tick, SimulationSetup setup) {
        return tick == firstTick || tick > firstTick && frameIndex(tick, setup) > frameIndex(tick - 1, setup);
    }

    private long frameIndex(long tick, SimulationSetup setup) {
        return (long) Math.floor((tick - firstTick) * setup.dt() * 100 / FRAME_DELAY + 1e-6);
    }
}
