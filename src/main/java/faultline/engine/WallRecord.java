package faultline.engine;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.geometry.Vec;
import faultline.world.WallMap;
import java.util.OptionalDouble;

/**
 * Judges a wall follower from ground truth: how much of the wall it could follow it did follow, and how well it kept the distance. Of other
 * controllers it says nothing.
 */
final class WallRecord implements TickObserver {

    /** A straight piece of wall begins and ends this far from a wall's ends, metres. */
    static final double STRAIGHT_MARGIN = 0.5;

    private final boolean follows;
    private final double distance;
    private final WallMap walls;
    private final Coverage coverage;
    private double squares;
    private long counted;

    WallRecord(Setup setup) {
        follows = setup.controller() instanceof ControllerSpec.WallFollowing;
        walls = new WallMap(setup.world());
        distance = setup.controller() instanceof ControllerSpec.WallFollowing wall ? wall.distance() + setup.robot().width() / 2 : 0;
        coverage = new Coverage(walls, distance);
    }

    @Override
    public void observe(Simulation simulation) {
        if (!follows || simulation.collision().isPresent()) {
            return;
        }
        Vec centre = simulation.pose().position();
        String state = simulation.telemetry().state();
        if (state.equals(FollowerState.FOLLOW.name()) || state.equals(FollowerState.ROUND.name())) {
            coverage.visit(centre);
        }
        if (state.equals(FollowerState.FOLLOW.name())) {
            addError(walls.errorOnStraight(centre, distance, STRAIGHT_MARGIN));
        }
    }

    private void addError(double error) {
        if (!Double.isNaN(error)) {
            squares += error * error;
            counted++;
        }
    }

    /** The share of the wall that was passed, in [0, 1]; empty where no wall was followed. */
    OptionalDouble coverage() {
        return follows ? coverage.share() : OptionalDouble.empty();
    }

    /** The distance error on straight walls while following, metres, root mean square; empty where there was none. */
    OptionalDouble distanceRms() {
        return counted == 0 ? OptionalDouble.empty() : OptionalDouble.of(StrictMath.sqrt(squares / counted));
    }
}
