package faultline.gui.gallery;

import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.gui.canvas.PictureWords;
import faultline.gui.text.Texts;
import faultline.paint.Brush;
import faultline.paint.Camera;
import faultline.paint.FrameImage;
import faultline.paint.Layer;
import faultline.paint.Palette;
import faultline.paint.ScenePainter;
import faultline.paint.Shot;
import faultline.scenario.Scenario;
import faultline.scenario.ScenarioException;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/**
 * One example.
 *
 * @param file its name, for {@link Scenario#shipped(String)}
 * @param title for people
 * @param description for people
 * @param picture some while into its run, {@link #WIDTH} by {@link #HEIGHT} at {@link #FINENESS}
 */
record Example(String file, String title, String description, BufferedImage picture) {

    static final int WIDTH = 208;
    static final int HEIGHT = 136;
    static final int FINENESS = 2;

    /** How long the robot drives before its picture is taken, seconds: far enough to show what it is about. */
    private static final double SECONDS = 25;
    /** Small enough for the report of a collision to have room in any language. */
    private static final Font FONT = Brush.FONT.deriveFont(0.9F * Brush.FONT.getSize2D());
    private static final Set<Layer> LAYERS = EnumSet.of(Layer.PATH, Layer.CONES, Layer.ROUTES);

    /** Reads and runs an example; slow. */
    static Example of(String file, Palette palette) throws ScenarioException {
        Scenario scenario = Scenario.shipped(file);
        String key = file.substring(0, file.lastIndexOf('.'));
        return new Example(file, Texts.ofExample(key + ".title", scenario.name()), Texts.ofExample(key + ".text", scenario.description()),
                picture(frame(scenario), palette));
    }

    private static Frame frame(Scenario scenario) {
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            long ticks = scenario.setup().tickAt(Math.min(SECONDS, scenario.setup().duration()));
            while (simulation.ticks() < ticks) {
                simulation.tick();
            }
            return simulation.frame();
        }
    }

    private static BufferedImage picture(Frame frame, Palette palette) {
        Camera camera = FrameImage.camera(frame.world(), WIDTH * FINENESS, HEIGHT * FINENESS);
        return new Shot(frame, camera, palette, new ScenePainter(LAYERS, PictureWords.spoken(FONT)), Optional.empty()).image(1);
    }
}
