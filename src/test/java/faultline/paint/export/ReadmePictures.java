package faultline.paint.export;

import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.Journal;
import faultline.engine.Simulation;
import faultline.engine.session.ReferenceRun;
import faultline.geometry.Vector2;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ReferenceOverlay;
import faultline.paint.scene.SceneLabels;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import faultline.sensor.Fault;
import faultline.world.Command;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;

/**
 * Writes the pictures of the README that show no window: a run with two faults beside one without, and a film of a
 * sensor that dies. {@code src/conf/screenshots} runs it. Argument: a folder.
 */
public final class ReadmePictures {

    private static final double FAULTS_AT = 36;
    private static final double SHOWN_AT = 46;
    /** The distance at which the two runs differ visibly, metres. */
    private static final double VISIBLE = 0.01;

    private static final int FILM_WIDTH = 480;
    /** The time between two pictures of the film, hundredths of a second. */
    private static final int FILM_DELAY = 15;

    private ReadmePictures() {}

    public static void main(String[] arguments) throws IOException, ScenarioException {
        Path folder = Files.createDirectories(Path.of(arguments[0]));
        ImageIO.write(
                twoFaults().toImage(1), "png", folder.resolve("two-faults.png").toFile());
        try (OutputStream out = Files.newOutputStream(folder.resolve("front-sensor-dies.gif"))) {
            writeFilm(out);
        }
    }

    static RenderRequest twoFaults() throws ScenarioException {
        Scenario office = Scenario.loadShipped("office.xml");
        Simulation run = new Simulation(office.setup(), ControllerMode.DIRECT);
        long ticks = Math.round(SHOWN_AT / office.setup().dt());
        ReferenceRun ghost = ReferenceRun.replay(new Journal(office.setup(), List.of(), ticks + 1), tick -> true);
        while (run.time() < FAULTS_AT) {
            run.tick();
        }
        run.execute(new Command.InjectFault("front-left", new Fault.Stuck(0.55)));
        run.execute(new Command.InjectFault("left", new Fault.Bias(0.08)));
        long differs = ticks;
        while (run.ticks() < ticks) {
            run.tick();
            double apart =
                    run.pose().position().distanceTo(ghost.pose(run.ticks()).position());
            differs = apart > VISIBLE ? Math.min(differs, run.ticks()) : differs;
        }
        ReferenceOverlay overlay = new ReferenceOverlay(
                ghost,
                List.of("Ghost: the same run without faults"),
                List.of(new ReferenceOverlay.Mark(
                        differs,
                        String.format(
                                Locale.ROOT,
                                "1 cm apart at %.1f s",
                                differs * office.setup().dt()))));
        return request(run.frame(), ghost.pose(ticks).position(), overlay);
    }

    private static RenderRequest request(Frame frame, Vector2 ghost, ReferenceOverlay overlay) {
        Vector2 middle = frame.snapshot().pose().position().plus(ghost).times(0.5);
        return new RenderRequest(
                frame,
                new Camera(middle.x() + 0.2, middle.y() - 0.45, 140, 880, 520),
                Palette.LIGHT,
                new ScenePainter(Layer.defaults(), SceneLabels.ENGLISH),
                List.of(overlay));
    }

    /** Writes the seconds around the fault of a shipped scenario. */
    private static void writeFilm(OutputStream out) throws IOException, ScenarioException {
        Simulation run =
                new Simulation(Scenario.loadShipped("front-sensor-dies.xml").setup(), ControllerMode.DIRECT);
        try (AnimatedGifWriter film = new AnimatedGifWriter(out, Palette.LIGHT, 8)) {
            while (run.time() < 33) {
                run.tick();
                int delay = AnimatedGifWriter.delayOf(run.ticks(), run.setup().dt(), FILM_DELAY);
                if (run.time() >= 21 && delay > 0) {
                    Frame frame = run.frame();
                    film.addFrame(
                            FrameRenderer.render(
                                    frame, Palette.LIGHT, FILM_WIDTH, FrameRenderer.heightFor(frame, FILM_WIDTH)),
                            delay);
                }
            }
        }
    }
}
