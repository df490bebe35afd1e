package faultline.engine.metrics;

import faultline.control.SensorHealth;
import faultline.control.Telemetry;
import faultline.engine.Simulation;
import faultline.geometry.Angles;
import faultline.io.MessageText;
import faultline.robot.MotorFault;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.Reading;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

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
        List<TraceColumn> columns = new ArrayList<>();
        addMotion(columns, this == ONE ? Simulation::time : s -> s.setup().timeOf(s.ticks()));
        if (this == TWO) {
            addController(columns);
        }
        for (int i = 0; i < robot.sensors().size(); i++) {
            String id = MessageText.cell(robot.sensors().get(i).id());
            if (this == ONE) {
                addReadings(columns, id, i);
            } else {
                addNumericReadings(columns, id, i);
                addHealth(columns, id, i);
            }
        }
        return columns;
    }

    private static void addMotion(List<TraceColumn> columns, ToDoubleFunction<Simulation> time) {
        columns.add(new TraceColumn(
                "tick", "", "number of the tick, from 0", (s, row) -> row.append(Long.toString(s.ticks()))));
        columns.add(number("t", "s", "time", time));
        columns.add(number("x", "m", "centre of the robot", s -> s.pose().x()));
        columns.add(number("y", "m", "centre of the robot", s -> s.pose().y()));
        columns.add(number(
                "heading_deg",
                "deg",
                "heading, counter-clockwise from x",
                s -> StrictMath.toDegrees(Angles.normalize(s.pose().heading()))));
        columns.add(number("v", "m/s", "speed", s -> s.velocity().linear()));
        columns.add(number("omega", "rad/s", "turn rate", s -> s.velocity().angular()));
        columns.add(number("left_v", "m/s", "speed of the left wheels", s -> s.wheelSpeeds()
                .left()));
        columns.add(number("right_v", "m/s", "speed of the right wheels", s -> s.wheelSpeeds()
                .right()));
        columns.add(word(
                "state", "state of the controller", s -> s.telemetry().state().name()));
        columns.add(new TraceColumn(
                "collided",
                "",
                "true from the first contact on",
                (s, row) -> row.append(s.collision().isPresent() ? "true" : "false")));
    }

    private static void addController(List<TraceColumn> columns) {
        columns.add(number("left_volts", "V", "what the controller gives the left motors", Simulation::leftVolts));
        columns.add(number("right_volts", "V", "what the controller gives the right motors", Simulation::rightVolts));
        columns.add(telemetry("wanted_m", "m", "distance that the controller holds", t -> t.wall()
                .wantedDistance()));
        columns.add(telemetry("measured_m", "m", "distance that the controller goes by", t -> t.wall()
                .measuredDistance()));
        columns.add(telemetry("p_rad_s", "rad/s", "P term of the distance control", t -> t.wall()
                .proportional()));
        columns.add(telemetry("d_rad_s", "rad/s", "D term of the distance control", t -> t.wall()
                .derivative()));
        columns.add(telemetry("t_f3_s", "s", "time of frame F3 since the last spin began", t -> t.edges()
                .tF3()));
        columns.add(telemetry("t_f4_s", "s", "time of frame F4 since the last spin began", t -> t.edges()
                .tF4()));
        columns.add(telemetry("t_p_s", "s", "how long the robot turns back, eq. (4)", t -> t.edges()
                .tP()));
        columns.add(word("rung", "strategy that drives, empty without a diagnosis", s -> s.telemetry()
                .diagnosis()
                .rung()));
        columns.add(word(
                "left_motor_faults",
                "active faults of the left motors",
                s -> motorFaults(s.motorFaults().left())));
        columns.add(word(
                "right_motor_faults",
                "active faults of the right motors",
                s -> motorFaults(s.motorFaults().right())));
    }

    private static void addReadings(List<TraceColumn> columns, String id, int sensor) {
        // Both are the same number unless there is noise or a fault.
        NumberText number = new NumberText();
        columns.add(new TraceColumn(
                id + ".true", "", "", (s, row) -> appendReadingOrOff(s.trueReading(sensor), number, row)));
        columns.add(new TraceColumn(
                id + ".reading", "", "", (s, row) -> appendReadingOrOff(s.reportedReading(sensor), number, row)));
    }

    private static void appendReadingOrOff(double reading, NumberText number, TraceRow row) {
        if (Reading.isOff(reading)) {
            row.append("off");
        } else if (reading != Reading.NOTHING) {
            number.append(reading, row);
        }
    }

    private static void addNumericReadings(List<TraceColumn> columns, String id, int sensor) {
        columns.add(number(
                id + ".true",
                "m",
                "distance without noise and faults, empty for nothing in range",
                s -> distance(s.trueReading(sensor))));
        columns.add(number(
                id + ".reading",
                "m",
                "reported distance, empty for nothing in range or no answer",
                s -> distance(s.reportedReading(sensor))));
        columns.add(new TraceColumn(
                id + ".answers",
                "",
                "1 if the sensor answers, 0 if it is off",
                (s, row) -> row.append(Reading.isOff(s.reportedReading(sensor)) ? '0' : '1')));
        columns.add(word(id + ".faults", "active faults, oldest first", s -> faults(s.faults(sensor))));
    }

    private static double distance(double reading) {
        return Reading.isOff(reading) || reading == Reading.NOTHING ? Double.NaN : reading;
    }

    private static void addHealth(List<TraceColumn> columns, String id, int sensor) {
        columns.add(health(
                id + ".trust",
                "trusted, suspected or distrusted; empty without a diagnosis",
                sensor,
                health -> health.trust().name().toLowerCase(Locale.ROOT)));
        columns.add(health(id + ".finding", "why it is not trusted", sensor, health -> health.finding()
                .name()
                .toLowerCase(Locale.ROOT)));
        columns.add(health(
                id + ".evidence", "evidence against it, 0 to 1", sensor, health -> Double.toString(health.evidence())));
    }

    private static TraceColumn health(String name, String meaning, int sensor, Function<SensorHealth, String> text) {
        return word(name, meaning, s -> {
            List<SensorHealth> health = s.telemetry().diagnosis().health();
            return health.isEmpty() ? "" : text.apply(health.get(sensor));
        });
    }

    /** Faults as words, such as {@code stuck=0.4 noise=0.01}. */
    private static String faults(List<Fault> faults) {
        return faults.stream()
                .map(fault -> fault.kind().fileName() + (fault.kind().takesValue() ? "=" + fault.value() : ""))
                .collect(Collectors.joining(" "));
    }

    private static String motorFaults(List<MotorFault> faults) {
        return faults.stream()
                .map(fault -> fault.kind().fileName() + (fault.kind().takesValue() ? "=" + fault.value() : ""))
                .collect(Collectors.joining(" "));
    }

    private static TraceColumn word(String name, String meaning, Function<Simulation, String> text) {
        return new TraceColumn(name, "", meaning, (s, row) -> row.append(text.apply(s)));
    }

    /**
     * Returns a column of numbers, each in the shortest form that reads back to the same bits; one that does not apply
     * leaves the cell empty.
     */
    private static TraceColumn number(String name, String unit, String meaning, ToDoubleFunction<Simulation> value) {
        NumberText text = new NumberText();
        return new TraceColumn(name, unit, meaning, (s, row) -> {
            double number = value.applyAsDouble(s);
            if (Double.isFinite(number)) {
                text.append(number, row);
            }
        });
    }

    private static TraceColumn telemetry(String name, String unit, String meaning, ToDoubleFunction<Telemetry> value) {
        return number(name, unit, meaning, s -> value.applyAsDouble(s.telemetry()));
    }
}
