package faultline.engine.trace;

import faultline.robot.RobotSpec;
import java.util.List;

/** The formats of a trace: which columns it has. */
public enum TraceFormat {
    /** Motion, state and readings; a sensor that is off reads {@code off}. */
    ONE,
    /**
     * Volts, telemetry, active faults and the health of sensors as well; a column holds numbers only, or words only,
     * and times have no rounding errors.
     */
    TWO;

    /**
     * {@return the columns of a robot's trace}
     *
     * @param robot the robot
     */
    public List<TraceColumn> columns(RobotSpec robot) {
        return groups(robot).stream().flatMap(group -> group.columns().stream()).toList();
    }

    /** Returns the groups of columns for a robot, which write the rows of one trace. */
    List<ColumnGroup> groups(RobotSpec robot) {
        if (this == ONE) {
            return List.of(new MotionColumns(false), new ReadingColumns(robot));
        }
        return List.of(new MotionColumns(true), new ControllerColumns(), new SensorColumns(robot));
    }
}
