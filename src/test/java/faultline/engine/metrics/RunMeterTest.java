package faultline.engine.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.ControllerState;
import faultline.control.Decision;
import faultline.control.FollowerState;
import faultline.control.StateTracker;
import faultline.control.Telemetry;
import faultline.control.wallfollower.WallFollower;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.world.Command;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the measures during a run and at its end, in a room of 3.7 m by 2.9 m with a cupboard. */
class RunMeterTest {

    private static final double DURATION = 120;
    private static final Obstacle CUPBOARD =
            new Obstacle("cupboard", new ObstacleShape.RectangleShape(0.9, 0.4), new Pose(3.2, 2.68, 0));
    private static final SimulationSetup SETUP = SimulationSetup.of(
                    new WorldSpec(3.7, 2.9, true, 3, List.of(CUPBOARD)), new Pose(1.3, 1.1, 2))
            .withSeed(5150)
            .withDuration(DURATION);

    /** Starts the wall follower with a state of its own. */
    private static final ControllerSource OWN_STATE = new ControllerSource() {
        @Override
        public Controller start(RunConditions run) {
            WallFollower driver = new WallFollower(ControllerSpec.WallFollowing.DEFAULT);
            Controller named = observation -> {
                Decision decision = driver.decide(observation);
                Telemetry own = Telemetry.ofState(ControllerState.of("OWN"));
                return new Decision(decision.leftVolts(), decision.rightVolts(), own);
            };
            return new StateTracker(named, "mine");
        }

        @Override
        public boolean limitsAnswerTime() {
            return false;
        }
    };

    @Test
    void whatIsAskedForAtEveryTickEndsWithTheResultOfTheWholeRun() {
        RunMeter meter = new RunMeter(SETUP);
        RunMeasures last = RunMeasures.NONE;
        double previous = 0;
        try (Simulation simulation = new Simulation(SETUP, ControllerMode.DIRECT)) {
            meter.observe(simulation);
            while (simulation.ticks() < SETUP.ticks()) {
                simulation.tick();
                meter.observe(simulation);
                last = meter.measures();
                if (!Double.isNaN(last.laps())) {
                    assertTrue(last.laps() >= previous, "laps never become fewer");
                    previous = last.laps();
                }
            }
        }
        RunResult whole = HeadlessRun.run(SETUP, ControllerMode.DIRECT, List.of());
        assertEquals(whole.coverage().orElseThrow(), last.coverage());
        assertEquals(whole.distanceRms().orElseThrow(), last.distanceRms());
        assertTrue(last.followRms() > 0 && last.followRms() < 0.05, "of all walls: " + last.followRms());
    }

    @ParameterizedTest
    @CsvSource({"5200, 0.3", "4500, 0.5"})
    void inAWorldWithManyOrLongWallsTheCoverageIsKnownAtTheEnd(int walls, double length) {
        List<Vector2> zigzag = IntStream.rangeClosed(0, walls)
                .mapToObj(i -> new Vector2(i % 2 * length, i * 0.0003))
                .toList();
        // Near the robot, it would have millions of places.
        Obstacle wall = new Obstacle("zigzag", new ObstacleShape.WallShape(zigzag), new Pose(100, 1, 0));
        SimulationSetup many =
                SETUP.withWorld(new WorldSpec(3.7, 2.9, true, 3, List.of(wall))).withDuration(30);
        RunMeter meter = new RunMeter(many);
        try (Simulation simulation = new Simulation(many, ControllerMode.DIRECT)) {
            while (simulation.ticks() < many.ticks()) {
                assertTrue(Double.isNaN(meter.measures().coverage()));
                simulation.tick();
                meter.observe(simulation);
            }
        }
        RunResult whole = HeadlessRun.run(many, ControllerMode.DIRECT, List.of());
        assertEquals(whole.coverage().orElseThrow(), meter.measures().coverage());
    }

    /** The way along the walls is some 10 m long, and the robot drives at 0.3 m/s. */
    @Test
    void lapsAreHowOftenTheRobotWentRound() {
        RunMeter meter = new RunMeter(SETUP);
        HeadlessRun.run(SETUP, ControllerMode.DIRECT, List.of(meter));
        double laps = meter.measures().laps();
        assertTrue(laps > 2 && laps < 4, "laps: " + laps);
    }

    private static RunMeasures measures(SimulationSetup setup, SimulationSetup.TimedCommand... timeline) {
        RunMeter meter = new RunMeter(setup);
        HeadlessRun.run(setup.withTimeline(List.of(timeline)), ControllerMode.DIRECT, List.of(meter));
        return meter.measures();
    }

    private static SimulationSetup.TimedCommand follow(double time, double distance) {
        return new SimulationSetup.TimedCommand(
                time, new Command.ConfigureController(ControllerSpec.WallFollowing.DEFAULT.withDistance(distance)));
    }

    /** As if a command from the window had started it: the meter knows the setup without the timeline. */
    @Test
    void aWallFollowerThatStartsLateIsMeasuredFromThenOn() {
        SimulationSetup still = SETUP.withController(new ControllerSpec.None()).withDuration(200);
        RunMeasures late = measures(still, follow(80, ControllerSpec.WallFollowing.DEFAULT.distance()));
        RunMeasures whole = measures(SETUP);
        assertEquals(whole.coverage(), late.coverage(), 0.01);
        assertEquals(whole.laps(), late.laps(), 0.1);
        assertEquals(whole.followRms(), late.followRms(), 0.01);
    }

    /** Without the cupboard, because a robot so far from the wall cannot pass all places beside it. */
    @Test
    void lapsFollowAChangedDistanceAsTheCoverageDoes() {
        SimulationSetup room =
                SETUP.withWorld(new WorldSpec(5, 4, true, 3, List.of())).withDuration(150);
        RunMeasures changed = measures(room, follow(1, 0.6));
        assertTrue(changed.coverage() > 0.8, "coverage: " + changed.coverage());
        assertTrue(changed.laps() > 1.5, "laps: " + changed.laps());
    }

    /** A user draws the cupboard and sets the distance while the run is at 0 s. */
    @Test
    void whatIsEditedBeforeTheFirstTickIsMeasuredAsIfTheScenarioHadIt() {
        ControllerSpec.WallFollowing near = ControllerSpec.WallFollowing.DEFAULT.withDistance(0.3);
        SimulationSetup empty = SETUP.withWorld(SETUP.world().withObstacles(List.of()));
        RunMeter meter = new RunMeter(empty);
        try (Simulation simulation = new Simulation(empty, ControllerMode.DIRECT)) {
            meter.observe(simulation);
            simulation.execute(new Command.PlaceObstacle(CUPBOARD));
            simulation.execute(new Command.ConfigureController(near));
            while (simulation.ticks() < empty.ticks()) {
                simulation.tick();
                meter.observe(simulation);
            }
        }
        RunMeasures saved = measures(SETUP.withController(near));
        RunMeasures edited = meter.measures();
        assertEquals(saved.coverage(), edited.coverage());
        assertEquals(saved.laps(), edited.laps());
        // The controller has its settings one tick later.
        assertEquals(saved.distanceRms(), edited.distanceRms(), 1e-9);
        assertEquals(saved.followRms(), edited.followRms(), 1e-9);
    }

    /** A controller that is not part of the program follows from tick 0 on if its states are its own. */
    @Test
    void theStartOfAnEditedRunIsMeasuredToo() {
        SimulationSetup own = SETUP.withStart(new Pose(1.3, 2.3, 0.3))
                .withController(new ControllerSpec.Chosen(ControllerSpec.WallFollowing.DEFAULT, OWN_STATE))
                .withDuration(2);
        RunMeter meter = new RunMeter(own);
        try (Simulation simulation = new Simulation(own, ControllerMode.DIRECT)) {
            meter.observe(simulation);
            simulation.execute(new Command.RemoveObstacle("cupboard"));
            while (simulation.ticks() < own.ticks()) {
                simulation.tick();
                meter.observe(simulation);
            }
        }
        SimulationSetup.TimedCommand removal =
                new SimulationSetup.TimedCommand(own.dt(), new Command.RemoveObstacle("cupboard"));
        RunResult saved = HeadlessRun.run(own.withTimeline(List.of(removal)), ControllerMode.DIRECT, List.of());
        assertEquals(saved.distanceRms().orElseThrow(), meter.measures().distanceRms());
        assertEquals(saved.followRms().orElseThrow(), meter.measures().followRms());
        RunMeter whole = new RunMeter(own.withTimeline(List.of(removal)));
        HeadlessRun.run(own.withTimeline(List.of(removal)), ControllerMode.DIRECT, List.of(whole));
        assertEquals(whole.measures(), meter.measures(), "with the laps");
    }

    @Test
    void aRobotThatFollowsNoWallHasNoMeasures() {
        SimulationSetup still =
                SETUP.withController(new ControllerSpec.Drive(1, 1)).withDuration(1);
        RunMeter meter = new RunMeter(still);
        HeadlessRun.run(still, ControllerMode.DIRECT, List.of(meter));
        assertEquals(RunMeasures.NONE, meter.measures());
    }

    @Test
    void aPathThatIsTooLongHasNoLaps() {
        ControllerSpec.WallFollowing far = ControllerSpec.WallFollowing.DEFAULT.withDistance(100_000);
        SimulationSetup distant = SETUP.withController(far).withDuration(10);
        RunMeter meter = new RunMeter(distant);
        RunResult result = HeadlessRun.run(distant, ControllerMode.DIRECT, List.of(meter));
        assertNotEquals(List.of(FollowerState.SEARCH), result.visitedStates());
        assertTrue(Double.isNaN(meter.measures().laps()));
    }
}
