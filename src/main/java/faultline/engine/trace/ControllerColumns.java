package faultline.engine.trace;

import faultline.control.Telemetry;
import faultline.engine.Simulation;
import faultline.robot.MotorFaults;
import java.util.List;

/** The columns that a trace of format 2 has of the controller and the motors; empty while they do not apply. */
final class ControllerColumns implements ColumnGroup {

    private static final List<TraceColumn> COLUMNS = List.of(
            new TraceColumn("left_volts", "V", "output of the controller to the left motors"),
            new TraceColumn("right_volts", "V", "output of the controller to the right motors"),
            new TraceColumn("wanted_m", "m", "distance that the controller maintains"),
            new TraceColumn(
                    "measured_m", "m", "reading that it is measured by, or with a local map, the distance in the map"),
            new TraceColumn("p_rad_s", "rad/s", "P term of the distance control"),
            new TraceColumn("d_rad_s", "rad/s", "D term of the distance control"),
            new TraceColumn("t_f3_s", "s", "time of frame F3 since the last spin began"),
            new TraceColumn("t_f4_s", "s", "time of frame F4 since the last spin began"),
            new TraceColumn("t_p_s", "s", "how long the robot turns back, eq. (4)"),
            new TraceColumn("rung", "", "strategy that drives, empty without a diagnosis"),
            new TraceColumn("left_motor_faults", "", "active faults of the left motors"),
            new TraceColumn("right_motor_faults", "", "active faults of the right motors"));

    private MotorFaults faults = MotorFaults.NONE;
    private String leftText = "";
    private String rightText = "";

    @Override
    public List<TraceColumn> columns() {
        return COLUMNS;
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // The same object as long as nothing changes.
    public void append(Simulation simulation, TraceRows rows) {
        rows.append(simulation.leftVolts());
        rows.append(simulation.rightVolts());
        Telemetry telemetry = simulation.telemetry();
        rows.append(telemetry.wall().wantedDistance());
        rows.append(telemetry.wall().measuredDistance());
        rows.append(telemetry.wall().proportional());
        rows.append(telemetry.wall().derivative());
        rows.append(telemetry.edges().tF3());
        rows.append(telemetry.edges().tF4());
        rows.append(telemetry.edges().tP());
        rows.append(telemetry.diagnosis().rung());
        if (simulation.motorFaults() != faults) {
            faults = simulation.motorFaults();
            leftText = FaultCell.ofMotors(faults.left());
            rightText = FaultCell.ofMotors(faults.right());
        }
        rows.append(leftText);
        rows.append(rightText);
    }
}
