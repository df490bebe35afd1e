package faultline.app.figures;

import faultline.paint.plot.Appearance;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** All figures and studies, and how they are made: on every core, each by itself. */
public final class Figures {

    private Figures() {
    }

    /** Told how far the work is. */
    @FunctionalInterface
    public interface Progress {

        /**
         * Called on the caller's thread when a figure is done.
         *
         * @param done how many figures are
         * @param all how many there are to be
         */
        void made(int done, int all);
    }

    static List<Figure> all() {
        List<Figure> figures = new ArrayList<>();
        // The longest first, so that no core waits for it in the end.
        figures.add(new NoiseWhileFollowing());
        figures.add(new PanelPicture());
        figures.add(new DriveMoves());
        figures.add(new PoseAndFrames());
        figures.add(new WallFrames());
        figures.add(new Environment("fig5-indoor", "office.xml", new Rectangle2D.Double(-0.1, -0.1, 8.2, 6.2)));
        figures.add(new Environment("fig5-outdoor", "yard.xml", new Rectangle2D.Double(0.5, 0.8, 10.5, 7.4)));
        figures.add(new CornerViews());
        figures.add(new CornerSweep());
        figures.add(new StateChart());
        figures.addAll(EquationFour.sweeps());
        figures.add(new OtherSensors());
        figures.add(new GainsMap());
        figures.add(new StepResponse());
        figures.add(new SpecularMap());
        figures.add(new ThinObjects());
        figures.add(new Environment("rules-glass", "glass-partition.xml", new Rectangle2D.Double(1.9, 0.5, 3, 2.8)));
        figures.add(new Environment("rules-mirror", "mirror.xml", new Rectangle2D.Double(1.9, 0.5, 3, 2.8)));
        figures.add(new Environment("rules-table-leg", "pole-and-table-leg.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        figures.add(new Environment("rules-cable", "cable.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        figures.add(new Environment("rules-noise", "noisy-sensors.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        return figures;
    }

    /**
     * Makes all figures.
     *
     * @param path the folder; made where it is not there
     * @param appearance of the pictures
     * @param progress told of each figure
     * @throws IOException if a file cannot be written
     */
    public static void make(Path path, Appearance appearance, Progress progress) throws IOException {
        make(FigureFolder.at(path, appearance), all(), progress);
    }

    static void make(FigureFolder folder, List<Figure> figures, Progress progress) throws IOException {
        ExecutorService workers = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<Future<?>> futures = new ArrayList<>();
            figures.forEach(figure -> futures.add(workers.submit(() -> make(figure, folder))));
            for (int i = 0; i < futures.size(); i++) {
                await(futures.get(i));
                progress.made(i + 1, futures.size());
            }
        } finally {
            workers.shutdownNow();
        }
    }

    private static void make(Figure figure, FigureFolder folder) {
        try {
            figure.make(folder);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void await(Future<?> future) throws IOException {
        try {
            future.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the figures were interrupted", e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof UncheckedIOException unwritten) {
                throw unwritten.getCause();
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
