package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.campaign.RandomRoom;
import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.control.WallSide;
import faultline.engine.CommandListener;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.engine.SimulationSetup.TimedCommand;
import faultline.robot.RobotSpec;
import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import faultline.sensor.SensorSpec;
import faultline.world.Command;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** With the wall on the other side and mirrored readings, the follower decides as in a mirror, to the last bit. */
class MirroredFollowerTest {

    private final FaultTolerantFollower left = new FaultTolerantFollower(following(WallSide.LEFT));
    private final FaultTolerantFollower right = new FaultTolerantFollower(following(WallSide.RIGHT));

    private static WallFollowing following(WallSide side) {
        return WallFollowing.DEFAULT.withSide(side);
    }

    private Decision decideTwice(Observation seen) {
        Decision decision = left.decide(seen);
        Decision mirrored =
                right.decide(new Observation(seen.tick(), seen.dt(), seen.robot(), mirrored(seen.readings())));
        assertEquals(decision.leftVolts(), mirrored.rightVolts(), "at tick " + seen.tick());
        assertEquals(decision.rightVolts(), mirrored.leftVolts(), "at tick " + seen.tick());
        assertEquals(decision.telemetry().state(), mirrored.telemetry().state());
        assertEquals(
                decision.telemetry().diagnosis().rung(),
                mirrored.telemetry().diagnosis().rung());
        return decision;
    }

    /** The standard sensors go round counter-clockwise from the front. */
    private static double[] mirrored(double[] readings) {
        double[] mirrored = new double[readings.length];
        for (int i = 0; i < readings.length; i++) {
            mirrored[i] = readings[(readings.length - i) % readings.length];
        }
        return mirrored;
    }

    private void run(long room, Set<String> off, List<TimedCommand> timeline, String rung) {
        RandomRoom place = RandomRoom.ofSeed(room);
        List<SensorSpec> sensors = RobotSpec.DEFAULT.sensors().stream()
                .map(sensor -> sensor.withOn(!off.contains(sensor.id())))
                .toList();
        SimulationSetup setup = SimulationSetup.of(place.world(), place.start())
                .withRobot(RobotSpec.DEFAULT.withSensors(sensors))
                .withController(following(WallSide.LEFT))
                .withTimeline(timeline)
                .withSeed(room);
        boolean reached = false;
        try (Simulation simulation =
                new Simulation(setup, this::decideTwice, ControllerMode.DIRECT, CommandListener.NONE)) {
            while (simulation.time() < 90 && simulation.collision().isEmpty()) {
                simulation.tick();
                reached |= simulation.telemetry().diagnosis().rung().equals(rung);
            }
        }
        assertTrue(reached, "never on " + rung);
    }

    @ParameterizedTest
    @CsvSource({"94001,front left,THREE", "94002,front front-left left front-right,THREE", "94003,left,THREE"})
    void sensorsThatAreOffFromTheStart(long room, String off, String rung) {
        run(room, Set.of(off.split(" ")), List.of(), rung);
    }

    @ParameterizedTest
    @CsvSource({"94011,left,BIAS,0.12", "94012,front,STUCK,0.5", "94013,left,GHOST,0.3", "94014,front,BIAS,-0.1"})
    void sensorsThatFail(long room, String sensor, FaultKind kind, double value) {
        Fault fault = kind.createFault(value);
        run(room, Set.of(), List.of(new TimedCommand(10, new Command.InjectFault(sensor, fault))), "THREE");
    }
}
