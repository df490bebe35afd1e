package faultline.control;

import faultline.sensor.Reading;

/** TURN, MEASURE and ALIGN: spin right past the wall, time it, and turn back by the t_D / 2 rule, eq. (4) of the paper. */
final class SpinManoeuvre {

    /** A spin that begins beside a wall first backs off until the reading is this much more than the nearest. */
    private static final double BACKED_OFF = 1.3;

    /** What is this much farther than wanted when the spin begins is not the wall that was met, metres. */
    private static final double ELSEWHERE = 0.15;

    private static final double QUARTER = StrictMath.PI / 2;

    /** ALIGN hands over below this rate, radians per second. */
    private static final double STILL = StrictMath.toRadians(1);

    private final Perception perception;
    private final Timing rule;
    private final SpinTiming timing;
    private double start;
    private boolean backingOff;
    private double nearest;
    private double remaining;

    SpinManoeuvre(Perception perception, Timing rule) {
        this.perception = perception;
        this.rule = rule;
        this.timing = new SpinTiming(rule);
    }

    SpinTiming timing() {
        return timing;
    }

    // TURN: spin right until the left sensor comes to the wall.

    /** Starts; beside a wall that was met sideways, by turning away from it to the left, so that the sensor can come to it. */
    void begin(boolean wallMetSideways) {
        start = perception.heading();
        perception.forgetAhead();
        backingOff = wallMetSideways && reading() < Reading.NOTHING;
        nearest = left().reading();
        timing.start(perception.noise(), perception.turnRate() * perception.period());
        if (!backingOff) {
            timing.approach(clock(), reading(), perception.rolled());
        }
    }

    /** Takes the reading of a decision in TURN. */
    void approach() {
        if (!backingOff) {
            timing.approach(clock(), reading(), perception.rolled());
        }
    }

    /** The turn rate of TURN. */
    double turnRate() {
        if (backingOff) {
            nearest = Math.min(nearest, left().reading());
            boolean enough = rule == Timing.RANGE ? !left().sees() : left().reading() >= BACKED_OFF * nearest;
            backingOff = !enough && perception.heading() - start < QUARTER;
        }
        return backingOff ? perception.turnRate() : -perception.turnRate();
    }

    boolean comesToWall() {
        return !backingOff && timing.comesToWall();
    }

    // MEASURE: spin on until it leaves the wall.

    /** Takes the reading of a decision in MEASURE. */
    void pass() {
        timing.pass(clock(), left().reading());
    }

    boolean leavesWall() {
        return timing.leavesWall();
    }

    // ALIGN: turn back for t_p, and let the spin die out.

    /**
     * Plans the turn back: for t_p = t_D / 2 from F4 on, eq. (4). F4 was noticed a little late, and until the motors have reversed the spin
     * goes on for their lag; all that is turned back as well, unless the paper is to be taken to the letter.
     */
    void turnBack() {
        remaining = perception.turnRate() * timing.tP();
        if (rule == Timing.EQUAL_READINGS) {
            remaining += perception.turnRate() * (clock() - timing.tF4()) - perception.omega() * perception.lag();
        }
    }

    /** The turn rate of ALIGN; the last decision of the turn back turns just what is left. */
    double alignRate() {
        double rate = Math.max(0, Math.min(perception.turnRate(), remaining / perception.period()));
        remaining -= rate * perception.period();
        return rate;
    }

    boolean aligned() {
        return remaining <= 0 && Math.abs(perception.omega()) < STILL;
    }

    /**
     * The left reading; nothing where that is of something else than the wall that was met. By the paper's rule all that is in range
     * counts.
     */
    private double reading() {
        boolean counts = rule == Timing.RANGE || left().seesWithin(perception.wantedRadius() + ELSEWHERE);
        return counts ? left().reading() : Reading.NOTHING;
    }

    private Eye left() {
        return perception.sight().left();
    }

    /** The time that spinning right at the constant rate takes to come to the present heading, seconds: the clock of t_F3, t_F4 and t_p. */
    private double clock() {
        return (start - perception.heading()) / perception.turnRate();
    }
}
