package faultline.app;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.session.Pacer;
import java.util.concurrent.locks.LockSupport;

/** Slows a run down to a multiple of real time, from its first observation on. */
final class PaceKeeper implements TickObserver {

    private final double pace;
    /** Null until the first observation. */
    private Pacer pacer;

    PaceKeeper(double pace) {
        this.pace = pace;
    }

    @Override
    public void observe(Simulation simulation) {
        if (pacer == null) {
            pacer = new Pacer();
            pacer.setSpeed(pace);
            return;
        }
        pacer.tickCompleted(simulation.setup().dt());
        for (long wait = pacer.nanosToWait(); wait > 0; wait = pacer.nanosToWait()) {
            LockSupport.parkNanos(wait);
        }
    }
}
