package faultline.control.wallfollower;

import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.geometry.Angles;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import java.util.Arrays;
import java.util.List;

/**
 * The sensors that look in the five directions of the follower, found by their bearings and not by their names. A
 * follower with the wall on the right is the mirror image of one with the wall on the left.
 *
 * <p>Which sensors look in a direction is computed once for a robot; a decision only chooses among them and takes their
 * readings.
 */
final class SensorViews {

    /** A direction in the follower's frame, in which the wall is on the left. */
    enum Direction {
        LEFT(StrictMath.PI / 2),
        FRONT(0),
        FRONT_LEFT(StrictMath.PI / 4),
        FRONT_RIGHT(-StrictMath.PI / 4),
        RIGHT(-StrictMath.PI / 2);

        private final double bearing;

        Direction(double bearing) {
            this.bearing = bearing;
        }
    }

    private static final Direction[] DIRECTIONS = Direction.values();

    private final double side;
    private List<SensorSpec> sensors = List.of();
    /** Each sensor of the robot in the follower's frame. */
    private SensorView[] mounted = {};
    /** For each direction, the indices of the sensors that look there, the nearest to it first. */
    private final int[][] candidates = new int[DIRECTIONS.length][0];

    private final SensorView[] views = new SensorView[DIRECTIONS.length];

    SensorViews(WallSide wallSide) {
        side = wallSide.sign();
    }

    /**
     * Returns the sensor that looks in a direction before the first reading: the first that is switched on,
     * {@link SensorView#NONE} if there is none.
     */
    static SensorView facing(Direction direction, WallSide wallSide, RobotSpec robot) {
        double[] readings = robot.sensors().stream()
                .mapToDouble(sensor -> sensor.on() ? Reading.NOTHING : Reading.OFF)
                .toArray();
        SensorViews views = new SensorViews(wallSide);
        views.update(new Observation(0, 0, robot, readings));
        return views.facing(direction);
    }

    /** Processes the readings of an observation. */
    void update(Observation observation) {
        if (observation.robot().sensors() != sensors) {
            sensors = observation.robot().sensors();
            findCandidates();
        }
        for (int i = 0; i < views.length; i++) {
            views[i] = view(candidates[i], observation.readings());
        }
    }

    /** Returns the sensor that looks in a direction, {@link SensorView#NONE} if no sensor that answers looks there. */
    SensorView facing(Direction direction) {
        return views[direction.ordinal()];
    }

    private SensorView view(int[] indices, double[] readings) {
        for (int index : indices) {
            if (!Reading.isOff(readings[index])) {
                return mounted[index].withReading(readings[index]);
            }
        }
        return SensorView.NONE;
    }

    private void findCandidates() {
        mounted = new SensorView[sensors.size()];
        for (int i = 0; i < mounted.length; i++) {
            mounted[i] = mirrored(sensors.get(i));
        }
        for (Direction direction : DIRECTIONS) {
            candidates[direction.ordinal()] = candidates(direction);
        }
    }

    private int[] candidates(Direction direction) {
        int[] found = new int[mounted.length];
        int count = 0;
        for (int i = 0; i < mounted.length; i++) {
            double deviation = deviation(direction, i);
            if (deviation < WallFollower.FACING_TOLERANCE) {
                int place = count++;
                while (place > 0 && deviation(direction, found[place - 1]) > deviation) {
                    found[place] = found[place - 1];
                    place--;
                }
                found[place] = i;
            }
        }
        return Arrays.copyOf(found, count);
    }

    private double deviation(Direction direction, int index) {
        return Math.abs(
                Angles.difference(direction.bearing, side * sensors.get(index).bearing()));
    }

    private SensorView mirrored(SensorSpec sensor) {
        Vector2 mountPosition = new Vector2(
                sensor.mountPosition().x(), side * sensor.mountPosition().y());
        return new SensorView(
                mountPosition,
                Angles.normalize(side * sensor.bearing()),
                sensor.cone() / 2,
                sensor.range(),
                Reading.NOTHING,
                true);
    }
}
