package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.SensorHealth;
import faultline.control.WallSide;
import faultline.control.diagnosis.SensorDiagnosis;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.geometry.Angles;
import faultline.geometry.Degrees;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.sensor.FaultKind;
import faultline.sensor.Reading;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Robots with more sensors than the diagnosis covers: it finds faults of those that it covers, and no others. */
class ManySensorsTest {

    private static final int STANDARD = RobotSpec.DEFAULT.sensors().size();

    /** Returns the standard robot with further sensors all around, up to a number of all. */
    private static RobotSpec robot(int count) {
        List<SensorSpec> sensors = new ArrayList<>(RobotSpec.DEFAULT.sensors());
        for (int i = STANDARD; i < count; i++) {
            double bearing = Angles.normalize(2 * StrictMath.PI * i / count);
            Vector2 place = new Vector2(0.1 * StrictMath.cos(bearing), 0.08 * StrictMath.sin(bearing));
            sensors.add(new SensorSpec(
                    "extra-" + i, place, bearing, SensorSpec.DEFAULT_RANGE, SensorSpec.DEFAULT_CONE, true, 0));
        }
        return RobotSpec.DEFAULT.withSensors(sensors);
    }

    private static SimulationSetup setup(RobotSpec robot, String faulty) {
        return SimulationSetup.of(new WorldSpec(5, 4, true, 3, List.of()), new Pose(1, 3.6, 0.02))
                .withRobot(robot)
                .withController(ControllerSpec.WallFollowing.DEFAULT.withDiagnosis(true))
                .withTimeline(List.of(
                        new TimedCommand(9, new Command.InjectFault(faulty, FaultKind.STUCK.createFault(0.31)))));
    }

    private static Simulation run(RobotSpec robot, String faulty) {
        return run(setup(robot, faulty));
    }

    private static Simulation run(SimulationSetup setup) {
        Simulation simulation = new Simulation(setup, ControllerMode.DIRECT);
        while (simulation.time() < 40) {
            simulation.tick();
        }
        return simulation;
    }

    private static List<String> distrusted(Simulation simulation) {
        return simulation.telemetry().diagnosis().health().stream()
                .filter(health -> !health.isTrusted())
                .map(SensorHealth::sensor)
                .toList();
    }

    @ParameterizedTest
    @ValueSource(ints = {31, 32, 33, 40, 64, 100})
    void aStuckSensorIsReplaced(int count) {
        Simulation simulation = run(robot(count), "left");
        assertEquals(List.of("left"), distrusted(simulation));
        assertEquals("REDUCED", simulation.telemetry().diagnosis().rung());
        assertTrue(simulation.collision().isEmpty());
    }

    @Test
    void aSensorBeyondTheLimitIsAlwaysTrusted() {
        RobotSpec robot = robot(SensorDiagnosis.MAX_SENSORS + 9);
        Simulation simulation = run(robot, "extra-" + SensorDiagnosis.MAX_SENSORS);
        assertEquals(List.of(), distrusted(simulation));
        assertEquals(
                robot.sensors().size(),
                simulation.telemetry().diagnosis().health().size());
        assertEquals("ALL", simulation.telemetry().diagnosis().rung());
    }

    /** Returns a robot whose standard sensors come after as many others, which look to the rear, as are diagnosed. */
    private static RobotSpec robotWithStandardSensorsLast() {
        List<SensorSpec> sensors = new ArrayList<>();
        for (int i = 0; i < SensorDiagnosis.MAX_SENSORS; i++) {
            double bearing = StrictMath.PI - 0.3 + 0.02 * i;
            sensors.add(new SensorSpec(
                    "extra-" + i,
                    new Vector2(-0.12, 0),
                    Angles.normalize(bearing),
                    SensorSpec.DEFAULT_RANGE,
                    SensorSpec.DEFAULT_CONE,
                    true,
                    0));
        }
        sensors.addAll(RobotSpec.DEFAULT.sensors());
        return RobotSpec.DEFAULT.withSensors(sensors);
    }

    @Test
    void withoutADistrustedSensorTheSixStatesUseThoseBeyondTheLimit() {
        Simulation simulation = run(robotWithStandardSensorsLast(), "extra-3");
        assertEquals(List.of("extra-3"), distrusted(simulation));
        assertEquals("REDUCED", simulation.telemetry().diagnosis().rung());
        assertEquals(FollowerState.FOLLOW, simulation.telemetry().state());
        assertTrue(simulation.collision().isEmpty());
    }

    @Test
    void aSensorBeyondTheLimitThatIsOffDoesNotServeARung() {
        RobotSpec robot = robotWithStandardSensorsLast();
        SimulationSetup setup = setup(robot, "extra-3")
                .withTimeline(List.of(
                        new TimedCommand(9, new Command.SwitchSensor("extra-3", false)),
                        new TimedCommand(9, new Command.SwitchSensor("left", false))));
        Simulation simulation = run(setup);
        assertEquals(List.of("extra-3"), distrusted(simulation));
        assertEquals("STOP", simulation.telemetry().diagnosis().rung());
    }

    /** The six states steer by {@code left}, so a sensor beside it that is diagnosed is not blamed. */
    @Test
    void aMisleadingSensorBeyondTheLimitIsTheOneThatIsSteeredByAndRemainsTrusted() {
        RobotSpec standardLast = robotWithStandardSensorsLast();
        SensorSpec beside = standardLast.sensors().get(0).withBearing(Degrees.toRadians(75));
        RobotSpec robot = standardLast.withSensor(beside);
        double[] readings = new double[robot.sensors().size()];
        Arrays.fill(readings, Reading.NOTHING);
        SensorDiagnosis diagnosis = new SensorDiagnosis(WallSide.LEFT);
        diagnosis.update(new Observation(0, 0.01, robot, readings), 0, 0, 1);
        int steering = Rung.facingWall(diagnosis).orElseThrow();
        assertEquals("left", robot.sensors().get(steering).id());
        diagnosis.distrustMisleading(steering);
        assertTrue(diagnosis.allTrusted());
        assertTrue(diagnosis.isTrusted(steering));
    }
}
