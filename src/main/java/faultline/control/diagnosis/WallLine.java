package faultline.control.diagnosis;

import faultline.sensor.Reading;

/**
 * The sensors on the wall's side in one line: the one that faces the wall, one that sees it ahead, and one that sees it
 * behind.
 */
final class WallLine {

    private static final double QUARTER = StrictMath.PI / 2;

    /** The minimum angle between the axis of a sensor ahead or behind and the normal of the wall. */
    private static final double MIN_SLANT = StrictMath.toRadians(20);

    private static final double MAX_SLANT = StrictMath.toRadians(70);

    /** A sensor with its mounting point and the direction in its cone in which a wall beside the robot is nearest. */
    private record WallRay(
            InspectedSensor sensor, int index, double range, double x, double y, double cos, double sin) {

        static WallRay of(InspectedSensor sensor, double normal) {
            MountedCone cone = sensor.cone();
            double nearest = Math.max(cone.bearing() - cone.half(), Math.min(cone.bearing() + cone.half(), normal));
            return new WallRay(
                    sensor,
                    sensor.index(),
                    cone.range(),
                    cone.x(),
                    cone.y(),
                    StrictMath.cos(nearest),
                    StrictMath.sin(nearest));
        }

        /** Returns whether a reading is a distance; false if the sensor is off. */
        boolean sees(double reading) {
            return reading < range;
        }

        double x(double reading) {
            return x + reading * cos;
        }

        double y(double reading) {
            return y + reading * sin;
        }
    }

    /** The number of sensors. */
    static final int SENSORS = 3;

    /** The index of the sensor that faces the wall, between the one ahead and the one behind. */
    static final int BESIDE = 1;

    private WallRay facing;
    private WallRay ahead;
    private WallRay behind;
    /** All three in the order from ahead to behind, null if one is missing. */
    private final WallRay[] rays;

    WallLine(InspectedSensor[] sensors) {
        for (InspectedSensor sensor : sensors) {
            double off = QUARTER - sensor.cone().bearing();
            if (Math.abs(off) < sensor.cone().half()) {
                facing = WallRay.of(sensor, QUARTER);
            } else if (off > MIN_SLANT && off < MAX_SLANT) {
                ahead = WallRay.of(sensor, QUARTER);
            } else if (-off > MIN_SLANT && -off < MAX_SLANT) {
                behind = WallRay.of(sensor, QUARTER);
            }
        }
        rays = facing == null || ahead == null || behind == null ? null : new WallRay[] {ahead, facing, behind};
    }

    /** Returns the reading of the sensor that faces the wall. */
    double distance(double[] readings) {
        return facing == null ? Reading.OFF : readings[facing.index];
    }

    /** Returns whether all three see something. */
    boolean isSeen(double[] readings) {
        return rays != null
                && facing.sees(readings[facing.index])
                && ahead.sees(readings[ahead.index])
                && behind.sees(readings[behind.index]);
    }

    /** Returns whether a sensor is one of the three. */
    boolean contains(InspectedSensor sensor) {
        return rays != null && (sensor == ahead.sensor || sensor == facing.sensor || sensor == behind.sensor);
    }

    /** Returns a sensor of the line: the one that sees the wall ahead, beside, or behind the robot. */
    InspectedSensor sensor(int place) {
        return rays[place].sensor;
    }

    /** Returns the lateral distance from the robot's centre to the wall that a sensor of the line sees, metres. */
    double aside(int place, double[] readings) {
        return rays[place].y(readings[rays[place].index]);
    }

    /**
     * Returns the distance from the robot's centre to the wall that a sensor of the line sees, metres.
     *
     * @param place the sensor: ahead, beside, or behind the robot
     * @param readings the readings of all sensors
     * @param turn the angle from the wall to the robot, radians, positive to the left
     */
    double aside(int place, double[] readings, double turn) {
        WallRay ray = WallRay.of(rays[place].sensor, QUARTER - turn);
        double reading = readings[ray.index];
        return ray.x(reading) * StrictMath.sin(turn) + ray.y(reading) * StrictMath.cos(turn);
    }

    /**
     * Returns by how much the wall beside the robot is farther away than the line between the points seen ahead and
     * behind.
     *
     * @param readings the readings of all sensors
     * @param trusted the trusted sensors, a bit for each
     * @return metres; NaN if one of the three sees nothing or the one that faces the wall is not trusted. The others
     *     may be suspected only because the path bends, and a wrong result does no harm then
     */
    double sag(double[] readings, int trusted) {
        if (!isSeen(readings) || (trusted & facing.sensor.bit()) == 0) {
            return Double.NaN;
        }
        double beside = readings[facing.index];
        double before = readings[ahead.index];
        double after = readings[behind.index];
        double behindX = behind.x(after);
        double behindY = behind.y(after);
        double share = (facing.x(beside) - behindX) / (ahead.x(before) - behindX);
        return facing.y(beside) - behindY - share * (ahead.y(before) - behindY);
    }
}
