package faultline.engine.recording;

/** The numbers that are traced: eight of the controller, four of the robot's motion, and two of each sensor. */
public final class TraceChannels {

    /** The distance that the controller holds, metres. */
    public static final int WANTED_DISTANCE = 0;
    /** The distance that the controller measures, metres. */
    public static final int MEASURED_DISTANCE = 1;
    /** The PD controller's P term, radians per second. */
    public static final int PROPORTIONAL = 2;
    /** The PD controller's D term, radians per second. */
    public static final int DERIVATIVE = 3;
    /** The voltage on the left motors, volts. */
    public static final int LEFT_VOLTS = 4;
    /** The voltage on the right motors, volts. */
    public static final int RIGHT_VOLTS = 5;

    /** The robot's heading, radians, not normalised. */
    public static final int HEADING = 6;

    /** What rounding removes from {@link #HEADING}, radians: a heading is large after many turns. */
    public static final int HEADING_REST = 7;
    /** The linear velocity at which the motors would settle with these voltages, metres per second. */
    public static final int COMMANDED_VELOCITY = 8;
    /** The robot's linear velocity, metres per second, positive ahead. */
    public static final int VELOCITY = 9;
    /** The turn rate at which the motors would settle with these voltages, radians per second. */
    public static final int COMMANDED_TURN_RATE = 10;
    /** The robot's turn rate, radians per second, positive to the left. */
    public static final int TURN_RATE = 11;

    private static final int SENSOR_OFFSET = 12;

    private TraceChannels() {}

    /**
     * {@return the channel of a sensor's reading without noise and faults, metres}
     *
     * @param sensor the index of the sensor in the robot's list, from 0
     */
    public static int trueReading(int sensor) {
        return SENSOR_OFFSET + 2 * sensor;
    }

    /**
     * {@return the channel of a sensor's reported reading, metres}
     *
     * @param sensor the index of the sensor in the robot's list, from 0
     */
    public static int reportedReading(int sensor) {
        return SENSOR_OFFSET + 2 * sensor + 1;
    }

    /**
     * {@return the number of channels of a robot}
     *
     * @param sensors the number of sensors
     */
    public static int count(int sensors) {
        return SENSOR_OFFSET + 2 * sensors;
    }
}
