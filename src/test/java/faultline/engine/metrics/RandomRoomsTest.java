package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.WallSide;
import faultline.engine.metrics.WallFollowingRun.Conditions;
import faultline.geometry.Degrees;
import faultline.robot.DriveScale;
import faultline.robot.MotorSpec;
import faultline.robot.RobotSpec;
import faultline.sensor.SensorSpec;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.LongFunction;
import java.util.function.UnaryOperator;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The wall follower in rooms that it has never seen: no contact, all of the wall, at the distance, and without dawdling
 * in corners.
 */
class RandomRoomsTest {

    private static final RobotSpec ROBOT = RobotSpec.DEFAULT;

    /** The rooms in which the diagnosis took a sensor for faulty, though all are healthy. */
    private static final Set<PolygonRoom> FALSE_ALARMS = new HashSet<>();

    private static Stream<PolygonRoom> rooms() {
        RandomRooms fair = RandomRooms.FEASIBLE;
        RandomRooms cramped = fair.withMinStraight(0.2);
        return Stream.of(
                        rooms(1, 40, fair::star),
                        rooms(101, 8, cramped::rectilinear),
                        rooms(201, 8, cramped::zigzag),
                        rooms(301, 8, fair::island))
                .flatMap(some -> some);
    }

    private static Stream<PolygonRoom> rooms(long firstSeed, int count, LongFunction<PolygonRoom> maker) {
        return LongStream.range(firstSeed, firstSeed + count).mapToObj(maker);
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("rooms")
    void aRoomIsFollowedWithoutViolations(PolygonRoom room) {
        Conditions sixStatesAlone = Conditions.DEFAULT.with(WallFollowing.DEFAULT.withDiagnosis(false));
        assertEquals(List.of(), WallFollowingRun.simulate(room, sixStatesAlone).violations(), room::toString);
    }

    @ParameterizedTest(name = "{index}")
    @MethodSource("rooms")
    void aRoomIsFollowedWithDiagnosisToo(PolygonRoom room) {
        WallFollowingRun run = WallFollowingRun.simulate(room, Conditions.DEFAULT);
        List<String> violations = run.violations();
        if (run.leftFirstRung()) {
            FALSE_ALARMS.add(room);
            violations = run.violationsWithFalseAlarm();
        }
        assertEquals(List.of(), violations, room::toString);
    }

    @AfterAll
    static void falseAlarmsAreRare() {
        assertTrue(FALSE_ALARMS.size() <= 2, () -> "false alarms in " + FALSE_ALARMS.size() + " of 64 rooms");
    }

    private record Variant(String name, Conditions conditions) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static Stream<Variant> variants() {
        Conditions base = Conditions.DEFAULT;
        return Stream.of(
                new Variant("wall on the right", base.with(WallFollowing.DEFAULT.withSide(WallSide.RIGHT))),
                new Variant("control period of 20 ms", base.with(withPeriod(0.02))),
                new Variant("control period of 50 ms", base.with(withPeriod(0.05))),
                new Variant("ticks of 5 ms", base.withTick(0.005)),
                new Variant("ticks of 20 ms", base.withTick(0.02)),
                new Variant(
                        "0.15 m/s",
                        base.with(robotDriven(0.15, Degrees.toRadians(60), MotorSpec.DEFAULT))
                                .withDuration(480)),
                new Variant("0.5 m/s", base.with(robotDriven(0.5, Degrees.toRadians(90), MotorSpec.DEFAULT))),
                new Variant(
                        "motors without lag",
                        base.with(robotDriven(0.3, Degrees.toRadians(60), new MotorSpec(0, 0.1, 6)))),
                new Variant(
                        "motors that lag by 0.15 s",
                        base.with(robotDriven(0.3, Degrees.toRadians(60), new MotorSpec(0.15, 0.1, 6)))),
                new Variant(
                        "cones of 8 degrees", base.with(robotSensing(sensor -> sensor.withCone(Degrees.toRadians(8))))),
                new Variant(
                        "cones of 40 degrees",
                        base.with(robotSensing(sensor -> sensor.withCone(Degrees.toRadians(40))))),
                new Variant("range of 0.5 m", base.with(robotSensing(sensor -> sensor.withRange(0.5)))));
    }

    private static WallFollowing withPeriod(double seconds) {
        return WallFollowing.DEFAULT.withPeriod(seconds);
    }

    private static RobotSpec robotDriven(double speed, double turnRate, MotorSpec motor) {
        return new RobotSpec(
                ROBOT.length(), ROBOT.width(), ROBOT.track(), speed, turnRate, motor, DriveScale.NONE, ROBOT.sensors());
    }

    private static RobotSpec robotSensing(UnaryOperator<SensorSpec> change) {
        return new RobotSpec(
                ROBOT.length(),
                ROBOT.width(),
                ROBOT.track(),
                ROBOT.speed(),
                ROBOT.turnRate(),
                ROBOT.motor(),
                DriveScale.NONE,
                ROBOT.sensors().stream().map(change).toList());
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("variants")
    void otherRobotsFollowRoomsWithoutViolations(Variant variant) {
        rooms(401, 6, RandomRooms.FEASIBLE::star)
                .forEach(room -> assertEquals(
                        List.of(),
                        WallFollowingRun.simulate(room, variant.conditions()).violations(),
                        room::toString));
    }

    /** At these distances the followed wall is not much farther than the circle that the robot's corners describe. */
    @ParameterizedTest(name = "{0} m")
    @ValueSource(doubles = {0.12, 0.15})
    void aRobotNearItsWallGoesAllRound(double distance) {
        Conditions near = Conditions.DEFAULT.with(WallFollowing.DEFAULT.withDistance(distance));
        rooms(601, 10, RandomRooms.FEASIBLE::star)
                .forEach(room -> assertEquals(
                        List.of(), WallFollowingRun.simulate(room, near).violations(), room::toString));
    }

    private static RobotSpec noisyRobot(double metres) {
        return robotSensing(
                s -> new SensorSpec(s.id(), s.mountPosition(), s.bearing(), s.range(), s.cone(), s.on(), metres));
    }

    @ParameterizedTest(name = "noise of {0} m")
    @ValueSource(doubles = {0.002, 0.005})
    void noiseBringsNeitherContactNorGaps(double metres) {
        rooms(501, 10, RandomRooms.FEASIBLE::star)
                .forEach(room -> assertEquals(
                        List.of(),
                        WallFollowingRun.simulate(room, Conditions.DEFAULT.with(noisyRobot(metres)))
                                .safetyViolations(),
                        room::toString));
    }
}
