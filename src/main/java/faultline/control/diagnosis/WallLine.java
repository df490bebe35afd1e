package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * The sensors on the wall's side in one line: the one that faces the wall, one that sees it ahead, and one that sees it
 * behind.
 */
final class WallLine {

    private static final double QUARTER = StrictMath.PI / 2;

    /** Sensors ahead and behind look at the wall at a slant between these. */
    private static final double LEAST_SLANT = StrictMath.toRadians(20);

    private static final double GREATEST_SLANT = StrictMath.toRadians(70);

    private InspectedSensor facing;
    private InspectedSensor ahead;
    private InspectedSensor behind;

    /** The direction in each sensor's cone in which a wall beside the robot is nearest. */
    private final double[] cos;

    private final double[] sin;

    WallLine(InspectedSensor[] sensors) {
        cos = new double[sensors.length];
        sin = new double[sensors.length];
        for (InspectedSensor sensor : sensors) {
            cos[sensor.index()] = StrictMath.cos(nearest(sensor.cone()));
            sin[sensor.index()] = StrictMath.sin(nearest(sensor.cone()));
            double off = QUARTER - sensor.cone().bearing();
            if (Math.abs(off) < sensor.cone().half()) {
                facing = sensor;
            } else if (off > LEAST_SLANT && off < GREATEST_SLANT) {
                ahead = sensor;
            } else if (-off > LEAST_SLANT && -off < GREATEST_SLANT) {
                behind = sensor;
            }
        }
    }

    /** Returns the reading of the sensor that faces the wall. */
    double distance(double[] readings) {
        return facing == null ? Reading.OFF : readings[facing.index()];
    }

    /**
     * By how much the wall beside the robot is farther than the line between what is seen ahead and behind.
     *
     * @param readings of all sensors
     * @return metres, not a number if one of the three sees nothing, or the one that faces the wall is not trusted;
     *     with the others, which may be suspected just because the path bends, a sag that is wrong does no harm
     */
    double sag(double[] readings) {
        if (!sees(facing, readings) || !facing.isTrusted() || !sees(ahead, readings) || !sees(behind, readings)) {
            return Double.NaN;
        }
        double aheadX = x(ahead, readings);
        double behindX = x(behind, readings);
        double share = (x(facing, readings) - behindX) / (aheadX - behindX);
        return y(facing, readings) - y(behind, readings) - share * (y(ahead, readings) - y(behind, readings));
    }

    private static boolean sees(InspectedSensor sensor, double[] readings) {
        return sensor != null
                && !Reading.isOff(readings[sensor.index()])
                && readings[sensor.index()] < sensor.cone().range();
    }

    /** Returns the bearing in a cone at which a wall beside the robot is nearest. */
    private static double nearest(MountedCone cone) {
        return Math.max(cone.bearing() - cone.half(), Math.min(cone.bearing() + cone.half(), QUARTER));
    }

    private double x(InspectedSensor sensor, double[] readings) {
        return sensor.cone().x() + readings[sensor.index()] * cos[sensor.index()];
    }

    private double y(InspectedSensor sensor, double[] readings) {
        return sensor.cone().y() + readings[sensor.index()] * sin[sensor.index()];
    }
}
