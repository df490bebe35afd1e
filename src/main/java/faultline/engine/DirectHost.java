package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.robot.RobotSpec;

/** Calls the controller on the world's own thread. */
final class DirectHost implements ControllerHost {

    private final Controller controller;
    /** The controller if it is part of the program, otherwise null. */
    private final ConfigurableController builtIn;

    private long tick;
    private double dt;
    private RobotSpec robot;
    private double[] readings;

    DirectHost(Controller controller) {
        this.controller = controller;
        builtIn = controller instanceof ConfigurableController own ? own : null;
    }

    @Override
    public void submit(long newTick, double newDt, RobotSpec newRobot, double[] newReadings) {
        tick = newTick;
        dt = newDt;
        robot = newRobot;
        readings = newReadings;
    }

    @Override
    public Decision await() {
        Decision constant = builtIn == null ? null : builtIn.constantDecision();
        if (constant != null) {
            // Without an observation, for which the virtual machine does not always avoid an object.
            return constant;
        }
        try {
            return controller.decide(new Observation(tick, dt, robot, readings));
        } catch (RunFailedException broken) {
            throw broken;
        } catch (RuntimeException | Error broken) {
            throw new RunFailedException("the controller broke at tick " + tick + ": " + broken, broken);
        }
    }

    @Override
    public void close() {
        // Nothing to end.
    }
}
