package faultline.benchmark;

import faultline.control.ControllerSpec;
import faultline.engine.SimulationSetup;
import faultline.geometry.ConvexShape;
import faultline.geometry.Segment;
import faultline.robot.MotorSpec;
import faultline.sensor.SensorSpec;
import faultline.world.ObstacleGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/**
 * The kinematics and the cones of a tick and nothing else: the least that any simulator with exact cones must compute.
 * It has its own geometry in plain arrays, independent of the program's: each segment near the robot is clipped to the
 * wedge of each cone. The segments near each square of half a metre are found beforehand, so that a tick searches for
 * nothing; no contact, controller, hash, observation or fault is computed.
 */
final class BareProbe implements Runnable {

    /** The side of a square, metres. */
    private static final double SQUARE = 0.5;

    private final double dt;
    private final double track;
    private final double decay;
    private final double leftTarget;
    private final double rightTarget;
    private final int columns;

    /** For each square, four numbers a segment: the ends' coordinates, metres. */
    private final double[][] near;

    /** For each sensor: mounting point, and the directions of both edges of the cone in the robot's frame. */
    private final double[][] cones;

    private final double[] ranges;
    private final double[] readings;
    private double x;
    private double y;
    private double heading;
    private double left;
    private double right;

    BareProbe(SimulationSetup setup) {
        MotorSpec motor = setup.robot().motor();
        ControllerSpec.Drive drive = (ControllerSpec.Drive) setup.controller();
        dt = setup.dt();
        track = setup.robot().track();
        decay = Math.exp(-dt / motor.timeConstant());
        leftTarget = motor.speedConstant() * drive.leftVolts();
        rightTarget = motor.speedConstant() * drive.rightVolts();
        x = setup.start().x();
        y = setup.start().y();
        heading = setup.start().heading();
        List<SensorSpec> sensors = setup.robot().sensors();
        cones = sensors.stream().map(BareProbe::cone).toArray(double[][]::new);
        ranges = sensors.stream().mapToDouble(SensorSpec::range).toArray();
        readings = new double[sensors.size()];
        columns = (int) Math.ceil(setup.world().width() / SQUARE);
        near = near(setup, (int) Math.ceil(setup.world().height() / SQUARE));
    }

    private static double[] cone(SensorSpec sensor) {
        double low = sensor.bearing() - sensor.cone() / 2;
        double high = sensor.bearing() + sensor.cone() / 2;
        return new double[] {
            sensor.mountPosition().x(),
            sensor.mountPosition().y(),
            Math.cos(low),
            Math.sin(low),
            Math.cos(high),
            Math.sin(high)
        };
    }

    private double[][] near(SimulationSetup setup, int rows) {
        double reach = 0;
        for (SensorSpec sensor : setup.robot().sensors()) {
            reach = Math.max(reach, sensor.range() + sensor.mountPosition().length());
        }
        List<List<Segment>> squares = new ArrayList<>();
        for (int i = 0; i < rows * columns; i++) {
            squares.add(new ArrayList<>());
        }
        for (Segment segment : segments(setup)) {
            int top = row(Math.max(segment.ay(), segment.by()) + reach, rows);
            int last = row(Math.max(segment.ax(), segment.bx()) + reach, columns);
            for (int row = row(Math.min(segment.ay(), segment.by()) - reach, rows); row <= top; row++) {
                for (int column = row(Math.min(segment.ax(), segment.bx()) - reach, columns);
                        column <= last;
                        column++) {
                    squares.get(row * columns + column).add(segment);
                }
            }
        }
        return squares.stream()
                .map(square -> square.stream()
                        .flatMapToDouble(s -> DoubleStream.of(s.ax(), s.ay(), s.bx(), s.by()))
                        .toArray())
                .toArray(double[][]::new);
    }

    private static int row(double coordinate, int count) {
        return Math.max(0, Math.min(count - 1, (int) Math.floor(coordinate / SQUARE)));
    }

    private static List<Segment> segments(SimulationSetup setup) {
        double width = setup.world().width();
        double height = setup.world().height();
        List<Segment> segments = new ArrayList<>(List.of(
                new Segment(0, 0, width, 0),
                new Segment(width, 0, width, height),
                new Segment(width, height, 0, height),
                new Segment(0, height, 0, 0)));
        setup.world().obstacles().forEach(obstacle -> {
            for (ConvexShape part : ObstacleGeometry.of(obstacle).parts()) {
                segments.add((Segment) part);
            }
        });
        return segments;
    }

    /** Returns the distance that a sensor measured in the last tick, metres, infinite beyond its range. */
    double reading(int sensor) {
        return readings[sensor];
    }

    /** Makes a tick. */
    @Override
    public void run() {
        left = leftTarget + (left - leftTarget) * decay;
        right = rightTarget + (right - rightTarget) * decay;
        double half = (right - left) / track * dt / 2;
        double chord = (left + right) / 2 * dt * (half == 0 ? 1 : Math.sin(half) / half);
        x += chord * Math.cos(heading + half);
        y += chord * Math.sin(heading + half);
        heading += 2 * half;
        double cos = Math.cos(heading);
        double sin = Math.sin(heading);
        double[] segments = near[row(y, near.length / columns) * columns + row(x, columns)];
        for (int i = 0; i < cones.length; i++) {
            double[] cone = cones[i];
            readings[i] = nearest(
                    segments,
                    x + cos * cone[0] - sin * cone[1],
                    y + sin * cone[0] + cos * cone[1],
                    cos * cone[2] - sin * cone[3],
                    sin * cone[2] + cos * cone[3],
                    cos * cone[4] - sin * cone[5],
                    sin * cone[4] + cos * cone[5],
                    ranges[i]);
        }
    }

    /** Returns the least distance from an apex to the parts of segments between two directions. */
    private static double nearest(
            double[] segments,
            double px,
            double py,
            double lowX,
            double lowY,
            double highX,
            double highY,
            double range) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < segments.length; i += 4) {
            double ax = segments[i] - px;
            double ay = segments[i + 1] - py;
            double dx = segments[i + 2] - px - ax;
            double dy = segments[i + 3] - py - ay;
            double lowA = lowX * ay - lowY * ax;
            double lowB = lowA + lowX * dy - lowY * dx;
            double highA = ax * highY - ay * highX;
            double highB = highA + dx * highY - dy * highX;
            if ((lowA >= 0 || lowB >= 0) && (highA >= 0 || highB >= 0)) {
                double from = Math.max(entry(lowA, lowB), entry(highA, highB));
                double to = Math.min(1 - entry(lowB, lowA), 1 - entry(highB, highA));
                if (from <= to) {
                    least = Math.min(least, squareDistance(ax, ay, dx, dy, from, to));
                }
            }
        }
        return least <= range * range ? Math.sqrt(least) : Double.POSITIVE_INFINITY;
    }

    /** Returns the fraction of a segment before a line, from the distances of its ends, negative before the line. */
    private static double entry(double first, double last) {
        return first < 0 ? first / (first - last) : 0;
    }

    /** Returns the square of the distance from the origin to the part of a segment between two fractions. */
    private static double squareDistance(double ax, double ay, double dx, double dy, double from, double to) {
        double foot = -(ax * dx + ay * dy) / (dx * dx + dy * dy);
        double t = Math.max(from, Math.min(to, foot));
        double x = ax + t * dx;
        double y = ay + t * dy;
        return x * x + y * y;
    }
}
