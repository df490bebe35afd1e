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

    /** Returns the behaviour in TURN. */
    StateBehaviour turn() {
        return new TurnState();
    }

    /** Returns the behaviour in MEASURE. */
    StateBehaviour measure() {
        return new MeasureState();
    }

    /** Returns the behaviour in ALIGN. */
    StateBehaviour align() {
        return new AlignState();
    }

    /**
     * Returns whether the last spin found the wall beside which it began again; false after a search, in which no wall
     * was followed.
     */
    boolean foundSameWall() {
        double turned = Angles.difference(startHeading, estimate.odometer().heading());
        return Math.abs(turned) < estimate.thresholds().radians(Threshold.SAME_WALL_ANGLE);
    }

    /** TURN: spins right until the left sensor reaches the wall. */
    private final class TurnState implements StateBehaviour {
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
        public Velocity nextVelocity() {
            return new Velocity(0, alignment.nextTurnRate());
        }
    }

    /** MEASURE: continues the spin until the left sensor leaves the wall. */
    private final class MeasureState implements StateBehaviour {
        @Override
        public void processReading() {
            alignment.updateMeasure();
        }

        @Override
        public Velocity nextVelocity() {
            return new Velocity(0, -estimate.turnRate());
        }
    }

    /** ALIGN: turns back for t_p and waits until the spin has ended. */
    private final class AlignState implements StateBehaviour {
        @Override
        public void enter(FollowerState from) {
            alignment.planTurnBack();
        }

        @Override
        public Velocity nextVelocity() {
            return new Velocity(0, alignment.nextAlignTurnRate());
        }
    }
}
