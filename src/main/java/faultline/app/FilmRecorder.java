package faultline.app;

import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.paint.export.AnimatedGifWriter;
import faultline.paint.export.FilmBounds;
import faultline.paint.export.FilmRenderer;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Palette;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;

/** Writes a run as an animated GIF that is shown at real time, with its time in each picture. */
final class FilmRecorder implements TickObserver, AutoCloseable {

    private static final int WIDTH = 640;
    /** The shortest time between two pictures, hundredths of a second. */
    private static final int DELAY = 10;

    private final OutputStream out;
    /** Null before the first picture. */
    private AnimatedGifWriter gif;

    private final FilmRenderer renderer = new FilmRenderer();
    private final FilmBounds bounds = new FilmBounds();

    /** Creates a recorder; the stream is not closed. */
    FilmRecorder(OutputStream out) {
        this.out = out;
    }

    @Override
    public void observe(Simulation simulation) {
        int delay =
                AnimatedGifWriter.delayOf(simulation.ticks(), simulation.setup().dt(), DELAY);
        if (delay == 0) {
            return;
        }
        Frame frame = simulation.frame();
        try {
            if (gif == null) {
                gif = new AnimatedGifWriter(
                        out, Palette.LIGHT, simulation.setup().robot().sensors().size());
            }
            Rectangle2D shown = bounds.next(FrameRenderer.bounds(frame.snapshot()));
            int height = FrameRenderer.heightFor(frame, WIDTH);
            gif.addFrame(renderer.render(FrameRenderer.request(frame, shown, Palette.LIGHT, WIDTH, height)), delay);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        if (gif != null) {
            gif.close();
        }
    }
}
