package faultline.engine.trace;

import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.List;

/** The columns of every trace: time, motion and state. */
final class MotionColumns implements ColumnGroup {

    private static final List<TraceColumn> COLUMNS = List.of(
            new TraceColumn("tick", "", "number of the tick, from 0"),
            new TraceColumn("t", "s", "time"),
            new TraceColumn("x", "m", "centre of the robot"),
            new TraceColumn("y", "m", "centre of the robot"),
            new TraceColumn("heading_deg", "deg", "heading, counter-clockwise from x"),
            new TraceColumn("v", "m/s", "speed"),
            new TraceColumn("omega", "rad/s", "turn rate"),
            new TraceColumn("left_v", "m/s", "speed of the left wheels"),
            new TraceColumn("right_v", "m/s", "speed of the right wheels"),
            new TraceColumn("state", "", "state of the controller"),
            new TraceColumn("collided", "", "true from the first contact on"));

    private final boolean exactTimes;
    /** Null before the first row. */
    private TickTimes times;

    /**
     * Creates the cells of one trace.
     *
     * @param exactTimes whether times are exact multiples of the tick, without rounding errors
     */
    MotionColumns(boolean exactTimes) {
        this.exactTimes = exactTimes;
    }

    @Override
    public List<TraceColumn> columns() {
        return COLUMNS;
    }

    @Override
    public void append(Simulation simulation, TraceRows rows) {
        rows.append(simulation.ticks());
        rows.append(exactTimes ? exactTime(simulation) : simulation.time());
        Pose pose = simulation.pose();
        rows.append(pose.x());
        rows.append(pose.y());
        rows.append(StrictMath.toDegrees(Angles.normalize(pose.heading())));
        Velocity velocity = simulation.velocity();
        rows.append(velocity.linear());
        rows.append(velocity.angular());
        WheelSpeeds wheels = simulation.wheelSpeeds();
        rows.append(wheels.left());
        rows.append(wheels.right());
        rows.append(simulation.telemetry().state().name());
        rows.append(simulation.collision().isPresent() ? "true" : "false");
    }

    private double exactTime(Simulation simulation) {
        if (times == null) {
            times = TickTimes.of(simulation.setup().dt());
        }
        return times.timeOf(simulation.ticks());
    }
}
