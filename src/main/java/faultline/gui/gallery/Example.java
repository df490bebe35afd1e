package faultline.gui.gallery;

import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.gui.canvas.LocalizedLabels;
import faultline.gui.text.Messages;
import faultline.paint.export.FrameRenderer;
import faultline.paint.export.RenderRequest;
import faultline.paint.scene.Layer;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import faultline.scenario.xml.ScenarioException;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/**
 * An example scenario, with texts in the user's language and an image of the run, {@link #WIDTH} by {@link #HEIGHT}
 * times {@link #RESOLUTION_SCALE}.
 */
record Example(String file, String title, String description, BufferedImage thumbnail) {

    static final int WIDTH = 264;
    static final int HEIGHT = 172;
    static final int RESOLUTION_SCALE = 2;

    /** The simulated time of the thumbnail, seconds: late enough to show the point of the example. */
    private static final double SIMULATED_SECONDS = 25;
    /** Small enough to leave room for the report of a collision in every language. */
    private static final Font FONT = DrawContext.DEFAULT_FONT.deriveFont(0.9F * DrawContext.DEFAULT_FONT.getSize2D());

    private static final Set<Layer> LAYERS = EnumSet.of(Layer.PATH, Layer.CONES, Layer.ROUTES);

    /** Loads an example and renders its thumbnail; takes some time. */
    static Example load(String file, Palette palette) throws ScenarioException {
        Scenario scenario = Scenario.loadShipped(file);
        String key = file.substring(0, file.lastIndexOf('.'));
        return new Example(
                file,
                Messages.exampleText(key + ".title", scenario.name()),
                Messages.exampleText(key + ".text", scenario.description()),
                thumbnail(frame(scenario), palette));
    }

    private static Frame frame(Scenario scenario) {
        try (Simulation simulation = new Simulation(scenario.setup(), ControllerMode.DIRECT)) {
            long ticks = scenario.setup()
                    .tickAt(Math.min(SIMULATED_SECONDS, scenario.setup().duration()));
            while (simulation.ticks() < ticks) {
                simulation.tick();
            }
            return simulation.frame();
        }
    }

    private static BufferedImage thumbnail(Frame frame, Palette palette) {
        Camera camera =
                FrameRenderer.fitCameraWithCones(frame.snapshot(), WIDTH * RESOLUTION_SCALE, HEIGHT * RESOLUTION_SCALE);
        return new RenderRequest(
                        frame, camera, palette, new ScenePainter(LAYERS, LocalizedLabels.create(FONT)), List.of())
                .toImage(1);
    }
}
