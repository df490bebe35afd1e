package faultline.control.wallfollower;

import faultline.control.FollowerState;
import faultline.control.Threshold;
import faultline.geometry.Angles;
import faultline.robot.Velocity;

/** TURN, MEASURE and ALIGN: the three parts of the alignment manoeuvre. */
final class SpinStates {

    private final StateEstimate estimate;
    private final AlignmentManoeuvre alignment;
    private double startHeading = Double.NaN;

    SpinStates(StateEstimate estimate, AlignmentManoeuvre alignment) {
        this.estimate = estimate;
        this.alignment = alignment;
    }

    /** Returns TURN: spins right until the left sensor reaches the wall. */
    StateBehaviour turn() {
        return new StateBehaviour() {
            @Override
            public void enter(FollowerState from) {
                boolean searched = from == FollowerState.SEARCH;
                startHeading = searched ? Double.NaN : estimate.odometer().heading();
                alignment.begin(searched);
            }

            @Override
            public void processReading() {
                alignment.updateTurn();
            }

            @Override
            public Velocity velocity() {
                return new Velocity(0, alignment.turnRate());
            }
        };
    }

    /** Returns MEASURE: continues the spin until the left sensor leaves the wall. */
    StateBehaviour measure() {
        return new StateBehaviour() {
            @Override
            public void processReading() {
                alignment.updateMeasure();
            }

            @Override
            public Velocity velocity() {
                return new Velocity(0, -estimate.turnRate());
            }
        };
    }

    /** Returns ALIGN: turns back for t_p and waits until the spin has ended. */
    StateBehaviour align() {
        return new StateBehaviour() {
            @Override
            public void enter(FollowerState from) {
                alignment.planTurnBack();
            }

            @Override
            public Velocity velocity() {
                return new Velocity(0, alignment.alignTurnRate());
            }
        };
    }

    /**
     * Returns whether the last spin found the wall beside which it began again; false after a search, in which no wall
     * was followed.
     */
    boolean foundSameWall() {
        double turned = Angles.difference(startHeading, estimate.odometer().heading());
        return Math.abs(turned) < estimate.thresholds().radians(Threshold.SAME_WALL_ANGLE);
    }
}
