package faultline.engine;

import java.util.OptionalDouble;

/** Coverage and distance error from ground truth. */
final class WallRecord implements TickObserver {

    WallRecord(Setup setup) {
    }

    @Override
    public void observe(Simulation simulation) {
    }

    OptionalDouble coverage() {
        return OptionalDouble.empty();
    }

    OptionalDouble distanceRms() {
        return OptionalDouble.empty();
    }
}
