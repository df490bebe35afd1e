package faultline.engine;

import faultline.control.Controller;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.PeriodicController;
import faultline.robot.RobotSpec;

/** Calls the controller on the simulation thread. */
final class DirectHost implements ControllerHost {

    private final Controller controller;
    /** The controller if its decisions hold for some ticks, otherwise null. */
    private final PeriodicController periodic;

    private long tick;
    private double dt;
    private RobotSpec robot;
    private double[] readings;

    DirectHost(Controller controller) {
        this.controller = controller;
        periodic = controller instanceof PeriodicController holding ? holding : null;
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
        Decision held = periodic == null ? null : periodic.heldDecision(tick, dt);
        if (held != null) {
            // No observation is created, because the virtual machine does not always avoid the allocation.
            return held;
        }
        try {
            return controller.decide(new Observation(tick, dt, robot, readings));
        } catch (OutOfMemoryError full) {
            // A controller in Java of a user is called on a thread of its own, so this one is part of the program.
            throw full;
        } catch (RuntimeException | Error broken) {
            throw RunFailedException.ofController(tick, broken);
        }
    }

    @Override
    public void close() {
        // Nothing to end.
    }
}
