package faultline.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.Telemetry;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.sensor.Reading;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class ControllerFactoryTest {

    /** The standard robot at tick 0, with nothing in range of its sensors. */
    private static final Observation OBSERVATION = new Observation(0, 0.01, RobotSpec.DEFAULT, nothingInRange());

    private static double[] nothingInRange() {
        double[] readings = new double[RobotSpec.DEFAULT.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        return readings;
    }

    private static Decision first(ControllerSpec spec) {
        return ControllerFactory.create(spec).decide(OBSERVATION);
    }

    @Test
    void noneKeepsTheRobotInPlace() {
        assertEquals(
                new Decision(0, 0, Telemetry.ofState(ControllerState.of("NONE"))), first(new ControllerSpec.None()));
    }

    @Test
    void driveAppliesItsVoltages() {
        assertEquals(
                new Decision(2, -3, Telemetry.ofState(ControllerState.of("DRIVE"))),
                first(new ControllerSpec.Drive(2, -3)));
    }

    @Test
    void aWallFollowerStartsWithAStraightSearch() {
        Decision decision = first(WallFollowing.DEFAULT);
        assertEquals(FollowerState.SEARCH, decision.telemetry().state());
        assertEquals(3, decision.leftVolts(), 1e-12, "0.3 m/s at 0.1 m/s per volt");
        assertEquals(3, decision.rightVolts(), 1e-12);
    }

    @Test
    void everyControllerStartsInItsFirstState() {
        for (ControllerSpec spec :
                new ControllerSpec[] {new ControllerSpec.None(), new ControllerSpec.Drive(1, 1), WallFollowing.DEFAULT
                }) {
            assertEquals(
                    ControllerFactory.initialState(spec),
                    first(spec).telemetry().state());
        }
    }

    /** A controller from outside is given the robot that its observations contain, not the true drive. */
    @Test
    void aChosenControllerIsGivenTheRobotAsItBelievesItToBe() {
        List<RobotSpec> given = new ArrayList<>();
        ControllerSource source = new ControllerSource() {
            @Override
            public Controller start(RunConditions run) {
                given.add(run.robot());
                return observation -> {
                    given.add(observation.robot());
                    return Decision.ofVelocity(observation.robot(), Velocity.ZERO, "STAND", "");
                };
            }

            @Override
            public boolean limitsAnswerTime() {
                return true;
            }
        };
        SimulationSetup setup = SimulationSetup.of(new WorldSpec(4, 3, true, 3, List.of()), new Pose(2, 1.5, 0))
                .withRobot(RobotSpec.DEFAULT.withDriveScale(new DriveScale(1, 0.95, 1.05)))
                .withController(new ControllerSpec.Chosen(new ControllerSpec.None(), source));
        try (Simulation simulation = new Simulation(setup, ControllerMode.DIRECT)) {
            simulation.tick();
        }
        assertEquals(List.of(RobotSpec.DEFAULT, RobotSpec.DEFAULT), given.subList(0, 2));
    }
}
