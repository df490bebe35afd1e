package faultline.gui.export;

import faultline.engine.Setup;
import faultline.engine.Simulation;
import faultline.paint.GifFilm;
import faultline.paint.Shot;
import faultline.scenario.Scenario;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.CompletableFuture;

/**
 * A film of a stretch of the run so far, as fast as real time. It is made of the run's own ticks, so no picture is lost however fast the
 * run was.
 *
 * @param shot how each picture is taken; its own frame does not matter
 * @param run completed with the scenario that replays it
 * @param from the first tick that shows
 */
record FilmExport(Shot shot, CompletableFuture<Scenario> run, long from) implements Export {

    /** Hundredths of a second between two pictures: twenty of them in a second, more than enough for a robot. */
    static final int DELAY = 5;

    @Override
    public void write(OutputStream out, Progress progress) throws IOException {
        Replay replay = Replay.of(run);
        try (GifFilm film = new GifFilm(out, shot.palette(), DELAY)) {
            replay.run(simulation -> add(film, simulation), progress);
        }
    }

    private void add(GifFilm film, Simulation simulation) throws IOException {
        if (isDue(simulation.ticks(), simulation.setup())) {
            film.add(shot.of(simulation.frame()).image(1));
        }
    }

    /** Whether a picture is taken at a tick: the first one, and the first of each stretch of the delay's length. */
    boolean isDue(long tick, Setup setup) {
        return tick == from || tick > from && picture(tick, setup) > picture(tick - 1, setup);
    }

    private long picture(long tick, Setup setup) {
        return (long) Math.floor((tick - from) * setup.dt() * 100 / DELAY + 1e-6);
    }
}
