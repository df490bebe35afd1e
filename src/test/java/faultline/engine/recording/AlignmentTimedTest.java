package faultline.engine.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import faultline.control.ControllerSpec;
import faultline.control.FollowerState;
import faultline.control.TimingRule;
import faultline.engine.Journal;
import faultline.engine.SimulationSetup;
import faultline.engine.session.Session;
import faultline.geometry.Pose;
import faultline.robot.DriveScale;
import faultline.robot.MotorFault;
import faultline.robot.MotorSide;
import faultline.world.Command;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * By the rule of the range, F3 and F4 are the last readings before MEASURE and ALIGN begin, however fast the robot
 * really turns.
 */
class AlignmentTimedTest {

    private final SimulationSetup room = SimulationSetup.of(new WorldSpec(6, 4, true, 0, List.of()), new Pose(5, 2, 0))
            .withController(ControllerSpec.WallFollowing.DEFAULT
                    .withTimingRule(TimingRule.RANGE)
                    .withDiagnosis(false));

    private static void assertTimesAreOfTheReadings(SimulationSetup setup) {
        long ticks = 1000;
        EventLog log;
        try (Session session = Session.replay(new Journal(setup, List.of(), ticks), ticks, reached -> true)) {
            log = session.frame().recording().events();
        }
        List<RunEvent> events = LongStream.range(log.firstIndex(), log.endIndex())
                .mapToObj(log::get)
                .toList();
        RunEvent.AlignmentTimed timed = events.stream()
                .filter(RunEvent.AlignmentTimed.class::isInstance)
                .map(RunEvent.AlignmentTimed.class::cast)
                .findFirst()
                .orElseThrow();
        assertEquals(arrival(events, FollowerState.MEASURE), timed.f3(), 2 * setup.dt());
        assertEquals(arrival(events, FollowerState.ALIGN), timed.f4(), 2 * setup.dt());
    }

    private static double arrival(List<RunEvent> events, FollowerState state) {
        return events.stream()
                .filter(event -> event instanceof RunEvent.StateChanged change && change.to() == state)
                .findFirst()
                .orElseThrow()
                .time();
    }

    @Test
    void withAPerfectDrive() {
        assertTimesAreOfTheReadings(room);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.6, 0.8})
    void withAWeakMotor(double share) {
        Command weak = new Command.InjectMotorFault(MotorSide.LEFT, new MotorFault.Weak(share));
        assertTimesAreOfTheReadings(room.withTimeline(List.of(new SimulationSetup.TimedCommand(2, weak))));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.8, 1.2})
    void withAnotherDistanceOfTheWheels(double scale) {
        assertTimesAreOfTheReadings(room.withRobot(room.robot().withDriveScale(new DriveScale(1, 1, scale))));
    }
}
