package faultline.gui.panel;

import faultline.geometry.Degrees;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.form.NumberSpinner;
import faultline.gui.form.WrappingGridLayout;
import faultline.gui.text.CachedDegrees;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.scenario.xml.ScenarioLimits;
import java.util.function.UnaryOperator;
import javax.swing.JPanel;

/** The robot's turn rate and motors. The run is simulated again with a change. */
final class DriveFields extends JPanel {

    private static final double MIN_VALUE = 0.001;
    private static final double MAX_SPEED_CONSTANT = 10;
    private static final double MAX_VOLTAGE = 1000;
    /** The decimals of both formats, so that a limit is not rounded up where it is shown. */
    private static final double SPEED_CONSTANT_STEPS = 1e5;

    private static final double VOLTAGE_STEPS = 1e3;

    private final transient ScenarioEditor editor;
    private final NumberSpinner turnRate = new NumberSpinner(
            "0.##", 1, 3600, 5, value -> change(robot -> robot.withTurnRate(Degrees.toRadians(value))));
    private final NumberSpinner timeConstant = new NumberSpinner(
            "0.000##",
            0,
            10,
            0.01,
            value -> changeMotor(old -> new MotorSpec(value, old.speedConstant(), old.maxVoltage())));
    private final NumberSpinner speedConstant = new NumberSpinner(
            "0.000##",
            MIN_VALUE,
            MAX_SPEED_CONSTANT,
            0.01,
            value -> changeMotor(old -> new MotorSpec(old.timeConstant(), value, old.maxVoltage())));
    private final NumberSpinner maxVoltage = new NumberSpinner(
            "0.0##",
            MIN_VALUE,
            MAX_VOLTAGE,
            0.5,
            value -> changeMotor(old -> new MotorSpec(old.timeConstant(), old.speedConstant(), value)));
    private final transient CachedDegrees shownTurnRate = new CachedDegrees();
    private transient RobotSpec robot = RobotSpec.DEFAULT;

    DriveFields(ScenarioEditor editor) {
        super(new WrappingGridLayout());
        this.editor = editor;
        ControllerForm.addRow(this, 0, "drive.turnRate", turnRate.withColumns(7));
        ControllerForm.addRow(this, 1, "drive.timeConstant", timeConstant.withColumns(7));
        ControllerForm.addRow(this, 2, "drive.speedConstant", speedConstant.withColumns(7));
        ControllerForm.addRow(this, 3, "drive.maxVoltage", maxVoltage.withColumns(7));
    }

    private void changeMotor(UnaryOperator<MotorSpec> change) {
        change(old -> old.withMotor(change.apply(old.motor())));
    }

    private void change(UnaryOperator<RobotSpec> change) {
        RobotSpec before = robot;
        RobotSpec after = change.apply(before);
        if (!after.equals(before)) {
            robot = after;
            setMotorLimits();
            editor.edit(
                    "edit.drive",
                    open -> open.withSetup(
                            open.setup().withRobot(withDriveOf(open.setup().robot(), after))),
                    open -> open.withSetup(
                            open.setup().withRobot(withDriveOf(open.setup().robot(), before))));
        }
    }

    private static RobotSpec withDriveOf(RobotSpec robot, RobotSpec other) {
        return robot.withTurnRate(other.turnRate()).withMotor(other.motor());
    }

    /** Limits each value of the motors so that, with the other one, a file can hold the speed of the wheels. */
    private void setMotorLimits() {
        DriveScale scale = robot.driveScale();
        double maxSpeed = Math.min(
                        ScenarioLimits.MAX_WHEEL_SPEED,
                        ScenarioLimits.MAX_SPIN_RATE * robot.track() * scale.track() / 2)
                / Math.max(scale.left(), scale.right());
        setMax(speedConstant, maxSpeed / robot.motor().maxVoltage(), MAX_SPEED_CONSTANT, SPEED_CONSTANT_STEPS);
        setMax(maxVoltage, maxSpeed / robot.motor().speedConstant(), MAX_VOLTAGE, VOLTAGE_STEPS);
    }

    private static void setMax(NumberSpinner field, double allowed, double usual, double steps) {
        double rounded = Math.floor(allowed * steps) / steps;
        field.setMax(Math.max(MIN_VALUE, Math.min(usual, rounded)));
    }

    /** Shows the current values. */
    void setRobot(RobotSpec current) {
        robot = current;
        setMotorLimits();
        turnRate.setWorldValue(shownTurnRate.toDegrees(current.turnRate()));
        timeConstant.setWorldValue(current.motor().timeConstant());
        speedConstant.setWorldValue(current.motor().speedConstant());
        maxVoltage.setWorldValue(current.motor().maxVoltage());
    }
}
