package faultline.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.geometry.Pose;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests what kinds of commands there are. */
class CommandTest {

    private static final Fault FAULT = new Fault.Dead();
    private static final MotorFault MOTOR_FAULT = new MotorFault.Weak(0.5);
    private static final Pose POSE = new Pose(1, 1, 0);

    private static final List<Command> OF_SETUP = List.of(
            new Command.ConfigureSensor(RobotSpec.DEFAULT.sensors().get(0)),
            new Command.MoveObstacle("post", POSE),
            new Command.PlaceObstacle(new Obstacle("post", new ObstacleShape.CircleShape(0.1), POSE)),
            new Command.RemoveObstacle("post"),
            new Command.SetPlatform(0.25, 0.2, 0.3),
            new Command.ConfigureController(new ControllerSpec.None()));

    private static final List<Command> OF_A_TIME = List.of(
            new Command.SwitchSensor("left", false),
            new Command.InjectFault("left", FAULT),
            new Command.ClearFault("left", FAULT),
            new Command.ClearFaults("left"),
            new Command.InjectMotorFault(MotorSide.LEFT, MOTOR_FAULT),
            new Command.ClearMotorFault(MotorSide.LEFT, MOTOR_FAULT),
            new Command.ClearMotorFaults(MotorSide.LEFT));

    @Test
    void settingsAndObstaclesBelongToTheSetupAndSwitchesAndFaultsToATime() {
        assertEquals(
                OF_SETUP,
                Stream.concat(OF_SETUP.stream(), OF_A_TIME.stream())
                        .filter(Command::changesSetup)
                        .toList());
    }
}
