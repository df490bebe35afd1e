package faultline.app;

import faultline.engine.Simulation;
import faultline.engine.TickObserver;
import faultline.engine.session.Pacer;
import java.util.concurrent.locks.LockSupport;

/** Slows a run down to a multiple of real time. */
final class PaceKeeper implements TickObserver {

    private final Pacer pacer = new Pacer();

    PaceKeeper(double pace) {
        pacer.setSpeed(pace);
    }

    @Override
    public void observe(Simulation simulation) {
        if (simulation.ticks() > 0) {
            pacer.tickCompleted(simulation.setup().dt());
        }
        for (long wait = pacer.nanosToWait(); wait > 0; wait = pacer.nanosToWait()) {
            LockSupport.parkNanos(wait);
        }
    }
}
