package faultline.studies;

import faultline.paint.surface.SvgTheme;
import faultline.studies.figure.Figure;
import faultline.studies.figure.FigureFolder;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Writes all figures and studies, on all cores. */
public final class Figures {

    private Figures() {}

    /** Receives the progress. */
    @FunctionalInterface
    public interface FigureListener {

        /**
         * Called on the caller's thread when a figure is written, with the number of figures written so far and the
         * total number.
         */
        void figureWritten(int done, int all);
    }

    static List<Figure> allFigures() {
        List<Figure> figures = new ArrayList<>();
        // The slowest figures are first, so that no core is idle at the end.
        figures.add(new AlignmentErrors());
        figures.add(new CornerAngleSweep());
        figures.add(new NoiseInRandomRooms());
        figures.add(new NoiseWhileFollowing());
        figures.add(new ControlPanelFigure());
        figures.add(new DriveMotions());
        figures.add(new PoseAndReferenceFrames());
        figures.add(new WallPositioning());
        figures.add(new CornerPlans());
        figures.add(new StateDiagramFigure());
        figures.addAll(environments());
        figures.addAll(EquationFour.sweeps());
        figures.add(new HypercubeStudy());
        figures.add(new MotorMismatch());
        figures.add(new OtherSensorFaults());
        figures.add(new GainsMap());
        figures.add(new StepResponse());
        figures.add(new SpecularMap());
        figures.add(new ThinObjects());
        return figures;
    }

    private static List<Figure> environments() {
        Rectangle2D room = new Rectangle2D.Double(-0.1, -0.1, 6.2, 4.2);
        return List.of(
                new PathFigure(
                        "fig5-indoor", "Fig. 5, indoors", "office.xml", new Rectangle2D.Double(-0.1, -0.1, 8.2, 6.2)),
                new PathFigure(
                        "fig5-outdoor", "Fig. 5, outdoors", "yard.xml", new Rectangle2D.Double(0.5, 0.8, 10.5, 7.4)),
                new PathFigure("rules-glass", "A glossy partition whose end is not seen", "glass-partition.xml", room),
                new PathFigure("rules-mirror", "A mirror", "mirror.xml", room),
                new PathFigure("rules-table-leg", "A pole and a table leg", "pole-and-table-leg.xml", room),
                new PathFigure("rules-cable", "Cables that hang into the way", "cable.xml", room),
                new PathFigure("rules-noise", "Noise of 4 mm on all sensors", "noisy-sensors.xml", room));
    }

    /**
     * Writes all figures to a folder, which is created if necessary, and calls the listener for each. The files take
     * their places together when all are written.
     */
    public static void writeAll(Path path, SvgTheme appearance, FigureListener progress) throws IOException {
        writeAll(path, appearance, allFigures(), Runtime.getRuntime().availableProcessors(), progress);
    }

    /** Writes some figures, as many at the same time as there are threads. */
    static void writeAll(Path path, SvgTheme appearance, List<Figure> figures, int threads, FigureListener progress)
            throws IOException {
        ExecutorService workers = Executors.newFixedThreadPool(threads);
        try (FigureFolder folder = FigureFolder.create(path, appearance)) {
            CompletionService<Void> written = new ExecutorCompletionService<>(workers);
            for (Figure figure : figures) {
                written.submit(() -> {
                    figure.write(folder);
                    return null;
                });
            }
            for (int i = 0; i < figures.size(); i++) {
                awaitNext(written);
                progress.figureWritten(i + 1, figures.size());
            }
            folder.commit();
        } finally {
            workers.shutdownNow();
        }
    }

    /** Waits for the next figure, whichever it is, so that a failure is reported at once. */
    private static void awaitNext(CompletionService<Void> written) throws IOException {
        try {
            written.take().get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("the figures were interrupted", e);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof IOException failure) {
                throw failure;
            }
            throw new IllegalStateException(e.getCause());
        }
    }
}
