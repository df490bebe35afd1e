package faultline.app;

import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.TraceWriter;
import faultline.paint.FrameImage;
import faultline.paint.Palette;
import faultline.scenario.AtomicFile;
import faultline.scenario.Journals;
import faultline.scenario.Scenario;
import java.awt.image.BufferedImage;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;

/**
 * The files that a run writes. They are opened before the run, so that one that cannot be written is told at once, and put in place after
 * it, all whole; a run that breaks leaves none.
 */
final class RunOutputs implements AutoCloseable {

    private static final int IMAGE_WIDTH = 1200;
    private static final int LEAST_HEIGHT = 300;
    private static final int MOST_HEIGHT = 2400;

    private final List<AtomicFile> opened = new ArrayList<>();
    private final Optional<AtomicFile> trace;
    private final Optional<AtomicFile> image;
    private final Optional<AtomicFile> journal;
    private final Optional<Writer> traceText;
    private Optional<Frame> last = Optional.empty();

    RunOutputs(RunOptions options) throws IOException {
        try {
            trace = open(options.trace());
            image = open(options.image());
            journal = open(options.journal());
        } catch (IOException e) {
            close();
            throw e;
        }
        traceText = trace.map(file -> new BufferedWriter(new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8)));
    }

    private Optional<AtomicFile> open(Optional<Path> path) throws IOException {
        if (path.isEmpty()) {
            return Optional.empty();
        }
        AtomicFile file = AtomicFile.create(path.get());
        opened.add(file);
        return Optional.of(file);
    }

    /** What has to look at every tick. */
    List<TickObserver> observers() {
        List<TickObserver> observers = new ArrayList<>();
        traceText.ifPresent(writer -> observers.add(new TraceWriter(writer)));
        if (image.isPresent()) {
            observers.add(this::keepLast);
        }
        return observers;
    }

    private void keepLast(Simulation simulation) {
        if (simulation.ticks() == simulation.setup().ticks()) {
            last = Optional.of(simulation.frame());
        }
    }

    /** Writes what is written at the end, and puts every file in its place. */
    void finish(Scenario scenario, long ticks) throws IOException {
        if (traceText.isPresent()) {
            traceText.get().flush();
        }
        if (image.isPresent()) {
            ImageIO.write(picture(last.orElseThrow()), "png", image.get().stream());
        }
        if (journal.isPresent()) {
            Scenario replay = Journals.toScenario(scenario, new Journal(scenario.setup(), List.of(), ticks));
            journal.get().stream().write(replay.toBytes());
        }
        for (AtomicFile file : opened) {
            file.commit();
        }
    }

    private static BufferedImage picture(Frame frame) {
        double height = IMAGE_WIDTH * frame.world().height() / frame.world().width();
        return FrameImage.render(frame, Palette.LIGHT, IMAGE_WIDTH, (int) Math.max(LEAST_HEIGHT, Math.min(MOST_HEIGHT, height)));
    }

    @Override
    public void close() throws IOException {
        for (AtomicFile file : opened) {
            file.close();
        }
    }
}
