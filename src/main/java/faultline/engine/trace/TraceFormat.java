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
        return cells(robot).stream().flatMap(cells -> cells.columns().stream()).toList();
    }

    /** Returns what writes the rows of one trace. */
    List<ColumnGroup> cells(RobotSpec robot) {
        if (this == ONE) {
            return List.of(new MotionColumns(false), new ReadingColumns(robot));
        }
        return List.of(new MotionColumns(true), new ControllerColumns(), new SensorColumns(robot));
    }
}
