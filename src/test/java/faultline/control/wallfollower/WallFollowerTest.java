package faultline.control.wallfollower;

import static faultline.control.FollowerState.SEARCH;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec.WallFollowing;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.Observation;
import faultline.control.Odometer;
import faultline.control.Telemetry;
import faultline.control.WallSide;
import faultline.robot.DriveScale;
import faultline.robot.RobotSpec;
import faultline.robot.Velocity;
import faultline.robot.WheelSpeeds;
import faultline.sensor.Reading;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The state diagram as a table, and the follower fed with readings at will. */
class WallFollowerTest {

    private static final Map<String, Double> NOTHING = Map.of();
    private static final Map<String, Double> WALL_BESIDE = Map.of("left", 0.25);
    private static final Map<String, Double> WALL_AHEAD = Map.of("front", 0.2);

    private final WallFollower follower = new WallFollower(WallFollowing.DEFAULT);
    private long tick;

    private Telemetry decide(Map<String, Double> readings) {
        return follower.decide(Observations.observation(tick++, readings)).telemetry();
    }

    private ControllerState decideFor(int ticks, Map<String, Double> readings) {
        ControllerState state = FollowerState.SEARCH;
        for (int i = 0; i < ticks; i++) {
            state = decide(readings).state();
        }
        return state;
    }

    /** Turns past a wall whose left reading falls and rises again, turns back and follows it. */
    private void runToFollow() {
        decide(WALL_AHEAD);
        for (int i = -50; decide(Map.of("left", 0.25 + 0.001 * Math.abs(i))).state() != FollowerState.ALIGN; i++) {
            assertTrue(i < 50, "the wall has not been left");
        }
        assertEquals(FollowerState.FOLLOW, decideFor(200, WALL_BESIDE));
    }

    // The table.

    @Test
    void everyStateCanBeReached() {
        Set<FollowerState> reached = EnumSet.of(SEARCH);
        for (FollowerState ignored : FollowerState.values()) {
            WallFollower.TRANSITIONS.stream()
                    .filter(arrow -> reached.contains(arrow.from()))
                    .forEach(arrow -> reached.add(arrow.to()));
        }
        assertEquals(EnumSet.allOf(FollowerState.class), reached);
    }

    @ParameterizedTest
    @EnumSource
    void everyStateCanBeLeft(FollowerState state) {
        assertTrue(WallFollower.TRANSITIONS.stream().anyMatch(arrow -> arrow.from() == state && arrow.to() != state));
    }

    @ParameterizedTest
    @EnumSource(names = {"TURN", "MEASURE", "ROUND"})
    void aStateThatWaitsForAWallGivesUpAfterTurningAllRound(FollowerState state) {
        assertTrue(WallFollower.TRANSITIONS.stream()
                .anyMatch(arrow -> arrow.from() == state
                        && arrow.to() == SEARCH
                        && arrow.condition().equals("turned all round")));
    }

    @ParameterizedTest
    @EnumSource
    void theConditionsOfAStateAreNamedAndDiffer(FollowerState state) {
        List<String> names = WallFollower.TRANSITIONS.stream()
                .filter(arrow -> arrow.from() == state)
                .map(Transition::condition)
                .toList();
        assertTrue(names.stream().noneMatch(String::isBlank));
        assertEquals(names.size(), Set.copyOf(names).size());
    }

    // What the table does.

    @Test
    void inTheOpenItSearchesStraightOn() {
        assertEquals(FollowerState.SEARCH, decideFor(5000, NOTHING));
    }

    @Test
    void ifTheLeftSensorNeverMeetsTheWallItSearchesAgain() {
        assertEquals(FollowerState.TURN, decide(WALL_AHEAD).state());
        assertEquals(FollowerState.TURN, decideFor(640, NOTHING), "after 384 degrees");
        assertEquals(FollowerState.SEARCH, decideFor(60, NOTHING), "after 420 degrees");
    }

    @Test
    void whereTheLeftSensorNeverLeavesTheWallItSearchesOn() {
        decide(WALL_AHEAD);
        decide(NOTHING);
        assertEquals(FollowerState.MEASURE, decide(WALL_BESIDE).state());
        assertEquals(FollowerState.MEASURE, decideFor(640, WALL_BESIDE), "after 384 degrees");
        Set<ControllerState> states = IntStream.range(0, 60)
                .mapToObj(i -> decide(WALL_BESIDE).state())
                .collect(Collectors.toSet());
        assertTrue(states.contains(FollowerState.SEARCH), "after 420 degrees");
    }

    @Test
    void whereAWallEndsAndNothingComesItSearchesOn() {
        runToFollow();
        assertEquals(FollowerState.ROUND, decide(NOTHING).state());
        assertEquals("wall ended", decide(NOTHING).condition());
        assertEquals(FollowerState.ROUND, decideFor(600, NOTHING));
        assertEquals(FollowerState.SEARCH, decideFor(100, NOTHING));
    }

    @Test
    void aWallAheadComesBeforeAWallThatEnds() {
        runToFollow();
        Telemetry telemetry = decide(WALL_AHEAD);
        assertEquals(FollowerState.TURN, telemetry.state());
        assertEquals("wall ahead", telemetry.condition());
    }

    @Test
    void aFarFrontCornerThatAWallComesNearToTurnsAsWell() {
        runToFollow();
        assertEquals(
                FollowerState.FOLLOW,
                decide(Map.of("left", 0.25, "front-right", 0.5)).state());
        assertEquals(
                FollowerState.TURN,
                decide(Map.of("left", 0.25, "front-right", 0.03)).state());
    }

    @Test
    void atMostOneTransitionIsMadeInADecision() {
        int before = 0;
        SplittableRandom random = new SplittableRandom(4);
        for (int i = 0; i < 40000; i++) {
            int now = decide(randomReadings(random)).transitions();
            assertTrue(now - before <= 1);
            before = now;
        }
        assertTrue(before > 100, "only " + before + " transitions");
    }

    private static Map<String, Double> randomReadings(SplittableRandom random) {
        return RobotSpec.DEFAULT.sensors().stream()
                .collect(Collectors.toMap(sensor -> sensor.id(), sensor -> switch (random.nextInt(8)) {
                    case 0 -> Reading.OFF;
                    case 1, 2, 3 -> Reading.NOTHING;
                    default -> random.nextDouble(0.8);
                }));
    }

    @Test
    void withAnySensorsOffItDrivesOnWithoutFailing() {
        for (int mask = 0; mask < 256; mask++) {
            WallFollower fresh = new WallFollower(WallFollowing.DEFAULT);
            SplittableRandom random = new SplittableRandom(mask);
            for (int i = 0; i < 100; i++) {
                Observation all = Observations.observation(i, randomReadings(random));
                Decision decision =
                        fresh.decide(new Observation(i, all.dt(), all.robot(), masked(all.readings(), mask)));
                assertTrue(Math.abs(decision.leftVolts()) <= 10 && Math.abs(decision.rightVolts()) <= 10);
            }
        }
    }

    private static double[] masked(double[] readings, int mask) {
        for (int i = 0; i < readings.length; i++) {
            readings[i] = (mask >> i & 1) == 0 ? Reading.OFF : readings[i];
        }
        return readings;
    }

    @Test
    void withoutAnySensorsItSearchesForEver() {
        RobotSpec blind = new RobotSpec(0.25, 0.2, 0.18, 0.3, 1, RobotSpec.DEFAULT.motor(), DriveScale.NONE, List.of());
        for (int i = 0; i < 2000; i++) {
            assertEquals(
                    FollowerState.SEARCH,
                    follower.decide(Observations.observation(i, blind, NOTHING))
                            .telemetry()
                            .state());
        }
    }

    @Test
    void withTheWallOnTheRightItIsItsOwnMirrorImage() {
        WallFollower right = new WallFollower(WallFollowing.DEFAULT.withSide(WallSide.RIGHT));
        SplittableRandom random = new SplittableRandom(9);
        for (int i = 0; i < 5000; i++) {
            Observation seen = Observations.observation(i, randomReadings(random));
            Decision one = follower.decide(seen);
            Decision other = right.decide(new Observation(i, seen.dt(), seen.robot(), mirrored(seen.readings())));
            assertEquals(List.of(one.leftVolts(), one.rightVolts()), List.of(other.rightVolts(), other.leftVolts()));
            assertEquals(one.telemetry(), other.telemetry());
        }
    }

    @ParameterizedTest
    @EnumSource(WallSide.class)
    void aFollowerThatBeginsInMotionKnowsTheSpeedsOfTheWheels(WallSide side) {
        Odometer odometer = new Odometer();
        WallFollower begun = new WallFollower(WallFollowing.DEFAULT.withSide(side), odometer);
        begun.begin(500, new WheelSpeeds(0.1, 0.3));
        begun.decide(Observations.observation(500, RobotSpec.DEFAULT, NOTHING));
        assertEquals(side.nearAndFar(new WheelSpeeds(0.1, 0.3)), odometer.wheels(), "no tick has passed since");
    }

    @Test
    void aCurveThatIsTooTightForTheTurnRateIsDrivenMoreSlowly() {
        assertEquals(new Velocity(0.5, -0.75), WallFollower.onCurve(0.5, -0.75, 1));
        assertEquals(new Velocity(0.25, -1), WallFollower.onCurve(0.5, -2, 1), "the radius is 0.25 m");
        assertEquals(new Velocity(0.3 * 0.5, 1), WallFollower.onCurve(0.5, 10, 1), "at least this share of the speed");
    }

    /** The standard sensors go round counter-clockwise from the front. */
    private static double[] mirrored(double[] readings) {
        double[] mirrored = new double[readings.length];
        for (int i = 0; i < readings.length; i++) {
            mirrored[i] = readings[(readings.length - i) % readings.length];
        }
        return mirrored;
    }
}
