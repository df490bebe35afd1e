package faultline.engine.metrics;

import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.geometry.Pose;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import java.util.List;

/** The cells of every trace: time, motion and state. */
final class MotionCells implements TraceCells {

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
    private final NumberText t = new NumberText();
    private final NumberText x = new NumberText();
    private final NumberText y = new NumberText();
    private final NumberText heading = new NumberText();
    private final NumberText v = new NumberText();
    private final NumberText omega = new NumberText();
    private final NumberText left = new NumberText();
    private final NumberText right = new NumberText();
    private final WordText state = new WordText();
    private final WordText collided = new WordText();

    /**
     * Creates the cells of one trace.
     *
     * @param exactTimes whether times are exact multiples of the tick, without rounding errors
     */
    MotionCells(boolean exactTimes) {
        this.exactTimes = exactTimes;
    }

    @Override
    public List<TraceColumn> columns() {
        return COLUMNS;
    }

    @Override
    public void append(Simulation simulation, TraceBlock row) {
        row.append(simulation.ticks());
        row.endCell();
        double time = exactTimes ? simulation.setup().timeOf(simulation.ticks()) : simulation.time();
        t.appendCell(time, row);
        Pose pose = simulation.pose();
        x.appendCell(pose.x(), row);
        y.appendCell(pose.y(), row);
        heading.appendCell(StrictMath.toDegrees(Angles.normalize(pose.heading())), row);
        Velocity velocity = simulation.velocity();
        v.appendCell(velocity.linear(), row);
        omega.appendCell(velocity.angular(), row);
        WheelSpeeds wheels = simulation.wheelSpeeds();
        left.appendCell(wheels.left(), row);
        right.appendCell(wheels.right(), row);
        state.appendCell(simulation.telemetry().state().name(), row);
        collided.appendCell(simulation.collision().isPresent() ? "true" : "false", row);
    }
}
