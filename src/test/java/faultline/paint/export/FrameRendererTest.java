package faultline.paint.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.engine.ControllerMode;
import faultline.engine.Frame;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Sector;
import faultline.geometry.Vector2;
import faultline.paint.surface.Camera;
import faultline.paint.surface.Palette;
import faultline.robot.RobotSpec;
import faultline.scenario.Scenario;
import faultline.scenario.ShippedScenarios;
import faultline.scenario.xml.ScenarioException;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.SensorSnapshot;
import faultline.world.Snapshot;
import faultline.world.WorldSpec;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The cameras of pictures of whole worlds. */
class FrameRendererTest {

    private static final int WIDTH = 528;
    private static final int HEIGHT = 344;

    @Test
    void aCameraWithConesCutsNoneWhereverTheRobotStands() throws ScenarioException {
        SimulationSetup setup = Scenario.loadShipped("beside-a-wall.xml").setup();
        Snapshot first = snapshot(setup);
        double x = first.pose().x();
        boolean cutWithout = false;
        for (double y : new double[] {0.2, first.height() / 2, first.height() - 0.2}) {
            Snapshot world = snapshot(setup.withStart(new Pose(x, y, 1)));
            assertTrue(showsAllCones(FrameRenderer.fitCameraWithCones(world, WIDTH, HEIGHT), world), "y " + y);
            cutWithout |= !showsAllCones(FrameRenderer.fitCamera(world, WIDTH, HEIGHT), world);
        }
        assertTrue(cutWithout, "the world alone is not always enough");
    }

    /** A picture is at most twice as high as wide and at least a quarter as high. */
    @ParameterizedTest
    @CsvSource({"4, 3, 600", "3, 4, 1066", "3, 6, 1600", "3, 9, 1600", "8, 2, 200", "12, 2, 200"})
    void aPictureHasTheProportionsOfItsWorldIfTheyAreUsual(double width, double height, int pixels) {
        SimulationSetup setup = SimulationSetup.of(
                new WorldSpec(width, height, true, 0, List.of()), new Pose(width / 2, height / 2, 0));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            assertEquals(pixels, FrameRenderer.heightFor(simulation.frame(), 800));
        }
    }

    @Test
    void theCameraOfARobotInTheMiddleIsThatOfTheWorld() throws ScenarioException, IOException {
        int same = 0;
        for (String name : ShippedScenarios.names()) {
            Snapshot world = snapshot(Scenario.loadShipped(name).setup());
            Camera plain = FrameRenderer.fitCamera(world, WIDTH, HEIGHT);
            Camera camera = FrameRenderer.fitCameraWithCones(world, WIDTH, HEIGHT);
            assertFalse(camera.scale() > plain.scale(), name);
            same += camera.equals(plain) ? 1 : 0;
        }
        assertTrue(same > 5, "only " + same);
    }

    /** It leaves a small open world, and then comes back into it. */
    @Test
    void aRobotOutsideOfAnOpenWorldAndItsPathAreInThePicture() {
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(1, 1, false, 3, List.of()), new Pose(0.5, 0.5, 0))
                .withController(new ControllerSpec.Drive(3, 3));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            ticks(simulation, 1000);
            assertTrue(simulation.pose().x() > 2, () -> "x " + simulation.pose());
            Vector2 front = simulation.pose().toParent(new Vector2(RobotSpec.DEFAULT.length() / 2, 0));
            Frame outside = simulation.frame();
            assertTrue(shows(FrameRenderer.fitCamera(outside.snapshot(), WIDTH, HEIGHT), front));
            assertTrue(shows(camera(outside), front));
            simulation.execute(new Command.ConfigureController(new ControllerSpec.Drive(-3, -3)));
            ticks(simulation, 1000);
            assertTrue(simulation.pose().x() < 1, () -> "x " + simulation.pose());
            assertTrue(shows(camera(simulation.frame()), front.minus(new Vector2(0.2, 0))));
            assertFalse(shows(FrameRenderer.fitCamera(simulation.frame().snapshot(), WIDTH, HEIGHT), front));
        }
    }

    private static Camera camera(Frame frame) {
        return FrameRenderer.request(frame, Palette.LIGHT, WIDTH, HEIGHT).camera();
    }

    private static void ticks(Simulation simulation, int count) {
        for (int i = 0; i < count; i++) {
            simulation.tick();
        }
    }

    private static boolean shows(Camera camera, Vector2 point) {
        Vector2 pixel = camera.toScreen(point);
        return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= WIDTH && pixel.y() <= HEIGHT;
    }

    /** Each circle has a radius of 1.5 m. */
    @ParameterizedTest
    @CsvSource({
        "5, 4, 0, 0, 10, 8",
        "1, 4, -0.5, 0, 10, 8",
        "5, 1, 0, -0.5, 10, 8",
        "9, 4, 0, 0, 10.5, 8",
        "5, 7, 0, 0, 10, 8.5",
        "-3, 12, -4.5, 0, 10, 13.5"
    })
    void aPictureShowsTheWorldAndWhatIsOutsideOfIt(
            double x, double y, double left, double bottom, double right, double top) {
        Obstacle circle = new Obstacle("pole", new ObstacleShape.CircleShape(1.5), new Pose(x, y, 0));
        Snapshot world =
                snapshot(SimulationSetup.of(new WorldSpec(10, 8, false, 0, List.of(circle)), new Pose(0.5, 7.5, 0)));
        Rectangle2D shown = new Rectangle2D.Double(left, bottom, right - left, top - bottom);
        assertEquals(Camera.fit(shown, 24, WIDTH, HEIGHT), FrameRenderer.fitCamera(world, WIDTH, HEIGHT));
    }

    private static Snapshot snapshot(SimulationSetup setup) {
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            return simulation.frame().snapshot();
        }
    }

    private static boolean showsAllCones(Camera camera, Snapshot world) {
        return world.sensors().stream().map(SensorSnapshot::sector).allMatch(cone -> shows(camera, cone));
    }

    /** Returns whether points all along the arc are in the picture. */
    private static boolean shows(Camera camera, Sector cone) {
        double half = Math.atan2(cone.sinHalf(), cone.cosHalf());
        for (double share = -1; share <= 1; share += 0.1) {
            double bearing = cone.axis().angle() + share * half;
            Vector2 end =
                    cone.apex().plus(new Vector2(cone.range() * Math.cos(bearing), cone.range() * Math.sin(bearing)));
            if (!shows(camera, end)) {
                return false;
            }
        }
        return true;
    }
}
