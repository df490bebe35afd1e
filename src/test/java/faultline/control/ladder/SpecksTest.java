package faultline.control.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.control.ControllerSpec;
import faultline.control.SensorFinding;
import faultline.control.WallSide;
import faultline.engine.ControllerMode;
import faultline.engine.Simulation;
import faultline.engine.SimulationSetup;
import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.robot.RobotSpec;
import faultline.world.Obstacle;
import faultline.world.ObstacleShape;
import faultline.world.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests walls of single cells with gaps, as in floor plans, where readings of healthy sensors appear and disappear. */
class SpecksTest {

    private static final double CELL = 0.05;

    /** Returns an island with an outline of single cells with gaps. */
    private static Obstacle island(SplittableRandom random) {
        List<List<Vector2>> specks = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            for (int j = 0; j < 40; j++) {
                boolean outline = i == 0 || j == 0 || i == 39 || j == 39;
                if (outline && (i + j) % 2 == 0 && random.nextDouble() < 0.85) {
                    double x = i * CELL;
                    double y = j * CELL;
                    specks.add(List.of(
                            new Vector2(x, y),
                            new Vector2(x + CELL, y),
                            new Vector2(x + CELL, y + CELL),
                            new Vector2(x, y + CELL)));
                }
            }
        }
        return new Obstacle("specks", new ObstacleShape.PlanShape(specks), new Pose(2, 2, 0));
    }

    private static Simulation beside(long seed, WallSide side) {
        Pose start = side == WallSide.LEFT ? new Pose(3.6, 4.35, Math.PI) : new Pose(2.4, 4.35, 0);
        return new Simulation(
                new SimulationSetup(
                        new WorldSpec(6, 6, true, 3, List.of(island(new SplittableRandom(seed)))),
                        RobotSpec.DEFAULT,
                        start,
                        ControllerSpec.WallFollowing.DEFAULT.withSide(side),
                        List.of(),
                        0.01,
                        seed,
                        120),
                ControllerMode.DIRECT);
    }

    @ParameterizedTest
    @ValueSource(longs = {9101, 9102, 9103, 9104, 9105, 9106, 9107, 9108})
    void aHealthySensorIsNotFoundIntermittentOrNoisy(long seed) {
        for (WallSide side : WallSide.values()) {
            Simulation simulation = beside(seed, side);
            while (simulation.time() < 60 && simulation.collision().isEmpty()) {
                simulation.tick();
                simulation.telemetry().diagnosis().health().stream()
                        .filter(health -> health.finding() != SensorFinding.BLIND)
                        .forEach(health -> assertEquals(
                                SensorFinding.NONE,
                                health.finding(),
                                () -> side + " " + health + " at " + simulation.time()));
            }
            assertTrue(simulation.time() > 5, "the robot drove along the specks");
        }
    }

    /** A near speck beside the path does not make the front sensor blind, except where it may block the path. */
    @Test
    void aNearSpeckIsTakenForMissedRarelyAndOnlyForMoments() {
        int ticks = 0;
        int blind = 0;
        int doubts = 0;
        int contacts = 0;
        for (long seed = 9501; seed <= 9550; seed++) {
            for (WallSide side : WallSide.values()) {
                Simulation simulation = beside(seed, side);
                boolean before = false;
                while (simulation.time() < 60 && simulation.collision().isEmpty()) {
                    simulation.tick();
                    boolean now = simulation.telemetry().diagnosis().health().stream()
                            .anyMatch(health -> health.finding() == SensorFinding.BLIND);
                    ticks++;
                    blind += now ? 1 : 0;
                    doubts += now && !before ? 1 : 0;
                    before = now;
                }
                contacts += simulation.collision().isPresent() ? 1 : 0;
            }
        }
        assertTrue(doubts < 40, doubts + " findings in 100 runs");
        assertTrue(blind < ticks / 100, blind + " of " + ticks + " ticks");
        assertTrue(contacts <= 5, contacts + " contacts of 100 robots");
    }
}
