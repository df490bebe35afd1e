package faultline.control.ladder;

import faultline.control.diagnosis.SensorDiagnosis;
import java.util.List;
import java.util.OptionalInt;

/**
 * A strategy of the ladder with the sensors that it needs. The first rung of {@link #LADDER} whose requirements are met
 * drives; the diagram shows the same table.
 */
public enum Rung {
    /** All sensors are trusted: the six states. */
    ALL(Strategy.SIX_STATES) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return diagnosis.allTrusted();
        }
    },
    /** The sensors that face the wall and ahead are trusted: the six states without the others. */
    REDUCED(Strategy.SIX_STATES) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return serves(diagnosis, QUARTER, FACING) && serves(diagnosis, 0, FACING);
        }
    },
    /** A sensor on the wall's side and two others are trusted: the local map. */
    THREE(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return serves(diagnosis, QUARTER, SIDEWAYS) && Integer.bitCount(diagnosis.trusted()) >= 3;
        }
    },
    /** A sensor on the wall's side and another one are trusted: the local map, with turns to look around. */
    TWO(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return serves(diagnosis, QUARTER, SIDEWAYS) && Integer.bitCount(diagnosis.trusted()) == 2;
        }
    },
    /** Only one that looks to the wall's side is trusted: the local map, with more turns to look around. */
    ONE(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return serves(diagnosis, QUARTER, SIDEWAYS);
        }
    },
    /** No sensor on the wall's side is trusted: the robot stops. */
    STOP(Strategy.STOP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return true;
        }
    };

    /** The strategy that drives the robot. */
    enum Strategy {
        SIX_STATES,
        MAP,
        STOP
    }

    /** All rungs from the top. */
    public static final List<Rung> LADDER = List.of(values());

    private static final double QUARTER = StrictMath.PI / 2;
    private static final double FACING = StrictMath.toRadians(20);
    private static final double SIDEWAYS = StrictMath.toRadians(50);

    private final Strategy strategy;

    Rung(Strategy strategy) {
        this.strategy = strategy;
    }

    /** Returns the highest rung whose needs are met. */
    static Rung of(SensorDiagnosis diagnosis) {
        for (Rung rung : LADDER) {
            if (rung.isMet(diagnosis)) {
                return rung;
            }
        }
        return STOP;
    }

    abstract boolean isMet(SensorDiagnosis diagnosis);

    Strategy strategy() {
        return strategy;
    }

    /**
     * {@return whether the follower of the six states drives on a rung; false for a name that the ladder does not have,
     * as a controller that is not part of the program may report}
     *
     * @param name the name of the rung
     */
    public static boolean drivesSixStates(String name) {
        return LADDER.stream().anyMatch(rung -> rung.name().equals(name) && rung.strategy == Strategy.SIX_STATES);
    }

    /** Returns the trusted sensor that the six states use to follow the wall. */
    static OptionalInt facingWall(SensorDiagnosis diagnosis) {
        return serving(diagnosis, QUARTER, FACING);
    }

    /** Returns whether a trusted sensor looks within some angle of a bearing. */
    private static boolean serves(SensorDiagnosis diagnosis, double bearing, double within) {
        return serving(diagnosis, bearing, within).isPresent();
    }

    /** Returns the trusted sensor that looks closest to a bearing, if it is within some angle of it. */
    private static OptionalInt serving(SensorDiagnosis diagnosis, double bearing, double within) {
        OptionalInt nearest = OptionalInt.empty();
        double least = within;
        for (int rest = diagnosis.trusted(); rest != 0; rest &= rest - 1) {
            int sensor = Integer.numberOfTrailingZeros(rest);
            double off = Math.abs(diagnosis.cone(sensor).bearing() - bearing);
            if (off < least) {
                least = off;
                nearest = OptionalInt.of(sensor);
            }
        }
        return nearest;
    }
}
