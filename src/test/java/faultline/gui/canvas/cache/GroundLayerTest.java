package faultline.gui.canvas.cache;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.paint.export.FrameRenderer;
import faultline.paint.scene.SceneLabels;
import faultline.paint.scene.ScenePainter;
import faultline.paint.surface.Camera;
import faultline.paint.surface.DrawContext;
import faultline.paint.surface.Palette;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class GroundLayerTest {

    private static final List<Obstacle> BOXES = Stream.of("a", "b", "c")
            .map(id -> new Obstacle(
                    id, new ObstacleShape.RectangleShape(0.5, 0.5), new Pose(id.charAt(0) - 'a' + 1, 2, 0)))
            .toList();

    @Test
    void onlyMarkedObstaclesCostMore() {
        double plain = cost(Set.of());
        double one = cost(Set.of("b")) - plain;
        assertTrue(one > 0);
        assertEquals(3 * one, cost(Set.of("a", "b", "c")) - plain, 1e-9);
    }

    /** Returns the share of a frame that three equal boxes cost, some of which are marked. */
    private static double cost(Set<String> marked) {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, BOXES), new Pose(2, 1, 0));
        BufferedImage image = new BufferedImage(400, 300, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        FrameBudget budget = new FrameBudget(() -> 0);
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            Snapshot world = simulation.snapshot();
            Camera camera = FrameRenderer.fitCamera(world, image.getWidth(), image.getHeight());
            new GroundLayer(world, BOXES, marked, new ScenePainter(Set.of(), SceneLabels.ENGLISH))
                    .paint(new DrawContext(graphics, camera, Palette.LIGHT), camera.bounds(), 0, budget);
        }
        graphics.dispose();
        return 1 - budget.remaining();
    }
}
