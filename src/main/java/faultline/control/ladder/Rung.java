package faultline.control.ladder;

import faultline.control.diagnosis.SensorDiagnosis;
import faultline.control.wallfollower.WallFollower;
import java.util.List;
import java.util.OptionalInt;

/**
 * A strategy of the ladder with the sensors that it needs. The first rung of {@link #LADDER} whose requirements are met
 * drives; the diagram shows the same table. A sensor that is not diagnosed is trusted as long as it answers, but the
 * local map does not contain what it sees.
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
            return facing(diagnosis, QUARTER) != NO_SENSOR && facing(diagnosis, 0) != NO_SENSOR;
        }
    },
    /** A sensor on the wall's side and two others are trusted: the local map. */
    THREE(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return looksSideways(diagnosis) && Integer.bitCount(diagnosis.trusted()) >= 3;
        }
    },
    /** A sensor on the wall's side and another one are trusted: the local map, with turns to look around. */
    TWO(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return looksSideways(diagnosis) && Integer.bitCount(diagnosis.trusted()) == 2;
        }
    },
    /** Only one that looks to the wall's side is trusted: the local map, with more turns to look around. */
    ONE(Strategy.MAP) {
        @Override
        boolean isMet(SensorDiagnosis diagnosis) {
            return looksSideways(diagnosis);
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

    private static final int NO_SENSOR = -1;
    private static final double QUARTER = StrictMath.PI / 2;
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
        int sensor = facing(diagnosis, QUARTER);
        return sensor == NO_SENSOR ? OptionalInt.empty() : OptionalInt.of(sensor);
    }

    /** Returns the trusted sensor that the six states use in a direction, {@link #NO_SENSOR} if there is none. */
    private static int facing(SensorDiagnosis diagnosis, double bearing) {
        int nearest = diagnosed(diagnosis, bearing, WallFollower.FACING_TOLERANCE);
        double least = nearest == NO_SENSOR ? WallFollower.FACING_TOLERANCE : deviation(diagnosis, nearest, bearing);
        for (int other = diagnosis.sensors(); other < diagnosis.allSensors(); other++) {
            double deviation = deviation(diagnosis, other, bearing);
            if (deviation < least && diagnosis.answers(other)) {
                least = deviation;
                nearest = other;
            }
        }
        return nearest;
    }

    /** Returns whether a trusted sensor whose measurements are in the map looks to the wall's side. */
    private static boolean looksSideways(SensorDiagnosis diagnosis) {
        return diagnosed(diagnosis, QUARTER, SIDEWAYS) != NO_SENSOR;
    }

    /** Returns the diagnosed and trusted sensor that looks closest to a bearing, if it is within some angle of it. */
    private static int diagnosed(SensorDiagnosis diagnosis, double bearing, double within) {
        int nearest = NO_SENSOR;
        double least = within;
        for (int rest = diagnosis.trusted(); rest != 0; rest &= rest - 1) {
            int sensor = Integer.numberOfTrailingZeros(rest);
            double deviation = deviation(diagnosis, sensor, bearing);
            if (deviation < least) {
                least = deviation;
                nearest = sensor;
            }
        }
        return nearest;
    }

    private static double deviation(SensorDiagnosis diagnosis, int sensor, double bearing) {
        return Math.abs(diagnosis.cone(sensor).bearing() - bearing);
    }
}
