package faultline.engine.metrics;

import faultline.control.Telemetry;
import faultline.engine.Simulation;
import faultline.robot.MotorFault;
import faultline.robot.MotorFaults;
import java.util.List;
import java.util.stream.Collectors;

/** The cells that a trace of format 2 has of the controller and the motors; empty while they do not apply. */
final class ControllerCells implements TraceCells {

    private static final List<TraceColumn> COLUMNS = List.of(
            new TraceColumn("left_volts", "V", "what the controller gives the left motors"),
            new TraceColumn("right_volts", "V", "what the controller gives the right motors"),
            new TraceColumn("wanted_m", "m", "distance that the controller holds"),
            new TraceColumn("measured_m", "m", "distance that the controller goes by"),
            new TraceColumn("p_rad_s", "rad/s", "P term of the distance control"),
            new TraceColumn("d_rad_s", "rad/s", "D term of the distance control"),
            new TraceColumn("t_f3_s", "s", "time of frame F3 since the last spin began"),
            new TraceColumn("t_f4_s", "s", "time of frame F4 since the last spin began"),
            new TraceColumn("t_p_s", "s", "how long the robot turns back, eq. (4)"),
            new TraceColumn("rung", "", "strategy that drives, empty without a diagnosis"),
            new TraceColumn("left_motor_faults", "", "active faults of the left motors"),
            new TraceColumn("right_motor_faults", "", "active faults of the right motors"));

    private final NumberText leftVolts = new NumberText();
    private final NumberText rightVolts = new NumberText();
    private final NumberText wanted = new NumberText();
    private final NumberText measured = new NumberText();
    private final NumberText proportional = new NumberText();
    private final NumberText derivative = new NumberText();
    private final NumberText tF3 = new NumberText();
    private final NumberText tF4 = new NumberText();
    private final NumberText tP = new NumberText();
    private final WordText rung = new WordText();
    private final WordText leftFaults = new WordText();
    private final WordText rightFaults = new WordText();
    private MotorFaults faults = MotorFaults.NONE;
    private String leftText = "";
    private String rightText = "";

    @Override
    public List<TraceColumn> columns() {
        return COLUMNS;
    }

    @Override
    public void append(Simulation simulation, TraceBlock row) {
        leftVolts.appendCell(simulation.leftVolts(), row);
        rightVolts.appendCell(simulation.rightVolts(), row);
        Telemetry telemetry = simulation.telemetry();
        wanted.appendCell(telemetry.wall().wantedDistance(), row);
        measured.appendCell(telemetry.wall().measuredDistance(), row);
        proportional.appendCell(telemetry.wall().proportional(), row);
        derivative.appendCell(telemetry.wall().derivative(), row);
        tF3.appendCell(telemetry.edges().tF3(), row);
        tF4.appendCell(telemetry.edges().tF4(), row);
        tP.appendCell(telemetry.edges().tP(), row);
        rung.appendCell(telemetry.diagnosis().rung(), row);
        if (!simulation.motorFaults().equals(faults)) {
            faults = simulation.motorFaults();
            leftText = text(faults.left());
            rightText = text(faults.right());
        }
        leftFaults.appendCell(leftText, row);
        rightFaults.appendCell(rightText, row);
    }

    /** Returns faults as words, such as {@code weak=0.7 dead}. */
    private static String text(List<MotorFault> faults) {
        return faults.stream()
                .map(fault -> fault.kind().fileName() + (fault.kind().takesValue() ? "=" + fault.value() : ""))
                .collect(Collectors.joining(" "));
    }
}
