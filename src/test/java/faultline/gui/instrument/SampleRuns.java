package faultline.gui.instrument;

import faultline.control.ControllerSpec;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.engine.session.SessionFrame;
import faultline.geometry.Pose;
import faultline.gui.ComponentFinder;
import faultline.sensor.Fault;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JComponent;

/** Frames of a real run with its recording, and images of components without a display. */
final class SampleRuns {

    /** An empty room of 4 m by 3 m; the robot drives at its right wall. */
    static final SimulationSetup ROOM_SETUP = setup(ControllerSpec.WallFollowing.DEFAULT);

    private SampleRuns() {}

    static SimulationSetup setup(ControllerSpec controller) {
        return SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0.2))
                .withController(controller)
                .withTimeline(List.of(
                        new SimulationSetup.TimedCommand(0, new Command.SwitchSensor("rear", false)),
                        new SimulationSetup.TimedCommand(
                                2, new Command.InjectFault("rear-right", new Fault.Stuck(0.4))),
                        new SimulationSetup.TimedCommand(3, new Command.SwitchSensor("nose", true))))
                .withDuration(60);
    }

    static SessionFrame frame(long tick) {
        return frame(ROOM_SETUP, tick);
    }

    static SessionFrame frame(SimulationSetup setup, long tick) {
        try (Session session = Session.replay(new Journal(setup, List.of(), tick), tick, reached -> true)) {
            return session.frame();
        }
    }

    /** Returns an image of a component of the given size. */
    static BufferedImage render(JComponent component, int width, int height) {
        component.setSize(width, height);
        ComponentFinder.layOut(component);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        component.print(graphics);
        graphics.dispose();
        return image;
    }

    /** Counts the pixels of exactly one colour. */
    static long count(BufferedImage image, Color colour) {
        long count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += (image.getRGB(x, y) & 0xFFFFFF) == (colour.getRGB() & 0xFFFFFF) ? 1 : 0;
            }
        }
        return count;
    }
}
