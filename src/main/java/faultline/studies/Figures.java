package faultline.studies;

import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
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

/** Writes all figures and studies, on all cores. */
public final class Figures {

    private Figures() {}

    /** Listens to the progress. */
    @FunctionalInterface
    public interface FigureListener {

        /**
         * Called on the caller's thread when a figure is written.
         *
         * @param done the number of figures written
         * @param all the number of figures
         */
        void figureWritten(int done, int all);
    }

    static List<Figure> allFigures() {
        List<Figure> figures = new ArrayList<>();
        // The longest first, so that no core is idle at the end.
        figures.add(new AlignmentErrors());
        figures.add(new CornerAngleSweep());
        figures.add(new NoiseInRandomRooms());
        figures.add(new NoiseWhileFollowing());
        figures.add(new ControlPanelFigure());
        figures.add(new DriveMotions());
        figures.add(new PoseAndReferenceFrames());
        figures.add(new WallPositioning());
        figures.add(new EnvironmentPath("fig5-indoor", "office.xml", new Rectangle2D.Double(-0.1, -0.1, 8.2, 6.2)));
        figures.add(new EnvironmentPath("fig5-outdoor", "yard.xml", new Rectangle2D.Double(0.5, 0.8, 10.5, 7.4)));
        figures.add(new CornerPlans());
        figures.add(new StateDiagramFigure());
        figures.addAll(EquationFour.sweeps());
        figures.add(new HypercubeStudy());
        figures.add(new MotorMismatch());
        figures.add(new OtherSensorFaults());
        figures.add(new GainsMap());
        figures.add(new StepResponse());
        figures.add(new SpecularMap());
        figures.add(new ThinObjects());
        figures.add(
                new EnvironmentPath("rules-glass", "glass-partition.xml", new Rectangle2D.Double(1.9, 0.5, 3, 2.8)));
        figures.add(new EnvironmentPath("rules-mirror", "mirror.xml", new Rectangle2D.Double(1.9, 0.5, 3, 2.8)));
        figures.add(new EnvironmentPath(
                "rules-table-leg", "pole-and-table-leg.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        figures.add(new EnvironmentPath("rules-cable", "cable.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        figures.add(
                new EnvironmentPath("rules-noise", "noisy-sensors.xml", new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2)));
        return figures;
    }

    /**
     * Writes all figures.
     *
     * @param path the folder; created if necessary
     * @param appearance of the pictures
     * @param progress called for each figure
     * @throws IOException if a file cannot be written
     */
    public static void writeAll(Path path, SvgTheme appearance, FigureListener progress) throws IOException {
        writeAll(FigureFolder.create(path, appearance), allFigures(), progress);
    }

    static void writeAll(FigureFolder folder, List<Figure> figures, FigureListener progress) throws IOException {
        ExecutorService workers =
                Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<Future<?>> futures = new ArrayList<>();
            figures.forEach(figure -> futures.add(workers.submit(() -> writeAll(figure, folder))));
            for (int i = 0; i < futures.size(); i++) {
                await(futures.get(i));
                progress.figureWritten(i + 1, futures.size());
            }
        } finally {
            workers.shutdownNow();
        }
    }

    private static void writeAll(Figure figure, FigureFolder folder) {
        try {
            figure.write(folder);
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
