package faultline.app;

import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.paint.export.AnimatedGifWriter;
import faultline.paint.export.FilmClock;
import faultline.paint.export.FrameRenderer;
import faultline.paint.surface.Palette;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;

/** Writes a run as an animated GIF that is shown at real time, with its time in each picture. */
final class FilmRecorder implements TickObserver, AutoCloseable {

    private static final int WIDTH = 640;
    /** The time between two pictures, hundredths of a second. */
    private static final int DELAY = 10;

    private final AnimatedGifWriter gif;

    /** Creates a recorder; the stream is not closed. */
    FilmRecorder(OutputStream out) throws IOException {
        gif = new AnimatedGifWriter(out, Palette.LIGHT, DELAY);
    }

    @Override
    public void observe(Simulation simulation) {
        if (!AnimatedGifWriter.isDue(simulation.ticks(), simulation.setup().dt(), DELAY)) {
            return;
        }
        Frame frame = simulation.frame();
        try {
            BufferedImage image =
                    FrameRenderer.render(frame, Palette.LIGHT, WIDTH, FrameRenderer.heightFor(frame, WIDTH));
            FilmClock.paint(image, frame.snapshot().time(), Palette.LIGHT);
            gif.addFrame(image);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() throws IOException {
        gif.close();
    }
}
